// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/program.h"

#include <deque>
#include <span>
#include <vector>

namespace cradle {

/// What a program has shown in a run: printed lines, curves, and the drawings of every step.
/// Bounded: of lines and drawings the oldest are dropped, of a long curve every other point.
class ProgramNotes
{
public:
    static constexpr std::size_t mostLines = 5000;
    static constexpr std::size_t mostCurves = 12;
    static constexpr std::size_t mostPoints = 200'000; ///< of one curve
    static constexpr std::size_t mostDrawings = 200'000;

    struct Line {
        qint64 step = 0; ///< that printed it; 0 while loading
        QString text;
    };
    struct Curve {
        QString name;
        std::vector<double> times{}; ///< s
        std::vector<double> values{};
    };

    void clear();
    /// Takes what the step that ends at \p time (s) has shown.
    void add(qint64 step, double time, const ProgramOutput &output);

    [[nodiscard]] const std::deque<Line> &lines() const { return m_lines; }
    [[nodiscard]] qint64 droppedLines() const { return m_droppedLines; }
    [[nodiscard]] const std::vector<Curve> &curves() const { return m_curves; }
    [[nodiscard]] std::span<const Drawing> drawings(qint64 step) const;

private:
    struct Sheet {
        qint64 step = 0;
        std::vector<Drawing> drawings;
    };

    void addText(qint64 step, const QString &text);
    void addPoint(double time, const PlottedPoint &point);

    std::deque<Line> m_lines;
    qint64 m_droppedLines = 0;
    std::vector<Curve> m_curves; ///< in the order in which they came
    std::deque<Sheet> m_sheets;  ///< by step
    std::size_t m_drawingCount = 0;
};

} // namespace cradle
