#version 330 core
// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later

in vec2 along;
flat in float reach;
flat in vec4 strokeShape;
flat in vec4 strokeColour;

out vec4 colour;

const float headAspect = 0.8;  // arrowHeadAspect

// Signed distance to the shaft, a box that ends where the head begins.
float toShaft(float head)
{
    return max(abs(along.y) - 0.5 * strokeShape.x, max(-along.x, along.x - (reach - head)));
}

// Signed distance to the head, a triangle with its tip at the end.
float toHead(float head)
{
    vec2 slope = normalize(vec2(0.5 * headAspect, 1.0));
    float flank = dot(vec2(along.x - reach, abs(along.y)), slope);
    return max(flank, reach - head - along.x);
}

// Signed distance to the nearest dash.
float toDash(float on, float period)
{
    float x = mod(along.x, period);
    return x <= on ? max(-x, x - on) : min(x - on, period - x);
}

void main()
{
    float devicePixel = length(vec2(dFdx(along.y), dFdy(along.y)));
    float head = strokeShape.y;
    // Shaft and head share an edge: there the shaft goes on under the head.
    float outside = head > 0.0 ? min(toShaft(head - min(head, 1.0)), toHead(head)) : toShaft(0.0);
    if (strokeShape.z > 0.0)
        outside = max(outside, toDash(strokeShape.z, strokeShape.z + strokeShape.w));
    float covered = clamp(0.5 - outside / devicePixel, 0.0, 1.0);
    colour = vec4(strokeColour.rgb, 1.0) * (strokeColour.a * covered);
}
