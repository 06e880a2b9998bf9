// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/phase_chart.h"

#include "views/charts/phase_plot.h"
#include "views/charts/pinned_runs.h"
#include "views/charts/quiet_button.h"
#include "views/frame_throttle.h"
#include "views/menu.h"
#include "views/theme.h"

#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr double reach = 12.0;       ///< px from the curve that a click means it
constexpr double leastColumns = 160; ///< of pixels, before the plot has its size

bool isPlace(Quantity quantity)
{
    return quantity == Quantity::X || quantity == Quantity::Y;
}

} // namespace

PhaseChart::PhaseChart(const Simulation &simulation, QWidget *parent)
    : PhaseChart(simulation, new PhasePlot, parent)
{
}

PhaseChart::PhaseChart(const Simulation &simulation, PhasePlot *plot, QWidget *parent)
    : PlotPane(simulation, plot, parent)
    , m_against(new QLabel)
    , m_upButton(new QuietButton)
    , m_acrossButton(new QuietButton)
    , m_plot(plot)
{
    setKind(m_against, "muted");
    m_header->setSpacing(2);
    m_header->insertWidget(1, m_upButton);
    m_header->insertWidget(2, m_against);
    m_header->insertWidget(3, m_acrossButton);
    setTabOrder(m_upButton, m_acrossButton);
    setTabOrder(m_acrossButton, m_moreButton);
    setTabOrder(m_moreButton, m_plot);
    for (auto *button : {m_upButton, m_acrossButton}) {
        auto *menu = new Menu(button);
        PhaseVariable &axis = button == m_upButton ? m_up : m_across;
        connect(menu, &QMenu::aboutToShow, this, [this, menu, &axis] {
            qDeleteAll(menu->findChildren<Menu *>(Qt::FindDirectChildrenOnly));
            menu->clear();
            fillAxisMenu(*menu, axis);
        });
        button->setMenu(menu, true);
    }
    wirePlot();
    connect(&simulation, &Simulation::restarted, this, [this] {
        suggest();
        reset();
    });
    connect(&simulation, &Simulation::shadowChanged, this, &PhaseChart::reset);
    suggest();
    setHeadingFont();
    PhaseChart::retranslate();
}

void PhaseChart::setAxes(const PhaseVariable &up, const PhaseVariable &across)
{
    m_up = up;
    m_across = across;
    m_isChosen = true;
    changed();
}

/// Where something falls the vertical motion is the one to look at.
void PhaseChart::suggest()
{
    if (m_isChosen)
        return;
    const bool falls = m_simulation.preset().gravity.y != 0.0;
    m_up.quantity = falls ? Quantity::VelocityY : Quantity::VelocityX;
    m_across.quantity = falls ? Quantity::Y : Quantity::X;
    changed();
}

void PhaseChart::changed()
{
    m_upButton->setText(textOf(m_up));
    m_acrossButton->setText(textOf(m_across));
    m_upButton->setAccessibleName(tr("Vertical axis: %1").arg(nameOf(m_up.quantity)));
    m_acrossButton->setAccessibleName(tr("Horizontal axis: %1").arg(nameOf(m_across.quantity)));
    m_upButton->setToolTip(m_upButton->accessibleName());
    m_acrossButton->setToolTip(m_acrossButton->accessibleName());
    m_upButton->updateGeometry();
    m_acrossButton->updateGeometry();
    m_plot->setAccessibleName(
        tr("%1 against %2").arg(nameOf(m_up.quantity), nameOf(m_across.quantity)));
    m_plot->forgetRanges();
    m_acrossZoom.reset();
    m_upZoom.reset();
    reset();
}

void PhaseChart::reset()
{
    m_samples.clear();
    m_overTime.clear();
    m_nextFrame = 0;
    m_throttle->request();
}

std::optional<QPointF> PhaseChart::pointOf(const PhaseMoment &moment, const Preset &preset) const
{
    const auto x = valueOf(m_across, moment, preset);
    const auto y = valueOf(m_up, moment, preset);
    if (!x || !y || !std::isfinite(*x) || !std::isfinite(*y))
        return std::nullopt;
    return QPointF(*x, *y);
}

std::optional<QPointF> PhaseChart::pointAt(qint64 index) const
{
    const Recording &recording = m_simulation.recording();
    PhaseMoment moment{recording.time(index), recording.circles(index), {}};
    if (m_simulation.shadow())
        moment.exact = m_simulation.shadow()->circles(index);
    return pointOf(moment, m_simulation.preset());
}

