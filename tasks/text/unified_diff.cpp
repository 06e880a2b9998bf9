// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/text/unified_diff.h"

#include "tasks/text/line_diff.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace cradle {

namespace {

struct DiffText {
    Q_DECLARE_TR_FUNCTIONS(UnifiedDiff)
};

constexpr int mostTrimmed = 2; ///< lines around a change, at each end, that may be others by now

/// "4,3"; a single line is told without its count.
QString rangeOf(qsizetype start, qsizetype count)
{
    return count == 1 ? QString::number(start) : QStringLiteral("%1,%2").arg(start).arg(count);
}

/// One hunk as it is read.
struct Hunk {
    qsizetype start;      ///< index of its first line in the text before
    QStringList before{}; ///< lines that are there
    QStringList after{};  ///< lines that shall be there
    qsizetype leading = 0;
    qsizetype trailing = 0; ///< lines at its ends that stay
    int line;               ///< of the diff, from 1
};

Error fault(int line, const QString &message)
{
    return {.message = message, .line = line};
}

/// Reads one line of a hunk. \return false if it is none
bool takeLine(Hunk &hunk, const QString &line)
{
    const QChar mark = line.isEmpty() ? QLatin1Char(' ') : line.front();
    const QString text = line.mid(1);
    if (mark == QLatin1Char(' ')) {
        hunk.before.append(text);
        hunk.after.append(text);
        if (hunk.leading + 1 == hunk.before.size() && hunk.leading + 1 == hunk.after.size())
            ++hunk.leading;
        ++hunk.trailing;
        return true;
    }
    hunk.trailing = 0;
    if (mark == QLatin1Char('-'))
        hunk.before.append(text);
    else if (mark == QLatin1Char('+'))
        hunk.after.append(text);
    return mark == QLatin1Char('-') || mark == QLatin1Char('+') || mark == QLatin1Char('\\');
}

Result<std::vector<Hunk>> hunksIn(const QString &diff)
{
    static const QRegularExpression head(
        QStringLiteral("^@@ -(\\d{1,7})(?:,(\\d{1,7}))? \\+\\d{1,7}(?:,\\d{1,7})? @@"));
    std::vector<Hunk> hunks;
    int number = 0;
    for (const QString &line : linesOf(diff)) {
        ++number;
        const QRegularExpressionMatch match = head.match(line);
        if (match.hasMatch()) {
            const qsizetype start = match.captured(1).toInt();
            const bool none = match.captured(2) == QLatin1String("0");
            hunks.push_back({.start = none ? start : start - 1, .line = number});
        } else if (hunks.empty() || !takeLine(hunks.back(), line)) {
            return fault(number, DiffText::tr("this is no line of a difference; “@@ -4,3 +4,2 @@” "
                                              "or a line after blank, minus or plus is right"));
        }
    }
    return hunks;
}

/// Where \p lines stand in \p text from \p least on.
std::vector<qsizetype> placesOf(const QStringList &lines, const QStringList &text, qsizetype least)
{
    std::vector<qsizetype> places;
    for (qsizetype at = least; at <= text.size(); ++at) {
        if (text.mid(at, lines.size()) == lines)
            places.push_back(at);
    }
    return places;
}

/// \p hunk without up to \p lines of those at its ends that stay.
Hunk trimmed(const Hunk &hunk, int lines)
{
    const qsizetype front = std::min<qsizetype>(lines, hunk.leading);
    const qsizetype back = std::min<qsizetype>(lines, hunk.trailing);
    Hunk less = hunk;
    less.start += front;
    less.before = hunk.before.mid(front, hunk.before.size() - front - back);
    less.after = hunk.after.mid(front, hunk.after.size() - front - back);
    return less;
}

} // namespace

QString unifiedDiff(const QString &before, const QString &after, int context)
{
    QString text;
    qsizetype more = 0; // lines that the hunks so far have added
    for (const DiffHunk &hunk : hunksOf(lineDiff(before, after), context)) {
        QString body;
        qsizetype beforeCount = 0;
        qsizetype afterCount = 0;
        for (const DiffLine &line : hunk.lines) {
            const bool old = line.kind != DiffLine::Kind::Added;
            const bool now = line.kind != DiffLine::Kind::Removed;
            beforeCount += old ? 1 : 0;
            afterCount += now ? 1 : 0;
            body += QLatin1Char(old && now ? ' ' : old ? '-' : '+') + line.text + QLatin1Char('\n');
        }
        const DiffLine &first = hunk.lines.front();
        const bool isAdded = first.kind == DiffLine::Kind::Added;
        // Of no lines the one before them is told.
        const qsizetype beforeStart =
            (isAdded ? first.after - more : first.before) - (beforeCount == 0 ? 1 : 0);
        const qsizetype afterStart =
            (isAdded ? first.after : first.before + more) - (afterCount == 0 ? 1 : 0);
        more += afterCount - beforeCount;
        text += QStringLiteral("@@ -%1 +%2 @@\n")
                    .arg(rangeOf(beforeStart, beforeCount), rangeOf(afterStart, afterCount))
                + body;
    }
    return text;
}

Result<QString> withDiff(const QString &before, const QString &diff)
{
    const Result<std::vector<Hunk>> hunks = hunksIn(diff);
    if (!hunks)
        return hunks.error();
    QStringList text = linesOf(before);
    qsizetype least = 0; // what stands before it was made by an earlier hunk, or is behind us
    qsizetype moved = 0;
    for (const Hunk &whole : *hunks) {
        Hunk hunk = whole;
        std::vector<qsizetype> places = placesOf(hunk.before, text, least);
        for (int lines = 1; lines <= mostTrimmed && places.empty(); ++lines) {
            hunk = trimmed(whole, lines);
            places = placesOf(hunk.before, text, least);
            if (hunk.before.isEmpty() || places.size() > 1)
                places.clear(); // which of them?
        }
        if (places.empty())
            return fault(whole.line, DiffText::tr("the lines that this changes are not there any "
                                                  "more"));
        const auto far = [wanted = hunk.start + moved](qsizetype at) {
            return std::abs(at - wanted);
        };
        const qsizetype at = *std::min_element(places.begin(), places.end(),
                                               [&](auto a, auto b) { return far(a) < far(b); });
        moved = at - hunk.start + hunk.after.size() - hunk.before.size();
        text = text.mid(0, at) + hunk.after + text.mid(at + hunk.before.size());
        least = at + hunk.after.size();
    }
    return text.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

} // namespace cradle
