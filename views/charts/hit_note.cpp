// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/hit_note.h"

#include "views/charts/hit_columns.h"
#include "views/charts/number_text.h"
#include "views/charts/subscript_text.h"
#include "views/theme.h"

#include <QCoreApplication>
#include <QFontMetricsF>

#include <algorithm>
#include <array>
#include <cmath>

namespace cradle {

namespace {

struct HitNoteText {
    Q_DECLARE_TR_FUNCTIONS(HitNote)
};

constexpr double pad = 6.0;        ///< px around the table
constexpr double columnGap = 10.0; ///< px
constexpr std::size_t columns = 4;
constexpr double noise = 1e-9; ///< of the scale: less is no change

using Cells = std::array<QString, columns>;

QString changeText(const HitNote::Row &row, double scale)
{
    const double change = row.after - row.before;
    const QString text = shortNumber(change, scale);
    return change > noise * scale ? QLatin1Char('+') + text : text;
}

Cells cellsOf(const HitNote::Row &row, double scale)
{
    return {row.name, shortNumber(row.before, scale), shortNumber(row.after, scale),
            changeText(row, scale)};
}

std::vector<Cells> cellsOf(const HitNote &note)
{
    std::vector<Cells> all{{note.unit, HitNoteText::tr("before"), HitNoteText::tr("after"),
                            HitNoteText::tr("change")}};
    for (const HitNote::Row &row : note.rows)
        all.push_back(cellsOf(row, note.scale()));
    return all;
}

std::array<double, columns> widthsOf(const std::vector<Cells> &cells, const QFont &font)
{
    std::array<double, columns> widths{};
    for (const Cells &row : cells) {
        for (std::size_t c = 0; c < columns; ++c)
            widths[c] = std::max(widths[c], std::ceil(subscriptWidth(font, row[c])));
    }
    return widths;
}

} // namespace

double HitNote::scale() const
{
    double most = 0.0;
    for (const Row &row : rows)
        most = std::max({most, std::abs(row.before), std::abs(row.after)});
    return most;
}

QString HitNote::sentence() const
{
    QStringList parts;
    for (const Row &row : rows)
        parts << HitNoteText::tr("%1 before %2, after %3, change %4 %5", "who, three numbers, unit")
                     .arg(row.name, shortNumber(row.before, scale()),
                          shortNumber(row.after, scale()), changeText(row, scale()), unit);
    return QStringLiteral("%1: %2").arg(title, parts.join(QStringLiteral("; ")));
}

std::optional<HitsShown> hitsShownAt(const Recording &recording, qint64 index)
{
    const qint64 step = recording.step(index);
    const auto last = lastHit(recording.hits(), step);
    if (!last || recording.hits()[*last].step != step)
        return std::nullopt;
    std::size_t first = *last;
    while (first > 0 && recording.hits()[first - 1].step == step)
        --first;
    return HitsShown{first, *last - first + 1};
}

std::vector<std::size_t> circlesOf(const Hit &hit)
{
    std::vector<std::size_t> circles{static_cast<std::size_t>(hit.a)};
    if (hit.kind == Hit::Kind::Circle)
        circles.push_back(static_cast<std::size_t>(hit.b));
    return circles;
}

std::optional<HitNote> noteOn(const Recording &recording, qint64 index, const HitMeasure &measure)
{
    const auto shown = hitsShownAt(recording, index);
    if (!shown)
        return std::nullopt;
    const Hit &hit = recording.hits()[shown->first];
    const qint64 number = recording.droppedHits() + static_cast<qint64>(shown->first) + 1;
    HitNote note;
    note.title = HitNoteText::tr("Hit %1 · %2 s").arg(number).arg(hit.time, 0, 'f', 3);
    if (shown->count > 1)
        note.title += HitNoteText::tr(" · first of %1").arg(shown->count);
    std::vector<std::pair<double, Vec2>> before;
    std::vector<std::pair<double, Vec2>> after;
    for (const std::size_t i : circlesOf(hit)) {
        const double m = mass(recording.circles(index)[i]);
        const bool isFirst = i == static_cast<std::size_t>(hit.a);
        before.emplace_back(m, isFirst ? hit.beforeA : hit.beforeB);
        after.emplace_back(m, isFirst ? hit.afterA : hit.afterB);
        note.rows.push_back({.name = {},
                             .colour = {},
                             .before = measure(std::span(before).last(1)),
                             .after = measure(std::span(after).last(1))});
    }
    if (before.size() > 1)
        note.rows.push_back({.name = HitNoteText::tr("both"),
                             .colour = {},
                             .before = measure(before),
                             .after = measure(after)});
    return note;
}

QSizeF sizeOf(const HitNote &note, const QFont &font)
{
    const QFontMetricsF metrics(font);
    const auto cells = cellsOf(note);
    double width = columnGap * (columns - 1);
    for (const double column : widthsOf(cells, font))
        width += column;
    width = std::max(width, std::ceil(metrics.horizontalAdvance(note.title)));
    return {width + 2.0 * pad,
            std::ceil(metrics.height()) * static_cast<double>(cells.size() + 1) + pad};
}

void drawNote(QPainter &painter, const HitNote &note, const QRectF &rect)
{
    const Theme &colours = theme();
    const QFontMetricsF metrics(painter.font());
    const double height = std::ceil(metrics.height());
    QColor behind = colours.panel;
    behind.setAlphaF(0.94F);
    painter.setPen(QPen(colours.controlBorder, 1.0));
    painter.setBrush(behind);
    painter.drawRoundedRect(rect.adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
    painter.setBrush(Qt::NoBrush);
    double baseline = rect.top() + 0.5 * pad + std::round(metrics.ascent());
    painter.setPen(readableOn(colours.along, colours.panel));
    painter.drawText(QPointF(rect.left() + pad, baseline), note.title);

    const auto cells = cellsOf(note);
    const auto widths = widthsOf(cells, painter.font());
    for (std::size_t r = 0; r < cells.size(); ++r) {
        baseline += height;
        const bool named = r > 0 && note.rows[r - 1].colour.isValid();
        const QColor text = r == 0 ? colours.mutedText : colours.text;
        double x = rect.left() + pad;
        for (std::size_t c = 0; c < columns; ++c) {
            const double advance = metrics.horizontalAdvance(cells[r][c]);
            painter.setPen(c == 0 && named ? readableOn(note.rows[r - 1].colour, colours.panel)
                                           : text);
            drawSubscripted(painter, {c == 0 ? x : x + widths[c] - advance, baseline}, cells[r][c]);
            x += widths[c] + columnGap;
        }
    }
}

} // namespace cradle
