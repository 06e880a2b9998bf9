// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/chart_pane.h"

#include "tasks/text/spoken_locale.h"
#include "views/charts/pin_legend.h"
#include "views/charts/quiet_button.h"
#include "views/circle_name.h"
#include "views/frame_throttle.h"
#include "views/theme.h"

#include <QButtonGroup>
#include <QEvent>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace cradle {

namespace {

/// \p title in as few lines of words as have room, where a word does; px.
QStringList linesOf(const QString &title, const QFontMetrics &metrics, int room)
{
    QStringList lines;
    for (const QString &word : title.split(QLatin1Char(' '))) {
        const QString longer = lines.isEmpty() ? word : lines.constLast() + QLatin1Char(' ') + word;
        if (lines.isEmpty() || metrics.horizontalAdvance(longer) > room)
            lines.append(word);
        else
            lines.last() = longer;
    }
    return lines;
}

} // namespace

ChartPane::ChartPane(const Simulation &simulation, RunCurves &curves, QWidget *parent)
    : ChartPane(simulation, curves, new ChartPlot, parent)
{
}

ChartPane::ChartPane(const Simulation &simulation, RunCurves &curves, ChartPlot *plot,
                     QWidget *parent)
    : PlotPane(simulation, plot, parent)
    , m_curves(curves)
    , m_legend(new PinLegend)
    , m_plot(plot)
{
    auto *group = new QButtonGroup(this);
    m_lastButton = addChoice(group);
    m_allButton = addChoice(group);
    m_allButton->setChecked(true);
    m_heading->installEventFilter(this);
    m_header->insertSpacing(1, 8);
    m_column->insertWidget(1, m_legend);
    setTabOrder(m_lastButton, m_allButton);
    setTabOrder(m_allButton, m_moreButton);
    setTabOrder(m_moreButton, m_plot);
    for (const auto &[button, kind] : {std::pair{m_lastButton, TimeWindow::Kind::LastSeconds},
                                       std::pair{m_allButton, TimeWindow::Kind::All}}) {
        connect(button, &QuietButton::clicked, this, [this, shown = kind] {
            m_valueZoom.reset();
            m_window->show(shown);
        });
    }
    connect(m_window, &TimeWindow::changed, this, &ChartPane::followWindow);
    connect(&simulation, &Simulation::restarted, this, [this] { m_range.reset(); });
    wirePlot();
    ChartPane::setHeadingFont();
}

QuietButton *ChartPane::addChoice(QButtonGroup *group)
{
    auto *button = new QuietButton;
    button->setCheckable(true);
    group->addButton(button);
    m_header->insertWidget(m_header->count() - 1, button);
    return button;
}

void ChartPane::share(TimeWindow &window, PinnedRuns &pins)
{
    PlotPane::share(window, pins);
    connect(m_window, &TimeWindow::changed, this, &ChartPane::followWindow);
    connect(m_pins, &PinnedRuns::changed, this, [this] {
        showLegend();
        selectionChanged();
    });
}

void ChartPane::followWindow()
{
    // With none checked the group is not exclusive for a moment: a zoom is neither.
    auto *group = m_allButton->group();
    group->setExclusive(false);
    m_allButton->setChecked(m_window->kind() == TimeWindow::Kind::All);
    m_lastButton->setChecked(m_window->kind() == TimeWindow::Kind::LastSeconds);
    group->setExclusive(true);
}

void ChartPane::setTexts(const QString &heading, const QString &unit, const QString &empty)
{
    const QString capitals = heading.toUpper();
    m_name = heading;
    m_unit = unit;
    m_title = unit.isEmpty() ? capitals : tr("%1 · %2", "heading · unit").arg(capitals, unit);
    fitHeading();
    m_plot->setAccessibleName(unit.isEmpty() ? tr("%1 over time").arg(heading)
                                             : tr("%1 over time, %2").arg(heading, unit));
    m_emptyText = empty;
}

void ChartPane::retranslate()
{
    PlotPane::retranslate();
    m_lastButton->setText(tr("%1 s").arg(TimeWindow::lastSeconds));
    m_lastButton->setToolTip(tr("Show the last %1 seconds").arg(TimeWindow::lastSeconds));
    m_lastButton->setAccessibleName(m_lastButton->toolTip());
    m_allButton->setText(tr("all", "the whole run"));
    m_allButton->setToolTip(tr("Show the whole run"));
    m_allButton->setAccessibleName(m_allButton->toolTip());
    showLegend();
}

void ChartPane::addSelector(QWidget *selector)
{
    m_header->insertWidget(m_header->count() - 3, selector);
    m_header->insertSpacing(m_header->count() - 3, 8);
    setTabOrder(selector, m_lastButton);
}

void ChartPane::selectionChanged()
{
    m_range.reset();
    m_throttle->request();
}

void ChartPane::setHeadingFont()
{
    QFont heading = headingFont();
    heading.setCapitalization(QFont::MixedCase); // a unit keeps its letters
    m_heading->setFont(heading);
    fitHeading();
}

