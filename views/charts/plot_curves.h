// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/program_notes.h"
#include "views/charts/min_max_pyramid.h"

#include <QColor>

#include <deque>

namespace cradle {

/// A curve that a program plots.
struct PlotCurve {
    QString name;
    MinMaxPyramid samples{};
};

/// The curves of a program's notes, ready to be drawn. Reads each point once.
class PlotCurves
{
public:
    void clear();
    /// Reads the points that are new.
    void update(const ProgramNotes &notes);

    /// In the order in which they came; each stays where it is until clear().
    [[nodiscard]] const std::deque<PlotCurve> &curves() const { return m_curves; }

private:
    /// How far a curve was read.
    struct Mark {
        std::size_t count = 0;
        double time = 0.0; ///< of the last point read, s
    };

    std::deque<PlotCurve> m_curves;
    std::deque<Mark> m_marks; ///< one to a curve
};

/// The colour of the plot \p index: none that circles are given, and with the dash of
/// circleDash() no two of thirty plots look the same.
[[nodiscard]] QColor plotColour(int index);

} // namespace cradle
