// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/plots_chart.h"

#include "views/theme.h"

namespace cradle {

namespace {

constexpr qsizetype longestLabel = 20; ///< characters of a name at its curve

QString labelOf(const QString &name)
{
    const QString line = name.simplified();
    return line.size() > longestLabel ? line.left(longestLabel - 1) + QChar(0x2026) : line;
}

} // namespace

PlotsChart::PlotsChart(const Simulation &simulation, RunCurves &curves, QWidget *parent)
    : ChartPane(simulation, curves, parent)
{
    connect(&simulation, &Simulation::restarted, this, [this] { m_isStale = true; });
    PlotsChart::retranslate();
}

void PlotsChart::retranslate()
{
    ChartPane::retranslate();
    setWindowTitle(tr("Plots"));
    setTexts(tr("Plots"), {}, tr("plot(name, number) in your program adds a curve here"));
}

bool PlotsChart::readRun()
{
    if (m_isStale)
        m_plotted.clear();
    m_isStale = false;
    m_plotted.update(simulation().notes());
    return ChartPane::readRun() && !m_plotted.curves().empty();
}

/// A program's curves have no unit in common: what is little in one may be all in another.
double PlotsChart::scale() const
{
    return 0.0;
}

std::vector<ChartCurve> PlotsChart::curves() const
{
    std::vector<ChartCurve> all;
    for (const PlotCurve &curve : m_plotted.curves()) {
        const int index = static_cast<int>(all.size());
        all.push_back({.label = labelOf(curve.name),
                       .showsValue = true,
                       .colour = plotColour(index),
                       .dash = circleDash(index),
                       .width = 2.0,
                       .samples = &curve.samples});
    }
    return all;
}

} // namespace cradle
