#version 330 core
// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later

in vec2 fromCentre;
flat in vec2 radiusAndWidth;
flat in vec4 fillColour;
flat in vec4 outlineColour;

out vec4 colour;

void main()
{
    // Signed distance to the edge; it covers a pixel as far as the edge runs through it.
    float devicePixel = fwidth(fromCentre.x);
    float outside = length(fromCentre) - radiusAndWidth.x;
    float inFill = clamp(0.5 - outside / devicePixel, 0.0, 1.0);
    float inOutline = radiusAndWidth.y > 0.0
        ? clamp(0.5 - (abs(outside) - 0.5 * radiusAndWidth.y) / devicePixel, 0.0, 1.0)
        : 0.0;

    vec4 under = vec4(fillColour.rgb, 1.0) * (fillColour.a * inFill);
    vec4 over = vec4(outlineColour.rgb, 1.0) * (outlineColour.a * inOutline);
    colour = over + under * (1.0 - over.a);
}
