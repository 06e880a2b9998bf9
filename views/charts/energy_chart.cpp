// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/energy_chart.h"

#include "views/charts/quiet_button.h"
#include "views/menu.h"
#include "views/theme.h"

#include <QAction>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr double totalWidth = 3.0; ///< px; another curve on top of it leaves an edge
/// Less than this part of the total is rounding, not loss.
constexpr double leastLoss = 1e-9;
/// With more circles their totals would be a tangle.
constexpr std::size_t mostCompared = 4;
constexpr std::size_t mostComparedByProgram = 3;

/// Whether the run is there to compare what becomes of the energy of circles that fall: by other
/// integrators, or by a program, which may move each in another way.
bool comparesCircles(const Simulation &simulation)
{
    const Preset &preset = simulation.preset();
    const auto &circles = preset.circles;
    if (circles.size() < 2 || circles.size() > mostCompared || preset.gravity == Vec2{})
        return false;
    if (simulation.isProgrammed())
        return circles.size() <= mostComparedByProgram;
    return std::any_of(circles.begin(), circles.end(), [&](const PresetCircle &circle) {
        return circle.integrator != circles.front().integrator;
    });
}

} // namespace

EnergyChart::EnergyChart(const Simulation &simulation, RunCurves &curves, QWidget *parent)
    : ChartPane(simulation, curves, parent)
    , m_button(new QuietButton(this))
{
    auto *menu = new Menu(m_button);
    for (int choice = 0; choice < ChoiceCount; ++choice) {
        auto *action = new QAction(this);
        action->setCheckable(true);
        connect(action, &QAction::toggled, this, [this] { selectionChanged(); });
        const auto index = static_cast<std::size_t>(choice);
        connect(action, &QAction::triggered, this, [this, index] { m_isChosen[index] = true; });
        menu->addAction(action);
        m_actions[index] = action;
    }
    menu->setToolTipsVisible(true);
    menu->insertSeparator(m_actions[Stacked]);
    connect(&simulation, &Simulation::restarted, this, &EnergyChart::showDefaults);
    connect(&simulation, &Simulation::shadowChanged, this, &EnergyChart::showDefaults);
    showDefaults();
    m_button->setMenu(menu);
    addSelector(m_button);
    EnergyChart::retranslate();
}

void EnergyChart::setShown(Choice choice, bool shown)
{
    m_isChosen[choice] = true;
    m_actions[choice]->setChecked(shown);
}

void EnergyChart::showDefaults()
{
    const bool compares = comparesCircles(simulation());
    const auto suggest = [this](Choice choice, bool shown) {
        if (!m_isChosen[choice])
            m_actions[choice]->setChecked(shown);
    };
    for (const Choice choice : {Total, Potential, Dissipated})
        suggest(choice, true);
    for (const Choice choice : {TotalOfEach, ByIntegrator})
        suggest(choice, compares);
    suggest(KineticOfEach, !compares);
    suggest(Kinetic, false);
    suggest(Stacked, false);
    suggest(OffExact, true);
    m_actions[OffExact]->setVisible(simulation().shadow() != nullptr);
    nameMade();
}

void EnergyChart::nameMade()
{
    QAction *action = m_actions[ByIntegrator];
    if (simulation().isProgrammed()) {
        action->setText(tr("By the pro&gram"));
        action->setToolTip(
            tr("Energy made by the program besides the hits, or lost if negative: total + "
               "dissipated in hits − total at the start."));
    } else {
        action->setText(tr("By the &integrator"));
        action->setToolTip(tr("Energy made by the integrator, or lost if negative: total + "
                              "dissipated in hits − total at the start. So start = total + "
                              "dissipated − made by the integrator."));
    }
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
    m_actions[TotalOfEach]->setText(tr("Total of e&ach"));
    m_actions[KineticOfEach]->setText(tr("Kinetic, &each circle"));
    m_actions[Kinetic]->setText(tr("&Kinetic, all circles"));
    m_actions[Potential]->setText(tr("&Potential"));
    m_actions[Dissipated]->setText(tr("&Dissipated in hits"));
    m_actions[Dissipated]->setToolTip(
        tr("Energy that circles lose in steps with a hit, and while they rest on something; "
           "negative if hits made energy, as going back to a higher place does"));
    m_actions[OffExact]->setText(tr("More than the e&xact motion"));
    m_actions[OffExact]->setToolTip(tr("Total energy of the run minus that of the exact motion "
                                       "beside it: the error of integrator and timestep"));
    m_actions[Stacked]->setText(tr("&Stacked areas"));
    m_actions[Stacked]->setToolTip(
        tr("Kinetic, potential and dissipated energy on top of each other"));
    nameMade();
    m_button->updateGeometry();
}

double EnergyChart::scale() const
{
    const RunCurves &run = runCurves();
    return std::max(run.energyScale(), std::abs(run.dissipated().maximum()));
}

CurveGroups EnergyChart::wanted() const
{
    const bool hasCircles = runCurves().circleCount() > 0;
    if (isShown(Stacked))
        return CurveGroups(CurveGroup::Made)
               | (isShown(KineticOfEach) && hasCircles ? CurveGroup::KineticUpTo
                                                       : CurveGroup::Kinetic);
    CurveGroups groups;
    groups.setFlag(CurveGroup::TotalOfEach, isShown(TotalOfEach));
    groups.setFlag(CurveGroup::KineticOfEach, isShown(KineticOfEach) && hasCircles);
    groups.setFlag(CurveGroup::Kinetic,
                   isShown(Kinetic) || (isShown(KineticOfEach) && !hasCircles));
    groups.setFlag(CurveGroup::Potential, isShown(Potential));
    groups.setFlag(CurveGroup::Made, isShown(ByIntegrator));
    return groups;
}