/// On several lines where one has no room, as with large texts, and over the buttons where a word
/// has none beside them; a unit stays together.
void ChartPane::fitHeading()
{
    QString title = m_title;
    if (!m_unit.isEmpty())
        title.replace(m_unit, QString(m_unit).replace(QLatin1Char(' '), QChar::Nbsp));
    const QFontMetrics metrics = m_heading->fontMetrics();
    const int beside = width() - m_header->minimumSize().width();
    const QStringList lines = linesOf(title, metrics, beside);
    const bool isOver = std::any_of(lines.begin(), lines.end(), [&](const QString &line) {
        return metrics.horizontalAdvance(line) > beside;
    });
    putHeadingOver(isOver);
    const int over = width() - headingMargins.left() - headingMargins.right();
    const QStringList shown = isOver ? linesOf(title, metrics, over) : lines;
    m_heading->setText(shown.join(QLatin1Char('\n')));
}

void ChartPane::putHeadingOver(bool over)
{
    if (over == m_isHeadingOver)
        return;
    m_isHeadingOver = over;
    if (over) {
        m_header->removeWidget(m_heading);
        m_header->insertStretch(0, 1);
        m_column->insertWidget(0, m_heading);
    } else {
        m_column->removeWidget(m_heading);
        delete m_header->takeAt(0);
        m_header->insertWidget(0, m_heading, 1);
    }
    m_heading->setContentsMargins(over ? headingMargins : QMargins());
    m_header->setContentsMargins(over ? headingMargins - QMargins(0, headingMargins.top(), 0, 0)
                                      : headingMargins);
}

bool ChartPane::eventFilter(QObject *watched, QEvent *event)
{
    // Later: the header is about to place what stands in it.
    if (watched == m_heading && event->type() == QEvent::Resize)
        QMetaObject::invokeMethod(this, &ChartPane::fitHeading, Qt::QueuedConnection);
    return QWidget::eventFilter(watched, event);
}

QColor ChartPane::colourOf(std::size_t circle) const
{
    const auto &circles = m_simulation.preset().circles;
    return circle < circles.size() ? circleColour(circles[circle].colour) : theme().mutedText;
}

QString ChartPane::nameOf(std::size_t circle) const
{
    const auto &circles = m_simulation.preset().circles;
    const QString name = circle < circles.size() ? circles[circle].name : QString();
    return shownCircleName(name.isEmpty() ? plainCircleName(circle + 1) : name);
}

QString ChartPane::title() const
{
    return m_title;
}

bool ChartPane::readRun()
{
    m_curves.update();
    m_curves.want(this, wanted());
    return m_simulation.recording().last() > 0 || (m_pins && !m_pins->runs().empty());
}

void ChartPane::redraw()
{
    if (!readRun()) {
        m_plot->showEmpty(m_emptyText);
        return;
    }
    std::vector<ChartCurve> shown = curves();
    addPinned(shown);
    ChartMoment moment{.shown = m_simulation.time(), .scale = scale()};
    const MinMaxPyramid &run = m_curves.total();
    const TimeWindow::Span span =
        m_window->choose({run.firstTime(), run.lastTime()}, end(), moment.shown);
    moment.from = span.from;
    moment.to = span.to;
    moment.zoom = m_valueZoom;
    if (!m_simulation.isRunning())
        moment.note = hitNote();
    fitRange(shown, moment);
    m_plot->showMoment(moment, shown, m_simulation.recording());
    if (!m_simulation.isRunning())
        describe();
}

/// First the curve that the keys are at, then what is written in the chart.
void ChartPane::describe()
{
    QStringList values;
    if (const QString told = m_plot->told(); !told.isEmpty())
        values.append(told);
    for (const auto &[text, place] : m_plot->labels())
        values.append(text);
    if (m_plot->note())
        values.append(m_plot->note()->sentence());
    m_plot->setAccessibleDescription(spokenList(values));
}

std::optional<HitNote> ChartPane::hitNote() const
{
    const HitMeasure measure = hitMeasure();
    const Recording &recording = m_simulation.recording();
    auto note = measure ? noteOn(recording, m_simulation.current(), measure) : std::nullopt;
    if (!note)
        return std::nullopt;
    const auto shown = hitsShownAt(recording, m_simulation.current());
    const std::vector<std::size_t> circles =
        circlesOf(recording.hitOf(recording.encounters()[shown->first]));
    for (std::size_t i = 0; i < circles.size(); ++i) {
        note->rows[i].name = nameOf(circles[i]);
        note->rows[i].colour = colourOf(circles[i]);
    }
    note->unit = hitQuantity();
    return note;
}

void ChartPane::fitRange(const std::vector<ChartCurve> &shown, ChartMoment &moment)
{
    double low = 0.0;
    double high = shown.empty() ? moment.scale : 0.0;
    for (const ChartCurve &curve : shown) {
        if (curve.samples->isEmpty())
            continue;
        const auto [least, greatest] =
            curve.samples->bounds(moment.from + curve.shift, moment.to + curve.shift);
        low = std::min(low, least + curve.lift);
        high = std::max(high, greatest + curve.lift);
    }
    m_range.fit(low, high, moment.scale);
    moment.range = m_range;
}

double ChartPane::end() const
{
    return std::max(m_curves.total().lastTime(), m_pins ? m_pins->end() : 0.0);
}

TimeWindow::Span ChartPane::whole() const
{
    return TimeWindow::whole(m_curves.total().firstTime(), end());
}

} // namespace cradle
