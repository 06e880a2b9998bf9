// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/charts/chart_pane.h"
#include "views/charts/plot_curves.h"

namespace cradle {

/// The curves that a program plots over time with plot(name, number).
/// Its window title is the title of its tab, in the language.
class PlotsChart final : public ChartPane
{
    Q_OBJECT
public:
    PlotsChart(const Simulation &simulation, RunCurves &curves, QWidget *parent = nullptr);

protected:
    [[nodiscard]] bool readRun() override;
    [[nodiscard]] std::vector<ChartCurve> curves() const override;
    [[nodiscard]] double scale() const override;
    void retranslate() override;

private:
    PlotCurves m_plotted;
    bool m_isStale =
        false; ///< m_plotted is of a run that is over; it is drawn until the next frame
};

} // namespace cradle