void PhaseChart::read()
{
    const Recording &recording = m_simulation.recording();
    const qint64 oldest = isOverTime() ? 0 : recording.last() - mostSteps + 1;
    for (qint64 i = std::max({m_nextFrame, recording.first(), oldest}); i <= recording.last();
         ++i) {
        const auto point = pointAt(i);
        if (!point)
            continue;
        if (isOverTime())
            m_overTime.append(point->x(), point->y());
        else
            m_samples.push_back({recording.time(i), *point});
    }
    m_nextFrame = recording.last() + 1;
    while (static_cast<qint64>(m_samples.size()) > mostSteps)
        m_samples.pop_front();
    m_overTime.dropBefore(recording.time(recording.first()));
}

void PhaseChart::redraw()
{
    const Recording &recording = m_simulation.recording();
    read();
    if (recording.last() == 0 || (m_samples.empty() && m_overTime.isEmpty())) {
        m_plot->showEmpty(recording.last() == 0
                              ? tr("Press Run to see one quantity against another")
                              : tr("There is nothing to draw: choose other quantities"));
        return;
    }
    const double first = recording.time(recording.first());
    const double last = recording.time(recording.last());
    const TimeWindow::Span span =
        m_window->choose({first, last}, std::max(last, pinnedEnd()), m_simulation.time());
    PhasePicture picture;
    addPinned(picture, span.from, span.to);
    PlotLine curve{.pen = {colour(), 1.5, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin},
                   .isOverTime = isOverTime()};
    picture.up = m_upZoom;
    picture.across = m_acrossZoom;
    if (isOverTime()) {
        picture.across = ValueSpan{span.from, span.to};
        const double width = std::max<double>(m_plot->plotArea().width(), leastColumns);
        curve.points = m_overTime.decimate(span.from, span.to, static_cast<int>(width));
    }
    for (const Sample &sample : m_samples) {
        if (sample.time >= span.from && sample.time <= span.to)
            curve.points.append(sample.values);
    }
    picture.curves.push_back(curve);
    picture.moment = pointAt(m_simulation.current());
    picture.momentColour = theme().text;
    picture.told = told();
    if (!m_simulation.isRunning())
        m_plot->setAccessibleDescription(picture.told);
    picture.isEqual = isPlace(m_up.quantity) && isPlace(m_across.quantity);
    const auto axisText = [](const PhaseVariable &axis) {
        return tr("%1 in %2", "quantity, unit").arg(textOf(axis), unitOf(axis.quantity));
    };
    picture.upText = axisText(m_up);
    picture.acrossText = axisText(m_across);
    m_plot->showPicture(picture);
}

double PhaseChart::pinnedEnd() const
{
    return m_pins ? m_pins->end() : 0.0;
}

/// Pale and broken beneath.
void PhaseChart::addPinned(PhasePicture &picture, double from, double to) const
{
    if (!m_pins)
        return;
    for (const PinnedRun &run : m_pins->runs()) {
        PlotLine curve{.pen = {theme().mutedText, 1.0, pinDash(run.number)},
                       .isOverTime = isOverTime()};
        const Recording &recording = run.recording;
        const qint64 oldest = recording.last() - mostSteps + 1;
        for (qint64 i = std::max(recording.first(), oldest); i <= recording.last(); ++i) {
            const double time = recording.time(i) - run.branch;
            if (time < from || time > to)
                continue;
            if (const auto point = pointOf({time, recording.circles(i), {}}, run.source.preset))
                curve.points.append(*point);
        }
        if (!curve.points.isEmpty())
            picture.curves.push_back(curve);
    }
}

QColor PhaseChart::colour() const
{
    const auto &circles = m_simulation.preset().circles;
    const auto index = static_cast<std::size_t>(std::max(0, m_up.circle));
    const bool isOne = m_up.isOfCircles() && m_up.circle >= 0 && index < circles.size();
    return isOne ? circleColour(circles[index].colour) : theme().text;
}

void PhaseChart::seekNear(QPointF pixel)
{
    if (isOverTime()) {
        const ValueSpan times = m_plot->acrossSpan();
        emit seekRequested(std::clamp(m_plot->valuesAt(pixel).x(), times.low, times.high));
        return;
    }
    double least = reach;
    std::optional<double> nearest;
    for (const Sample &sample : m_samples) {
        const QPointF off = m_plot->placeOf(sample.values) - pixel;
        const double distance = std::hypot(off.x(), off.y());
        if (distance < least) {
            least = distance;
            nearest = sample.time;
        }
    }
    if (nearest)
        emit seekRequested(*nearest);
}

void PhaseChart::retranslate()
{
    PlotPane::retranslate();
    setWindowTitle(tr("Phase"));
    m_heading->setText(tr("Phase").toUpper());
    m_against->setText(tr("against"));
    changed();
}

} // namespace cradle
