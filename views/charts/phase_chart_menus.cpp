// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What PhaseChart draws, how near, and what leaves it.
#include "views/charts/phase_chart.h"

#include "model/world/shortest_number.h"
#include "views/charts/phase_plot.h"
#include "views/frame_throttle.h"
#include "views/menu.h"
#include "views/number_text.h"
#include "views/theme.h"

#include <QPainter>

#include <algorithm>

namespace cradle {

namespace {

constexpr int mostListed = 20;      ///< circles in a menu
constexpr qint64 playedSteps = 400; ///< of a curve that is heard

} // namespace

void PhaseChart::fillAxisMenu(Menu &menu, PhaseVariable &axis)
{
    const auto addChoice = [this, &axis](QMenu &to, const PhaseVariable &variable) {
        QAction *action =
            to.addAction(tr("%1 (%2)", "quantity, unit")
                             .arg(nameOf(variable.quantity), unitOf(variable.quantity)));
        action->setCheckable(true);
        action->setChecked(axis == variable);
        connect(action, &QAction::triggered, this, [this, &axis, variable] {
            axis = variable;
            m_isChosen = true;
            changed();
        });
    };
    addChoice(menu, {Quantity::Time, PhaseVariable::together});
    const auto addGroup = [&](const QString &title, int circle) {
        Menu *group = menu.addMenu(title);
        for (const Quantity quantity : quantitiesOfCircles)
            addChoice(*group, {quantity, circle});
    };
    const auto &circles = m_simulation.preset().circles;
    for (int i = 0; i < std::min(static_cast<int>(circles.size()), mostListed); ++i)
        addGroup(tr("Circle %1").arg(i + 1), i);
    addGroup(tr("All together"), PhaseVariable::together);
    if (circles.size() > 1)
        addChoice(menu, {Quantity::Distance, PhaseVariable::together});
    if (m_simulation.shadow()) {
        addChoice(menu, {Quantity::OffExact, PhaseVariable::together});
        addChoice(menu, {Quantity::EnergyExact, PhaseVariable::together});
    }
}

ChartPicture PhaseChart::picture()
{
    redraw(); // which may be due
    return {m_plot->size(), tr("%1 against %2").arg(textOf(m_up), textOf(m_across)),
            [plot = m_plot](QPainter &painter) {
                painter.fillRect(plot->rect(), theme().panel);
                plot->paint(painter);
            }};
}

QByteArray PhaseChart::table()
{
    const Recording &recording = m_simulation.recording();
    const auto header = [](const PhaseVariable &axis) {
        return csvCell(QStringLiteral("%1 (%2)").arg(textOf(axis), unitOf(axis.quantity)));
    };
    QByteArray rows =
        QStringLiteral("%1,%2,%3\n")
            .arg(header({Quantity::Time, PhaseVariable::together}), header(m_across), header(m_up))
            .toUtf8();
    const TimeWindow::Span span = spanShown();
    for (qint64 i = recording.first(); i <= recording.last(); ++i) {
        const double time = recording.time(i);
        const auto point = pointAt(i);
        if (point && time >= span.from && time <= span.to)
            rows += QStringLiteral("%1,%2,%3\n")
                        .arg(shortestNumber(time), shortestNumber(point->x()),
                             shortestNumber(point->y()))
                        .toUtf8();
    }
    return rows;
}

void PhaseChart::wirePlot()
{
    connect(m_plot, &Plot::picked, this, &PhaseChart::seekNear);
    connect(m_plot, &Plot::panned, this, &PhaseChart::panBy);
    connect(m_plot, &PhasePlot::playRequested, this, &PhaseChart::play);
    connect(m_plot, &Plot::boxChosen, this,
            [this](const ValueSpan &across, const std::optional<ValueSpan> &up) {
                if (up)
                    m_upZoom = up;
                if (isOverTime())
                    m_window->zoomTo({across.low, across.high}, whole());
                else if (up)
                    m_acrossZoom = across;
                m_throttle->request();
            });
}

/// Times are zoomed in all charts together and without the values, as in the others.
void PhaseChart::zoomBy(QPointF about, double factor, bool upOnly)
{
    if (isOverTime() && !upOnly) {
        m_window->zoomBy(factor, about.x(), timesShown(), whole());
        return;
    }
    const auto right = zoomed(m_plot->acrossSpan(), upOnly ? 1.0 : factor, about.x());
    const auto high = zoomed(m_plot->upSpan(), factor, about.y());
    if (!right || !high)
        return;
    m_upZoom = high;
    if (!upOnly)
        m_acrossZoom = right;
    m_throttle->request();
}

void PhaseChart::panBy(QPointF way)
{
    const auto moved = [](const ValueSpan &span, double by) {
        return ValueSpan{span.low + by, span.high + by};
    };
    if (!isOverTime()) {
        m_acrossZoom = moved(m_plot->acrossSpan(), way.x());
        m_upZoom = moved(m_plot->upSpan(), way.y());
    } else {
        if (m_upZoom)
            m_upZoom = moved(*m_upZoom, way.y());
        m_window->panBy(way.x(), timesShown(), whole());
    }
    m_throttle->request();
}

/// "Velocity upwards, circle 1: −3.2 m/s, Position y, circle 1: 0.4 m", at the moment shown.
QString PhaseChart::told() const
{
    const auto point = pointAt(m_simulation.current());
    if (!point)
        return {};
    const auto tell = [](const PhaseVariable &axis, double value) {
        const QString name = axis.isOfCircles() && axis.circle != PhaseVariable::together
                                 ? tr("%1, circle %2", "quantity, of")
                                       .arg(nameOf(axis.quantity))
                                       .arg(axis.circle + 1)
                                 : nameOf(axis.quantity);
        return tr("%1: %2 %3", "quantity, value, unit")
            .arg(name, shortNumber(value), unitOf(axis.quantity));
    };
    return tell(m_up, point->y()) + QStringLiteral(", ") + tell(m_across, point->x());
}

/// As far as the run has come, of the time that is shown.
void PhaseChart::play()
{
    const Recording &recording = m_simulation.recording();
    const TimeWindow::Span span = spanShown();
    const qint64 from = recording.indexAt(span.from);
    const qint64 to = recording.indexAt(std::min(span.to, recording.time(recording.last())));
    std::vector<double> values;
    for (qint64 i = 0; i < playedSteps; ++i) {
        if (const auto point = pointAt(from + (to - from) * i / (playedSteps - 1)))
            values.push_back(point->y());
    }
    if (to > from && !values.empty())
        emit curvePlayed(values);
}

TimeWindow::Span PhaseChart::spanShown() const
{
    const Recording &recording = m_simulation.recording();
    const double end = recording.time(recording.last());
    return m_window->choose({recording.time(recording.first()), end}, end, m_simulation.time());
}

TimeWindow::Span PhaseChart::timesShown() const
{
    return {m_plot->acrossSpan().low, m_plot->acrossSpan().high};
}

TimeWindow::Span PhaseChart::whole() const
{
    const Recording &recording = m_simulation.recording();
    return TimeWindow::whole(recording.time(recording.first()),
                             std::max(recording.time(recording.last()), pinnedEnd()));
}

QPointF PhaseChart::placeShown() const
{
    return pointAt(m_simulation.current()).value_or(QPointF());
}

bool PhaseChart::isZoomed() const
{
    return m_acrossZoom || m_upZoom
           || (isOverTime() && m_window->kind() == TimeWindow::Kind::Zoomed);
}

void PhaseChart::resetZoom()
{
    m_acrossZoom.reset();
    m_upZoom.reset();
    if (isOverTime())
        m_window->reset();
    m_throttle->request();
}

} // namespace cradle
