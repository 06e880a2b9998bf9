// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/charts/chart_pane.h"

QT_BEGIN_NAMESPACE
class QAction;
QT_END_NAMESPACE

namespace cradle {

/// The energies of a run over time: kinetic, potential, total, and what hits dissipated.
class EnergyChart final : public ChartPane
{
    Q_OBJECT
public:
    EnergyChart(const Simulation &simulation, RunCurves &curves, QWidget *parent = nullptr);

    /// A curve or a set of curves that can be chosen.
    enum Choice { Total, KineticOfEach, Kinetic, Potential, Dissipated, ChoiceCount };
    void setShown(Choice choice, bool shown);
    [[nodiscard]] bool isShown(Choice choice) const;

protected:
    [[nodiscard]] std::vector<ChartCurve> curves() const override;
    [[nodiscard]] double scale() const override;
    void retranslate() override;

private:
    QuietButton *m_button;
    std::array<QAction *, ChoiceCount> m_actions{};
};

} // namespace cradle
