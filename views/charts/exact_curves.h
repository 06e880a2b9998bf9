// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/charts/min_max_pyramid.h"

namespace cradle {

class Simulation;

/// How far a run is from the exact motion beside it, over time; empty where none runs.
class ExactCurves
{
public:
    void reset() { *this = {}; }
    /// Reads the frames that are new, within \p maxBytes of memory.
    void update(const Simulation &simulation, qint64 maxBytes);

    /// The greatest distance of a circle from where it would be, m.
    [[nodiscard]] const MinMaxPyramid &distance() const { return m_distance; }
    /// Total energy more than in the exact motion, J.
    [[nodiscard]] const MinMaxPyramid &energy() const { return m_energy; }

private:
    MinMaxPyramid m_distance;
    MinMaxPyramid m_energy;
    qint64 m_nextFrame = 0;
};

} // namespace cradle
