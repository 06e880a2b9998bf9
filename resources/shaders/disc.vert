#version 330 core
// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A quad around each disc. Lengths are logical pixels, y down.
layout(location = 0) in vec4 place;   // centre x, y; radius; width of the outline
layout(location = 1) in vec4 fill;
layout(location = 2) in vec4 outline;

uniform vec2 viewport;

out vec2 fromCentre;
flat out vec2 radiusAndWidth;
flat out vec4 fillColour;
flat out vec4 outlineColour;

void main()
{
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
    fromCentre = corner * (place.z + 0.5 * place.w + 1.5);
    radiusAndWidth = place.zw;
    fillColour = fill;
    outlineColour = outline;
    vec2 position = (place.xy + fromCentre) / viewport * 2.0 - 1.0;
    gl_Position = vec4(position.x, -position.y, 0.0, 1.0);
}
