// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/charts/chart_pane.h"

QT_BEGIN_NAMESPACE
class QAction;
QT_END_NAMESPACE

namespace cradle {

/// The energies of a run over time: kinetic, potential, total, what hits dissipated, and what the
/// integrator or the program made. Where a few circles fall by different integrators, or by a
/// program, each has a total of its own. As stacked areas: kinetic (of each circle, if that is
/// chosen), potential and dissipated on top of each other.
class EnergyChart final : public ChartPane
{
    Q_OBJECT
public:
    EnergyChart(const Simulation &simulation, RunCurves &curves, QWidget *parent = nullptr);

    /// A curve or a set of curves that can be chosen.
    enum Choice {
        Total,
        TotalOfEach,
        KineticOfEach,
        Kinetic,
        Potential,
        Dissipated,
        ByIntegrator,
        OffExact, ///< more than the exact motion beside the run
        Stacked,  ///< areas instead of lines
        ChoiceCount
    };
    /// As the student's own choice: no preset changes it any more.
    void setShown(Choice choice, bool shown);
    [[nodiscard]] bool isShown(Choice choice) const;

protected:
    [[nodiscard]] std::vector<ChartCurve> curves() const override;
    [[nodiscard]] std::vector<ChartCurve> curvesOf(const PinnedRun &run) const override;
    [[nodiscard]] HitMeasure hitMeasure() const override;
    [[nodiscard]] QString hitQuantity() const override;
    [[nodiscard]] double scale() const override;
    [[nodiscard]] CurveGroups wanted() const override;
    void retranslate() override;

private:
    [[nodiscard]] std::vector<ChartCurve> lines(const CurveSet &run) const;
    [[nodiscard]] std::vector<ChartCurve> areas() const;
    [[nodiscard]] bool hasLost(const CurveSet &run) const;
    [[nodiscard]] bool makesEnergy(const CurveSet &run) const;
    void addTotals(std::vector<ChartCurve> &all, const CurveSet &run) const;
    void addKinetics(std::vector<ChartCurve> &all, const CurveSet &run) const;
    void addLosses(std::vector<ChartCurve> &all, const CurveSet &run) const;
    void showDefaults();
    void nameMade();

    QuietButton *m_button;
    std::array<QAction *, ChoiceCount> m_actions{};
    std::array<bool, ChoiceCount> m_isChosen{}; ///< by the student
};

} // namespace cradle
