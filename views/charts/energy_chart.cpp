// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/energy_chart.h"

#include "views/charts/quiet_button.h"
#include "views/theme.h"

#include <QAction>
#include <QMenu>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr double totalWidth = 3.0; ///< px; another curve on top of it leaves an edge
/// Less than this part of the total is rounding, not loss.
constexpr double leastLoss = 1e-9;

} // namespace

EnergyChart::EnergyChart(const Simulation &simulation, RunCurves &curves, QWidget *parent)
    : ChartPane(simulation, curves, parent)
    , m_button(new QuietButton(this))
{
    auto *menu = new QMenu(m_button);
    for (int choice = 0; choice < ChoiceCount; ++choice) {
        auto *action = new QAction(this);
        action->setCheckable(true);
        action->setChecked(choice != Kinetic);
        connect(action, &QAction::toggled, this, [this] { selectionChanged(); });
        menu->addAction(action);
        m_actions[static_cast<std::size_t>(choice)] = action;
    }
    m_button->setMenu(menu);
    addSelector(m_button);
    EnergyChart::retranslate();
}

void EnergyChart::setShown(Choice choice, bool shown)
{
    m_actions[choice]->setChecked(shown);
}

bool EnergyChart::isShown(Choice choice) const
{
    return m_actions[choice]->isChecked();
}

void EnergyChart::retranslate()
{
    ChartPane::retranslate();
    setTexts(tr("Energy"), tr("J"), tr("Press Run to see the energy"));
    m_button->setText(tr("Curves"));
    m_button->setToolTip(tr("Choose the curves"));
    m_button->setAccessibleName(m_button->toolTip());
    m_actions[Total]->setText(tr("&Total"));
    m_actions[KineticOfEach]->setText(tr("Kinetic, &each circle"));
    m_actions[Kinetic]->setText(tr("&Kinetic, all circles"));
    m_actions[Potential]->setText(tr("&Potential"));
    m_actions[Dissipated]->setText(tr("&Dissipated in hits"));
    m_button->updateGeometry();
}

double EnergyChart::scale() const
{
    const RunCurves &run = runCurves();
    return std::max({run.sum().kinetic.maximum(), std::abs(run.potential().maximum()),
                     std::abs(run.potential().minimum()), std::abs(run.dissipated().maximum())});
}

std::vector<ChartCurve> EnergyChart::curves() const
{
    std::vector<ChartCurve> all;
    const Theme &colours = theme();
    const RunCurves &run = runCurves();
    const std::size_t count = run.circleCount();
    if (isShown(Total))
        all.push_back({.label = tr("total"),
                       .showsValue = true,
                       .colour = colours.text,
                       .width = totalWidth,
                       .samples = &run.total()});
    if (isShown(Kinetic) || (isShown(KineticOfEach) && count == 0))
        all.push_back({.label = tr("kinetic"),
                       .colour = colours.kinetic,
                       .width = 2.0,
                       .samples = &run.sum().kinetic});
    for (std::size_t i = 0; isShown(KineticOfEach) && i < count; ++i)
        all.push_back({.label = tr("kinetic %1").arg(i + 1),
                       .colour = colourOf(i),
                       .dash = circleDash(static_cast<int>(i)),
                       .samples = &run.circle(i).kinetic});
    if (isShown(Potential))
        all.push_back({.label = tr("potential"),
                       .colour = colours.potential,
                       .dash = Qt::DotLine,
                       .width = 2.0,
                       .samples = &run.potential()});
    const double lost =
        std::max(std::abs(run.dissipated().maximum()), std::abs(run.dissipated().minimum()));
    if (isShown(Dissipated) && lost > leastLoss * scale())
        all.push_back({.label = tr("dissipated"),
                       .showsValue = true,
                       .colour = colours.dissipated,
                       .dash = Qt::DashDotLine,
                       .samples = &run.dissipated()});
    return all;
}

} // namespace cradle
