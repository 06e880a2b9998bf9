// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Pinned runs in a ChartPane.
#include "views/charts/chart_pane.h"

#include "views/charts/pin_legend.h"
#include "views/theme.h"

namespace cradle {

namespace {

constexpr double paleness = 0.5; ///< of a kept run's curve: the part of the background in it

QColor pale(const QColor &colour)
{
    const QColor &panel = theme().panel;
    const auto mix = [](float a, float b) {
        return static_cast<float>((1.0 - paleness) * a + paleness * b);
    };
    const QColor mixed =
        QColor::fromRgbF(mix(colour.redF(), panel.redF()), mix(colour.greenF(), panel.greenF()),
                         mix(colour.blueF(), panel.blueF()));
    return visibleOn(mixed, panel);
}

} // namespace

std::vector<ChartCurve> ChartPane::curvesOf(const PinnedRun &) const
{
    return {};
}

/// Beneath the others, pale, each run with a dash of its own.
void ChartPane::addPinned(std::vector<ChartCurve> &shown) const
{
    if (!m_pins)
        return;
    std::vector<ChartCurve> all;
    for (const PinnedRun &run : m_pins->runs()) {
        for (ChartCurve curve : curvesOf(run)) {
            if (!curve.column.isEmpty())
                curve.column = tr("%1: %2", "kept run: curve").arg(run.name(), curve.column);
            curve.label = tr("%1: %2", "kept run: curve").arg(run.name(), curve.label);
            curve.isLabelled = false;
            curve.showsValue = false;
            curve.isFilled = false;
            curve.colour = pale(curve.colour);
            curve.dash = pinDash(run.number);
            curve.width = 1.5;
            curve.shift = run.branch;
            all.push_back(curve);
        }
    }
    shown.insert(shown.begin(), all.begin(), all.end());
}

void ChartPane::showLegend()
{
    std::vector<PinLegend::Line> lines;
    if (m_pins) {
        for (const PinnedRun &run : m_pins->runs()) {
            if (!curvesOf(run).empty())
                lines.push_back(
                    {run.text(m_pins->now()), run.details(m_pins->now()), pinDash(run.number)});
        }
    }
    m_legend->setLines(lines);
}

} // namespace cradle
