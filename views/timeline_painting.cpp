// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/number_text.h"
#include "views/text_direction.h"
#include "views/theme.h"
#include "views/timeline.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr double sideRoom = 22.0;     ///< px left and right of the bar
constexpr double barTop = 20.0;       ///< px
constexpr double barHeight = 4.0;     ///< px
constexpr double knobRadius = 8.0;    ///< px
constexpr double hitReach = 7.0;      ///< px that a hit's mark stands over the bar, and under it
constexpr double contactGap = 3.0;    ///< px from the bar to where a contact lasts
constexpr double contactHeight = 3.0; ///< px
constexpr double labelTop = 34.0;     ///< px
constexpr double sideInset = 8.0;     ///< px that labels keep from the ends
constexpr double labelGap = 10.0;     ///< px between two labels, at least
constexpr double retryStep = 16.0;    ///< px to the next hit that may find room for its label
constexpr double crowdedPart = 0.15;  ///< of the columns have hits
constexpr double fullPart = 0.5;      ///< of the columns: the number of a hit tells nothing
constexpr std::size_t fewHits = 4;    ///< in a column: with no more in any, none stands out
constexpr double leastReach = 3.0;    ///< px of a mark of one hit where they crowd
constexpr int totalHeight = 56;       ///< px
constexpr int textPixels = 11;

/// A program that stopped, told from a check that failed by its shape.
void drawCross(QPainter &painter, QPointF middle)
{
    constexpr double arm = 4.5; // px
    painter.setPen(QPen(theme().warning, 2.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(middle - QPointF(arm, arm), middle + QPointF(arm, arm));
    painter.drawLine(middle - QPointF(arm, -arm), middle + QPointF(arm, -arm));
}

} // namespace

QSize Timeline::sizeHint() const
{
    return {640, static_cast<int>(std::lround(labelTop + (totalHeight - labelTop) * textScale()))};
}

QSize Timeline::minimumSizeHint() const
{
    return {160, totalHeight};
}

QRectF Timeline::bar() const
{
    return {sideRoom, barTop, std::max(1.0, width() - 2.0 * sideRoom), barHeight};
}

/// Arabic letters are not for columns: in a font for those they stand apart.
QFont Timeline::fontOf(const QString &text) const
{
    QFont small = text.isRightToLeft() ? font() : numericFont();
    small.setPixelSize(scaledByText(textPixels));
    return small;
}

std::vector<HitColumn> Timeline::columns() const
{
    const Recording &recording = m_simulation.recording();
    return hitColumns(recording.encounters(), recording.time(recording.first()),
                      recording.time(recording.last()), static_cast<int>(bar().width()));
}

std::vector<Timeline::Label> Timeline::labels() const
{
    return labelsAt(columns());
}

std::vector<Timeline::Label> Timeline::labelsAt(const std::vector<HitColumn> &columns) const
{
    std::vector<Label> all;
    addMarkLabels(all);
    // At its very moment a hit is what to read, not when the run ends.
    const Recording &recording = m_simulation.recording();
    const auto shown = shownHit();
    const bool atHit =
        shown && recording.encounters()[*shown].step == recording.step(m_simulation.current());
    if (atHit)
        addShownHitLabel(all, columns);
    addEndLabels(all);
    if (!atHit)
        addShownHitLabel(all, columns);
    addHitLabels(all, columns);
    return all;
}

void Timeline::addLabel(std::vector<Label> &labels, double x, const QString &text,
                        const QColor &colour) const
{
    const QFontMetricsF metrics(fontOf(text));
    const QSizeF size(std::ceil(metrics.horizontalAdvance(text)), std::ceil(metrics.height()));
    // Below its mark, or else ending or beginning there.
    for (const double part : {0.5, 1.0, 0.0}) {
        const double last = std::max(sideInset, width() - size.width() - sideInset);
        const double left = std::clamp(x - part * size.width(), sideInset, last);
        const QRectF rect(QPointF(std::round(left), labelTop), size);
        const QRectF room = rect.adjusted(-labelGap, 0.0, labelGap, 0.0);
        const bool taken = std::any_of(labels.begin(), labels.end(), [&room](const Label &other) {
            return other.rect.intersects(room);
        });
        if (!taken && rect.right() <= width())
            return labels.push_back({rect, text, colour});
    }
}

void Timeline::addEndLabels(std::vector<Label> &labels) const
{
    const Recording &recording = m_simulation.recording();
    const double first = recording.time(recording.first());
    const double last = recording.time(recording.last());
    const auto text = [](double time) {
        return tr("%1 s").arg(time == 0.0 ? QStringLiteral("0") : QString::number(time, 'f', 1));
    };
    const QColor colour = theme().mutedText;
    addLabel(labels, bar().left(), text(first), colour);
    if (last > first)
        addLabel(labels, bar().right(), text(last), colour);
}

void Timeline::addMarkLabels(std::vector<Label> &labels) const
{
    for (const Mark &mark : recordedMarks())
        addLabel(labels, xOf(mark.time), mark.label, theme().warning);
}

void Timeline::addHitLabel(std::vector<Label> &labels, const HitColumn &column) const
{
    const Recording &recording = m_simulation.recording();
    const qint64 first = recording.droppedEncounters() + static_cast<qint64>(column.first) + 1;
    const qint64 last = first + static_cast<qint64>(column.count) - 1;
    const QString text =
        first == last ? tr("hit %1").arg(first) : tr("hits %1–%2").arg(first).arg(last);
    addLabel(labels, xOf(recording.encounters()[column.first].time), text,
             readableOn(theme().along, theme().panel));
}

std::optional<std::size_t> Timeline::shownHit() const
{
    const Recording &recording = m_simulation.recording();
    return lastHit(recording.encounters(), recording.step(m_simulation.current()));
}

/// The hit that is shown keeps its label, whatever the others find room for.
void Timeline::addShownHitLabel(std::vector<Label> &labels, const std::vector<HitColumn> &all) const
{
    const auto shown = shownHit();
    for (const HitColumn &column : all) {
        if (shown && *shown >= column.first && *shown < column.first + column.count)
            addHitLabel(labels, column);
    }
}

void Timeline::addHitLabels(std::vector<Label> &labels, const std::vector<HitColumn> &all) const
{
    if (isFuller(all, fullPart))
        return;
    double free = 0.0;
    for (const HitColumn &column : all) {
        const double x = bar().left() + column.x;
        if (x < free)
            continue;
        const std::size_t before = labels.size();
        addHitLabel(labels, column);
        // What did not fit here does not fit a few pixels on.
        free = labels.size() > before ? labels.back().rect.right() + labelGap : x + retryStep;
    }
}

bool Timeline::isFuller(const std::vector<HitColumn> &columns, double part) const
{
    return static_cast<double>(columns.size()) > part * bar().width();
}

void Timeline::drawHits(QPainter &painter, const std::vector<HitColumn> &columns) const
{
    const double left = bar().left();
    const double middle = bar().center().y();
    // Where they crowd, thinner and lower ones leave the bar to be seen; the more hits, the higher.
    const bool crowded = isFuller(columns, crowdedPart);
    std::size_t most = fewHits;
    for (const HitColumn &column : columns)
        most = std::max(most, column.count);
    std::vector<double> reaches(most + 1, hitReach); // by number of hits
    for (std::size_t count = 0; crowded && count <= most; ++count) {
        const double part =
            std::log1p(static_cast<double>(count)) / std::log1p(static_cast<double>(most));
        reaches[count] = std::round(leastReach + (hitReach - leastReach) * part);
    }
    QList<QRectF> rects;
    rects.reserve(static_cast<qsizetype>(columns.size()));
    for (const HitColumn &column : columns) {
        const double reach = reaches[column.count];
        const double x = std::round(left + column.x) - (crowded ? 0.0 : 1.0);
        const QRectF rect(x, middle - reach, crowded ? 1.0 : 2.0, 2.0 * reach);
        // Beside one of the same height it is drawn with that: few are faster than many.
        if (!rects.isEmpty() && rects.last().right() == x && rects.last().top() == rect.top())
            rects.last().setRight(rect.right());
        else
            rects.append(rect);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().along);
    painter.drawRects(rects);
}

/// A contact that lasts is a line under the bar, from its beginning to its end.
void Timeline::drawContacts(QPainter &painter) const
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().along);
    const auto place = [this](double time) { return xOf(time); };
    const double top = bar().bottom() + contactGap;
    for (const auto &[from, to] : lastingEncounters(m_simulation.recording(), place))
        painter.drawRect(QRectF(from, top, std::max(2.0, to - from), contactHeight));
}

