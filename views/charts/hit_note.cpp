// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/hit_note.h"

#include "views/hit_columns.h"
#include "views/number_text.h"
#include "views/subscript_text.h"
#include "views/theme.h"

#include <QCoreApplication>
#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

struct HitNoteText {
    Q_DECLARE_TR_FUNCTIONS(HitNote)
};

constexpr double pad = 6.0;            ///< px around the table
constexpr double columnGap = 10.0;     ///< px
constexpr double shortColumnGap = 5.0; ///< px
constexpr std::size_t mostHits = 6;    ///< of more, the first alone says nothing
constexpr double noise = 1e-9;         ///< of the scale: less is no change

QString changeText(const HitNote::Row &row, double scale)
{
    const double change = row.after - row.before;
    const QString text = shortNumber(change, scale);
    return change > noise * scale ? QLatin1Char('+') + text : text;
}

/// What is written: a line above columns, the first of which stands left, the others right.
struct Table {
    QString title;
    std::vector<QStringList> rows; ///< all of one length
    bool hasHead = false;          ///< the first row names the columns
    double gap = columnGap;        ///< px between two columns
};

Table tableOf(const HitNote &note, NoteForm form)
{
    const double scale = note.scale();
    const auto number = [scale](double value) { return withPower(shortNumber(value, scale)); };
    Table table;
    if (form == NoteForm::Short) {
        table.title = note.unit;
        table.gap = shortColumnGap;
        for (const HitNote::Row &row : note.rows)
            table.rows.push_back(
                {row.name, number(row.before), QString(QChar(0x2192)), number(row.after)});
        return table;
    }
    table.title = note.title;
    table.hasHead = true;
    table.rows.push_back({note.unit, HitNoteText::tr("before"), HitNoteText::tr("after"),
                          HitNoteText::tr("change")});
    for (const HitNote::Row &row : note.rows)
        table.rows.push_back(
            {row.name, number(row.before), number(row.after), withPower(changeText(row, scale))});
    return table;
}

/// Of each column, px.
std::vector<double> widthsOf(const Table &table, const QFont &font)
{
    std::vector<double> widths(static_cast<std::size_t>(table.rows.front().size()));
    for (const QStringList &row : table.rows) {
        for (std::size_t c = 0; c < widths.size(); ++c)
            widths[c] = std::max(widths[c],
                                 std::ceil(subscriptWidth(font, row[static_cast<qsizetype>(c)])));
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
    return HitNoteText::tr("%1: %2", "title, rows").arg(title, parts.join(QStringLiteral("; ")));
}

std::optional<HitsShown> hitsShownAt(const Recording &recording, qint64 index)
{
    const qint64 step = recording.step(index);
    const auto &hits = recording.encounters();
    const auto last = lastHit(hits, step);
    if (!last || hits[*last].step != step)
        return std::nullopt;
    std::size_t first = *last;
    while (first > 0 && hits[first - 1].step == step)
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
    if (!shown || shown->count > mostHits)
        return std::nullopt;
    const Hit &hit = recording.hitOf(recording.encounters()[shown->first]);
    const qint64 number = recording.droppedEncounters() + static_cast<qint64>(shown->first) + 1;
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

QSizeF sizeOf(const HitNote &note, NoteForm form, const QFont &font)
{
    const Table table = tableOf(note, form);
    const std::vector<double> widths = widthsOf(table, font);
    double width = table.gap * static_cast<double>(widths.size() - 1);
    for (const double column : widths)
        width += column;
    width = std::max(width, std::ceil(subscriptWidth(font, table.title)));
    const double lines = static_cast<double>(table.rows.size() + 1);
    return {width + 2.0 * pad, std::ceil(QFontMetricsF(font).height()) * lines + pad};
}

void drawNote(QPainter &painter, const HitNote &note, NoteForm form, const QRectF &rect)
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
    const Table table = tableOf(note, form);
    const std::vector<double> widths = widthsOf(table, painter.font());
    double baseline = rect.top() + 0.5 * pad + std::round(metrics.ascent());
    painter.setPen(readableOn(colours.along, colours.panel));
    drawSubscripted(painter, QPointF(rect.left() + pad, baseline), table.title);

    const std::size_t head = table.hasHead ? 1 : 0;
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
        baseline += height;
        const bool isHead = r < head;
        const QColor text = isHead ? colours.mutedText : colours.text;
        const QColor own = isHead ? QColor() : note.rows[r - head].colour;
        double x = rect.left() + pad;
        for (std::size_t c = 0; c < widths.size(); ++c) {
            const QString &cell = table.rows[r][static_cast<qsizetype>(c)];
            const double indent = c == 0 ? 0.0 : widths[c] - metrics.horizontalAdvance(cell);
            painter.setPen(c == 0 && own.isValid() ? readableOn(own, colours.panel) : text);
            drawSubscripted(painter, {x + indent, baseline}, cell);
            x += widths[c] + table.gap;
        }
    }
}

} // namespace cradle
