// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/speed_histogram.h"

#include "views/boxes.h"
#include "views/charts/nice_scale.h"
#include "views/charts/speed_plot.h"
#include "views/frame_throttle.h"
#include "views/number_text.h"
#include "views/sentence_label.h"
#include "views/theme.h"

#include <QEvent>
#include <QLabel>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr double binsPerSpread = 8.0; ///< at most
/// The axis ends here, in units of the curve's σ: three circles of 10,000 are faster.
constexpr double widestSpread = 4.0;
/// Moments that go into the mean; neighbouring steps are almost the same.
constexpr qint64 mostMoments = 15;
/// ms from one sentence to the next while the run goes on: nobody reads faster.
constexpr int sentenceInterval = 250;
/// The part of the pane's height that the sentence may take.
constexpr double sentencePart = 0.25;

} // namespace

SpeedHistogram::SpeedHistogram(const Simulation &simulation, QWidget *parent)
    : QWidget(parent)
    , m_simulation(simulation)
    , m_heading(new QLabel)
    , m_plot(new SpeedPlot)
    , m_sentence(new SentenceLabel)
    , m_throttle(new FrameThrottle(simulation, this))
{
    m_heading->setTextFormat(Qt::PlainText);
    m_heading->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_heading->setContentsMargins(14, 8, 8, 0);
    layOutColumn(this, {}, 0, {m_heading, {m_plot, 1}, m_sentence});
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    connect(m_throttle, &FrameThrottle::due, this, &SpeedHistogram::redraw);
    connect(m_plot, &Plot::toldChanged, this, &SpeedHistogram::describe);
    connect(m_plot, &Plot::played, this, &SpeedHistogram::curvePlayed);
    connect(m_plot, &Plot::resized, this, &SpeedHistogram::redraw);
    setHeadingFont();
    setKind(m_heading, "heading");
    setKind(m_sentence, "muted");
    retranslate();
}

std::span<const Circle> SpeedHistogram::circles() const
{
    return m_simulation.recording().circles(m_simulation.current());
}

void SpeedHistogram::redraw()
{
    const std::size_t count = circles().size();
    const GasState gas = gasState(circles());
    const bool isGas = count >= fewestCircles && gas.spread() > 0.0;
    m_sentence->setVisible(isGas);
    if (isGas) {
        showDistribution(gas);
    } else if (count < fewestCircles) {
        m_heading->setText(tr("Speeds").toUpper());
        m_plot->showEmpty(tr("A distribution of speeds takes %1 circles or more: Lab → Example "
                             "scenes → Gas has 1000")
                              .arg(fewestCircles));
    } else {
        m_heading->setText(tr("Speeds").toUpper());
        m_plot->showEmpty(tr("Nothing moves yet: press Run"));
    }
    if (!m_simulation.isRunning())
        describe();
}

/// First the bar that the keys are at, then how far all are from equilibrium.
void SpeedHistogram::describe()
{
    const QString whole = m_plot->showsRun() ? sentence() : m_plot->emptyText();
    const QString told = m_plot->showsRun() ? m_plot->told() : QString();
    m_plot->setAccessibleDescription(told.isEmpty() ? whole : told + QStringLiteral(". ") + whole);
}

/// Bins that rest while the temperature changes a little: their width is a round number.
SpeedBins SpeedHistogram::binsOf(const GasState &gas) const
{
    const double width = niceStep(gas.spread() / binsPerSpread);
    SpeedBins bins(width, static_cast<std::size_t>(std::ceil(widestSpread * gas.spread() / width)));
    const Recording &recording = m_simulation.recording();
    const qint64 last = m_simulation.current();
    const qint64 first = recording.indexAt(recording.time(last) - meanSeconds);
    // Moments at multiples of the stride, so that the same ones stay in while the run goes on.
    const qint64 stride = std::max<qint64>(1, (last - first) / mostMoments);
    for (qint64 i = (first + stride - 1) / stride * stride; i < last; i += stride)
        bins.add(recording.circles(i), gas);
    bins.add(circles(), gas);
    return bins;
}

void SpeedHistogram::showDistribution(const GasState &gas)
{
    const SpeedBins bins = binsOf(gas);
    const QString name = tr("Speeds").toUpper();
    const QString heat = shortNumber(gas.temperature);
    m_heading->setText(gas.isMixed ? tr("%1 · v √(m/m̄) · kT = %2 J").arg(name, heat)
                                   : tr("%1 · kT = %2 J").arg(name, heat));
    m_plot->showPicture(
        {.binWidth = bins.width(),
         .shares = bins.shares(),
         .shareBeyond = bins.shareBeyond(),
         .spread = gas.spread(),
         .barsText =
             tr("share per %1 m/s, mean of 1 s").arg(tickNumber(bins.width(), bins.width())),
         .curveText = tr("Maxwell–Boltzmann")});
    const bool rests = m_simulation.isRunning() && m_sinceSentence.isValid()
                       && m_sinceSentence.elapsed() < sentenceInterval;
    if (rests)
        return;
    m_sentence->setSentence(sentence());
    m_sinceSentence.start();
}

QString SpeedHistogram::sentence() const
{
    const double distance = distanceFromMaxwell(circles());
    const double limit = distanceByChance(circles().size());
    const auto text = [](double value) { return QString::number(value, 'f', 3); };
    const QString told =
        distance <= limit ? tr("In equilibrium: distance from the curve %1, chance allows %2.")
                          : tr("Not in equilibrium: distance from the curve %1, chance allows %2.");
    return told.arg(text(distance), text(limit));
}

void SpeedHistogram::retranslate()
{
    setWindowTitle(tr("Speeds"));
    m_plot->setAccessibleName(tr("Histogram of the speeds, m/s"));
    m_sentence->setAccessibleName(tr("Distance from equilibrium"));
    m_sentence->setWhatsThis(
        tr("The distance of Kolmogorov and Smirnov, at the moment shown: the greatest difference "
           "between the share of circles slower than a speed and what the curve says. Of a "
           "hundred gases in equilibrium one is further away by chance."));
    m_plot->setToolTip(m_sentence->whatsThis());
    m_throttle->request();
}

void SpeedHistogram::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
    } else if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        setHeadingFont();
        m_throttle->request();
    }
}

void SpeedHistogram::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    m_sentence->fitInto({width(), static_cast<int>(sentencePart * height())});
}

void SpeedHistogram::setHeadingFont()
{
    QFont heading = headingFont();
    heading.setCapitalization(QFont::MixedCase); // a unit keeps its letters
    m_heading->setFont(heading);
}

} // namespace cradle
