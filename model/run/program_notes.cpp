// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/program_notes.h"

#include <QStringList>

#include <algorithm>

namespace cradle {

namespace {

void keepEveryOther(std::vector<double> &values)
{
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values.size(); i += 2)
        values[kept++] = values[i];
    values.resize(kept);
}

} // namespace

void ProgramNotes::clear()
{
    *this = {};
}

void ProgramNotes::add(qint64 step, double time, const ProgramOutput &output)
{
    addText(step, output.text);
    for (const PlottedPoint &point : output.points)
        addPoint(time, point);
    if (output.drawings.empty())
        return;
    m_sheets.push_back({step, output.drawings});
    m_drawingCount += output.drawings.size();
    while (m_drawingCount > mostDrawings && m_sheets.size() > 1) {
        m_drawingCount -= m_sheets.front().drawings.size();
        m_sheets.pop_front();
    }
}

void ProgramNotes::addText(qint64 step, const QString &text)
{
    if (text.isEmpty())
        return;
    QStringList lines = text.split(QLatin1Char('\n'));
    lines.removeLast(); // each line has its end
    for (const QString &line : std::as_const(lines)) {
        m_lines.push_back({step, line});
        if (m_lines.size() > mostLines) {
            m_lines.pop_front();
            ++m_droppedLines;
        }
    }
}

void ProgramNotes::addPoint(double time, const PlottedPoint &point)
{
    auto curve = std::find_if(m_curves.begin(), m_curves.end(),
                              [&](const Curve &c) { return c.name == point.name; });
    if (curve == m_curves.end()) {
        if (m_curves.size() == mostCurves)
            return;
        curve = m_curves.insert(m_curves.end(), {point.name, {}, {}});
    }
    curve->times.push_back(time);
    curve->values.push_back(point.value);
    if (curve->times.size() > mostPoints) {
        keepEveryOther(curve->times);
        keepEveryOther(curve->values);
    }
}

std::span<const Drawing> ProgramNotes::drawings(qint64 step) const
{
    const auto sheet = std::lower_bound(m_sheets.begin(), m_sheets.end(), step,
                                        [](const Sheet &s, qint64 k) { return s.step < k; });
    if (sheet == m_sheets.end() || sheet->step != step)
        return {};
    return sheet->drawings;
}

} // namespace cradle
