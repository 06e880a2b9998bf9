#version 330 core
// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A quad along each line or arrow. Lengths are logical pixels, y down.
layout(location = 0) in vec4 ends;   // from x, y; to x, y
layout(location = 1) in vec4 shape;  // width; length of the head, 0: none; dash on, off
layout(location = 2) in vec4 tint;

uniform vec2 viewport;

out vec2 along;          // x from the start towards the end, y across
flat out float reach;    // length of the stroke
flat out vec4 strokeShape;
flat out vec4 strokeColour;

const float headAspect = 0.8;  // arrowHeadAspect
const float margin = 1.5;      // room for the soft edge

void main()
{
    vec2 line = ends.zw - ends.xy;
    reach = length(line);
    vec2 forward = reach > 0.0 ? line / reach : vec2(1.0, 0.0);
    vec2 sideways = vec2(-forward.y, forward.x);
    float halfWidth = 0.5 * max(shape.x, shape.y * headAspect) + margin;
    along = vec2((gl_VertexID & 1) == 0 ? -margin : reach + margin,
                 (gl_VertexID & 2) == 0 ? -halfWidth : halfWidth);
    strokeShape = shape;
    strokeColour = tint;
    vec2 position = (ends.xy + forward * along.x + sideways * along.y) / viewport * 2.0 - 1.0;
    gl_Position = vec4(position.x, -position.y, 0.0, 1.0);
}