std::vector<ChartCurve> EnergyChart::curves() const
{
    std::vector<ChartCurve> all = isShown(Stacked) ? areas() : lines(runCurves().set());
    if (isShown(OffExact) && simulation().shadow())
        all.push_back({.label = tr("more than exact"),
                       .showsValue = true,
                       .colour = theme().across,
                       .dash = Qt::DashLine,
                       .width = 2.0,
                       .samples = &runCurves().exact().energy()});
    return all;
}

std::vector<ChartCurve> EnergyChart::curvesOf(const PinnedRun &run) const
{
    return lines(run.curves);
}

QString EnergyChart::hitQuantity() const
{
    return tr("kinetic %1", "unit").arg(unit());
}

HitMeasure EnergyChart::hitMeasure() const
{
    return [](std::span<const std::pair<double, Vec2>> bodies) {
        double kinetic = 0.0;
        for (const auto &[mass, velocity] : bodies)
            kinetic += 0.5 * mass * dot(velocity, velocity);
        return kinetic;
    };
}

/// Whether hits have taken, or given, more than rounding.
bool EnergyChart::hasLost(const CurveSet &run) const
{
    const double lost =
        std::max(std::abs(run.dissipated().maximum()), std::abs(run.dissipated().minimum()));
    return lost > leastLoss * scale();
}

/// Whether hits have made energy at some time: then what they took is not all dissipated.
bool EnergyChart::makesEnergy(const CurveSet &run) const
{
    return run.dissipated().minimum() < -leastLoss * scale();
}

/// From the floor upwards; the top is what the run began with and what was made since.
std::vector<ChartCurve> EnergyChart::areas() const
{
    const CurveSet &run = runCurves().set();
    std::vector<ChartCurve> all;
    const auto add = [&all](const QString &label, const QColor &colour,
                            const MinMaxPyramid &samples) {
        all.push_back({.label = label, .colour = colour, .samples = &samples, .isFilled = true});
    };
    if (isShown(KineticOfEach) && run.circleCount() > 0) {
        for (std::size_t i = 0; i < run.circleCount(); ++i)
            add(tr("kinetic %1").arg(i + 1), colourOf(i), run.circle(i).kineticUpTo);
    } else {
        add(tr("kinetic"), theme().kinetic, run.sum().kinetic);
    }
    add(tr("+ potential"), theme().potential, run.total());
    if (hasLost(run)) {
        add(tr("+ dissipated"), theme().dissipated, run.made());
        all.back().lift = run.startTotal();
    }
    return all;
}

std::vector<ChartCurve> EnergyChart::lines(const CurveSet &run) const
{
    std::vector<ChartCurve> all;
    addTotals(all, run);
    addKinetics(all, run);
    if (isShown(Potential))
        all.push_back({.label = tr("potential"),
                       .colour = theme().potential,
                       .dash = Qt::DotLine,
                       .width = 2.0,
                       .samples = &run.potential()});
    addLosses(all, run);
    return all;
}

void EnergyChart::addTotals(std::vector<ChartCurve> &all, const CurveSet &run) const
{
    if (isShown(Total))
        all.push_back({.label = tr("total"),
                       .showsValue = true,
                       .colour = theme().text,
                       .width = totalWidth,
                       .samples = &run.total()});
    for (std::size_t i = 0; isShown(TotalOfEach) && i < run.circleCount(); ++i)
        all.push_back({.label = tr("total %1").arg(i + 1),
                       .showsValue = true,
                       .colour = colourOf(i),
                       .dash = circleDash(static_cast<int>(i)),
                       .width = 2.0,
                       .samples = &run.circle(i).total});
}

void EnergyChart::addKinetics(std::vector<ChartCurve> &all, const CurveSet &run) const
{
    const std::size_t count = run.circleCount();
    if (isShown(Kinetic) || (isShown(KineticOfEach) && count == 0))
        all.push_back({.label = tr("kinetic"),
                       .colour = theme().kinetic,
                       .width = 2.0,
                       .samples = &run.sum().kinetic});
    for (std::size_t i = 0; isShown(KineticOfEach) && i < count; ++i)
        all.push_back({.label = tr("kinetic %1").arg(i + 1),
                       .colour = colourOf(i),
                       .dash = circleDash(static_cast<int>(i)),
                       .samples = &run.circle(i).kinetic});
}

void EnergyChart::addLosses(std::vector<ChartCurve> &all, const CurveSet &run) const
{
    if (isShown(Dissipated) && hasLost(run))
        all.push_back({.label = makesEnergy(run) ? tr("taken by hits") : tr("dissipated"),
                       .showsValue = true,
                       .colour = theme().dissipated,
                       .dash = Qt::DashDotLine,
                       .samples = &run.dissipated()});
    if (isShown(ByIntegrator))
        all.push_back(
            {.label = simulation().isProgrammed() ? tr("by the program") : tr("by the integrator"),
             .showsValue = true,
             .colour = theme().mutedText,
             .dash = Qt::DashDotDotLine,
             .samples = &run.made()});
}

} // namespace cradle