void Timeline::drawMarks(QPainter &painter) const
{
    painter.setBrush(theme().warning);
    for (const Mark &mark : recordedMarks()) {
        const QPointF tip(xOf(mark.time), bar().top() - 3.0);
        if (mark.kind == Mark::Kind::Error) {
            drawCross(painter, tip - QPointF(0.0, 6.0));
            continue;
        }
        painter.setPen(QPen(theme().panel, 1.0));
        painter.drawPolygon(QPolygonF{tip, tip + QPointF(-6.0, -10.0), tip + QPointF(6.0, -10.0)});
    }
}

void Timeline::paintEvent(QPaintEvent *)
{
    const Theme &colours = theme();
    QPainter painter(this);
    painter.setLayoutDirection(layoutDirection());
    painter.fillRect(rect(), colours.panel);
    const std::vector<HitColumn> all = columns();
    // Many hits lie behind the bar, which is to be seen through them; a few on it.
    const bool behind = isFuller(all, fullPart);
    if (behind)
        drawHits(painter, all);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.controlBorder);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawRoundedRect(bar(), 2.0, 2.0);
    const double x = xOf(m_simulation.time());
    QRectF past = bar();
    past.setRight(x);
    painter.setBrush(colours.square);
    painter.drawRoundedRect(past, 2.0, 2.0);
    painter.setRenderHint(QPainter::Antialiasing, false);
    if (!behind)
        drawHits(painter, all);
    painter.setRenderHint(QPainter::Antialiasing);
    drawContacts(painter);
    drawMarks(painter);

    if (hasFocus()) {
        painter.setPen(Qt::NoPen);
        QColor ring = colours.accent;
        ring.setAlphaF(0.3F);
        painter.setBrush(ring);
        painter.drawEllipse(QPointF(x, bar().center().y()), knobRadius + 3.0, knobRadius + 3.0);
    }
    painter.setPen(QPen(colours.square, 2.0));
    painter.setBrush(isSliderDown() ? colours.accentSoft : colours.panel);
    painter.drawEllipse(QPointF(x, bar().center().y()), knobRadius - 1.0, knobRadius - 1.0);

    for (const Label &label : labelsAt(all)) {
        painter.setFont(fontOf(label.text));
        painter.setLayoutDirection(directionOf(label.text));
        painter.setPen(label.colour);
        const double ascent = std::round(QFontMetricsF(painter.font()).ascent());
        painter.drawText(label.rect.topLeft() + QPointF(0.0, ascent), label.text);
    }
}

} // namespace cradle
