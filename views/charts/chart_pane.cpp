// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/chart_pane.h"

#include "views/charts/frame_throttle.h"
#include "views/charts/quiet_button.h"
#include "views/circle_name.h"
#include "views/theme.h"

#include <QButtonGroup>
#include <QEvent>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// The end of the time axis goes ahead by this part of the run, so that it need not move with
/// every frame.
constexpr double aheadPart = 1.0 / 16.0;

/// These parts of the last seconds are kept to the left and to the right of the moment shown.
constexpr double leastPast = 0.4;
constexpr double leastFuture = 0.2;

QuietButton *addChoice(QButtonGroup *group, QHBoxLayout *line)
{
    auto *button = new QuietButton;
    button->setCheckable(true);
    group->addButton(button);
    line->addWidget(button);
    return button;
}

} // namespace

ChartPane::ChartPane(const Simulation &simulation, RunCurves &curves, QWidget *parent)
    : QWidget(parent)
    , m_simulation(simulation)
    , m_curves(curves)
    , m_heading(new QLabel)
    , m_header(new QHBoxLayout)
    , m_plot(new ChartPlot)
    , m_throttle(new FrameThrottle(simulation, this))
{
    auto *group = new QButtonGroup(this);
    m_heading->setTextFormat(Qt::PlainText);
    m_heading->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_header->setContentsMargins(14, 8, 8, 0);
    m_header->setSpacing(0);
    m_header->addWidget(m_heading, 1);
    m_header->addSpacing(8);
    m_lastButton = addChoice(group, m_header);
    m_allButton = addChoice(group, m_header);
    m_allButton->setChecked(true);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(4);
    column->addLayout(m_header);
    column->addWidget(m_plot, 1);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);

    connect(m_lastButton, &QuietButton::clicked, this, [this] { setWindow(Window::LastSeconds); });
    connect(m_allButton, &QuietButton::clicked, this, [this] { setWindow(Window::All); });
    connect(m_plot, &ChartPlot::timePicked, this, &ChartPane::seekRequested);
    connect(m_plot, &ChartPlot::pickingEnded, m_throttle, &FrameThrottle::request);
    connect(m_throttle, &FrameThrottle::due, this, &ChartPane::redraw);
    connect(&simulation, &Simulation::restarted, this, [this] { m_range.reset(); });
    setHeadingFont();
    setKind(m_heading, "heading");
}

void ChartPane::setWindow(Window window)
{
    m_window = window;
    (window == Window::All ? m_allButton : m_lastButton)->setChecked(true);
    m_throttle->request();
}

void ChartPane::setTexts(const QString &heading, const QString &unit, const QString &empty)
{
    const QString capitals = heading.toUpper();
    m_heading->setText(unit.isEmpty() ? capitals
                                      : tr("%1 · %2", "heading · unit").arg(capitals, unit));
    m_plot->setAccessibleName(unit.isEmpty() ? tr("%1 over time").arg(heading)
                                             : tr("%1 over time, %2").arg(heading, unit));
    m_emptyText = empty;
}

void ChartPane::retranslate()
{
    m_lastButton->setText(tr("%1 s").arg(lastSeconds));
    m_lastButton->setToolTip(tr("Show the last %1 seconds").arg(lastSeconds));
    m_lastButton->setAccessibleName(m_lastButton->toolTip());
    m_allButton->setText(tr("all", "the whole run"));
    m_allButton->setToolTip(tr("Show the whole run"));
    m_allButton->setAccessibleName(m_allButton->toolTip());
}

void ChartPane::addSelector(QWidget *selector)
{
    m_header->insertWidget(m_header->count() - 2, selector);
    m_header->insertSpacing(m_header->count() - 2, 8);
    setTabOrder(selector, m_lastButton);
}

void ChartPane::selectionChanged()
{
    m_range.reset();
    m_throttle->request();
}

void ChartPane::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        m_throttle->request();
    } else if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        setHeadingFont();
        m_throttle->request();
    }
}

void ChartPane::setHeadingFont()
{
    QFont heading = headingFont();
    heading.setCapitalization(QFont::MixedCase); // a unit keeps its letters
    m_heading->setFont(heading);
}

QColor ChartPane::colourOf(std::size_t circle) const
{
    return circleColour(m_simulation.preset().circles[circle].colour);
}

QString ChartPane::nameOf(std::size_t circle) const
{
    const QString &name = m_simulation.preset().circles[circle].name;
    return shownCircleName(name.isEmpty() ? plainCircleName(circle + 1) : name);
}

bool ChartPane::readRun()
{
    m_curves.update();
    return m_simulation.recording().last() > 0;
}

void ChartPane::redraw()
{
    const Recording &recording = m_simulation.recording();
    if (!readRun()) {
        m_plot->showEmpty(m_emptyText);
        return;
    }
    const std::vector<ChartCurve> shown = curves();
    ChartMoment moment{.shown = m_simulation.time(), .scale = scale()};
    const MinMaxPyramid &whole = m_curves.total();
    chooseWindow(whole.firstTime(), whole.lastTime(), moment);
    fitRange(shown, moment);
    m_plot->showMoment(moment, shown, recording.hits());
    if (!m_simulation.isRunning()) {
        QStringList values;
        for (const auto &[text, place] : m_plot->labels())
            values.append(text);
        m_plot->setAccessibleDescription(values.join(QStringLiteral(", ")));
    }
}

void ChartPane::fitRange(const std::vector<ChartCurve> &shown, ChartMoment &moment)
{
    double low = 0.0;
    double high = shown.empty() ? moment.scale : 0.0;
    for (const ChartCurve &curve : shown) {
        const auto [least, greatest] = curve.samples->bounds(moment.from, moment.to);
        low = std::min(low, least);
        high = std::max(high, greatest);
    }
    m_range.fit(low, high, moment.scale);
    moment.range = m_range;
}

void ChartPane::chooseWindow(double first, double last, ChartMoment &moment)
{
    if (m_window == Window::All || last - first <= lastSeconds) {
        const double grain = niceStep(aheadPart * (last - first));
        moment.from = first;
        moment.to = std::max(std::ceil(last / grain - 1e-9) * grain, first + 1e-3);
        m_windowStart = last - lastSeconds;
        return;
    }
    // Moves no further than needed to hold the moment shown with what was before it and comes
    // after it, and not so far under a drag in the chart: that would run away.
    if (moment.shown == last)
        m_windowStart = last - lastSeconds;
    const double past = m_plot->isPicking() ? 0.0 : leastPast * lastSeconds;
    const double future = m_plot->isPicking() ? 0.0 : leastFuture * lastSeconds;
    m_windowStart =
        std::clamp(m_windowStart, moment.shown - lastSeconds + future, moment.shown - past);
    m_windowStart = std::clamp(m_windowStart, first, last - lastSeconds);
    moment.from = m_windowStart;
    moment.to = m_windowStart + lastSeconds;
}

} // namespace cradle
