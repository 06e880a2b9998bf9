// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/charts/chart_pane.h"

namespace cradle {

/// The momentum of each circle and of all over time: p_x, p_y or |p|.
class MomentumChart final : public ChartPane
{
    Q_OBJECT
public:
    MomentumChart(const Simulation &simulation, RunCurves &curves, QWidget *parent = nullptr);

    void setPart(MomentumPart part);
    [[nodiscard]] MomentumPart part() const { return m_part; }

protected:
    [[nodiscard]] std::vector<ChartCurve> curves() const override;
    [[nodiscard]] std::vector<ChartCurve> curvesOf(const PinnedRun &run) const override;
    [[nodiscard]] HitMeasure hitMeasure() const override;
    [[nodiscard]] QString hitQuantity() const override;
    [[nodiscard]] double scale() const override;
    [[nodiscard]] CurveGroups wanted() const override;
    void retranslate() override;

private:
    [[nodiscard]] std::vector<ChartCurve> curvesOf(const CurveSet &run) const;

    QWidget *m_selector;
    std::array<QuietButton *, 3> m_buttons{};
    MomentumPart m_part = MomentumPart::X;
};

} // namespace cradle
