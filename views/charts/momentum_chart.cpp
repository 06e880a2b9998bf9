// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/momentum_chart.h"

#include "views/boxes.h"
#include "views/charts/quiet_button.h"
#include "views/theme.h"

#include <QButtonGroup>

namespace cradle {

namespace {

constexpr double sumWidth = 3.0; ///< px; a circle's curve on top of it leaves an edge

std::size_t indexOf(MomentumPart part)
{
    return static_cast<std::size_t>(part);
}

QString symbolOf(MomentumPart part)
{
    switch (part) {
    case MomentumPart::X:
        return QStringLiteral("p_x");
    case MomentumPart::Y:
        return QStringLiteral("p_y");
    case MomentumPart::Length:
        break;
    }
    return QStringLiteral("|p|");
}

} // namespace

MomentumChart::MomentumChart(const Simulation &simulation, RunCurves &curves, QWidget *parent)
    : ChartPane(simulation, curves, parent)
    , m_selector(new QWidget(this))
{
    auto *line = layOutRow(m_selector, {}, 0);
    auto *group = new QButtonGroup(this);
    for (const MomentumPart part : {MomentumPart::X, MomentumPart::Y, MomentumPart::Length}) {
        auto *button = new QuietButton;
        button->setCheckable(true);
        button->setChecked(part == m_part);
        button->setText(symbolOf(part));
        group->addButton(button);
        line->addWidget(button);
        connect(button, &QuietButton::clicked, this, [this, part] { setPart(part); });
        m_buttons[indexOf(part)] = button;
    }
    addSelector(m_selector);
    MomentumChart::retranslate();
}

void MomentumChart::setPart(MomentumPart part)
{
    m_part = part;
    m_buttons[indexOf(part)]->setChecked(true);
    selectionChanged();
}

void MomentumChart::retranslate()
{
    ChartPane::retranslate();
    setTexts(tr("Momentum"), tr("kg m/s"), tr("Press Run to see the momentum"));
    const std::array<QString, 3> names{tr("Momentum to the right"), tr("Momentum upwards"),
                                       tr("Size of the momentum")};
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        m_buttons[i]->setToolTip(names[i]);
        m_buttons[i]->setAccessibleName(names[i]);
    }
    m_selector->setAccessibleName(tr("Part of the momentum"));
}

double MomentumChart::scale() const
{
    return runCurves().momentumScale();
}

CurveGroups MomentumChart::wanted() const
{
    switch (m_part) {
    case MomentumPart::X:
        return CurveGroup::MomentumX;
    case MomentumPart::Y:
        return CurveGroup::MomentumY;
    case MomentumPart::Length:
        break;
    }
    return CurveGroup::MomentumLength;
}

std::vector<ChartCurve> MomentumChart::curves() const
{
    return curvesOf(runCurves().set());
}

std::vector<ChartCurve> MomentumChart::curvesOf(const PinnedRun &run) const
{
    return curvesOf(run.curves);
}

std::vector<ChartCurve> MomentumChart::curvesOf(const CurveSet &run) const
{
    std::vector<ChartCurve> all;
    // Of a single circle the sum is the same again.
    if (run.circleCount() != 1)
        all.push_back({.label = tr("sum %1").arg(symbolOf(m_part)),
                       .showsValue = true,
                       .colour = theme().text,
                       .width = run.circleCount() == 0 ? 2.0 : sumWidth,
                       .samples = &run.sum().momentum[indexOf(m_part)]});
    for (std::size_t i = 0; i < run.circleCount(); ++i)
        all.push_back({.label = nameOf(i),
                       .column = QStringLiteral("%1 %2").arg(nameOf(i), symbolOf(m_part)),
                       .showsValue = run.circleCount() == 1,
                       .colour = colourOf(i),
                       .dash = circleDash(static_cast<int>(i)),
                       .samples = &run.circle(i).momentum[indexOf(m_part)]});
    return all;
}

QString MomentumChart::hitQuantity() const
{
    return QStringLiteral("%1 %2").arg(symbolOf(m_part), unit());
}

HitMeasure MomentumChart::hitMeasure() const
{
    return [part = m_part](std::span<const std::pair<double, Vec2>> bodies) {
        Vec2 momentum;
        for (const auto &[mass, velocity] : bodies)
            momentum += mass * velocity;
        return part == MomentumPart::X   ? momentum.x
               : part == MomentumPart::Y ? momentum.y
                                         : length(momentum);
    };
}

} // namespace cradle
