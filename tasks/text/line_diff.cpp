// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/text/line_diff.h"

#include <QStringList>

#include <algorithm>

namespace cradle {

namespace {

/// Removed and added lines, above which no shortest way is looked for: it takes the square of
/// their number in memory.
constexpr int mostChanges = 1500;

/// Appends lines of two texts, and counts them.
class Writer
{
public:
    Writer(const QStringList &before, const QStringList &after)
        : m_before(before)
        , m_after(after)
    {
    }

    void add(DiffLine::Kind kind)
    {
        const bool isBefore = kind != DiffLine::Kind::Added;
        const bool isAfter = kind != DiffLine::Kind::Removed;
        m_lines.push_back({kind, isBefore ? m_before[m_x] : m_after[m_y], isBefore ? m_x + 1 : 0,
                           isAfter ? m_y + 1 : 0});
        m_x += isBefore ? 1 : 0;
        m_y += isAfter ? 1 : 0;
    }

    std::vector<DiffLine> take() { return std::move(m_lines); }

private:
    const QStringList &m_before;
    const QStringList &m_after;
    std::vector<DiffLine> m_lines{};
    int m_x = 0; ///< lines of the text before that are written
    int m_y = 0;
};

/// The lines from one text to the other, backwards; \p a and \p b begin with other lines.
/// \return nothing if there are too many changes
std::vector<DiffLine::Kind> shortestWay(const QStringList &a, const QStringList &b)
{
    const int n = static_cast<int>(a.size());
    const int m = static_cast<int>(b.size());
    const int most = std::min(n + m, mostChanges);
    std::vector<int> furthest(static_cast<std::size_t>(2 * most + 2), 0);
    const auto at = [most](int k) { return static_cast<std::size_t>(k + most); };
    std::vector<std::vector<int>> trace;
    for (int d = 0; d <= most; ++d) {
        trace.push_back(furthest);
        for (int k = -d; k <= d; k += 2) {
            const bool down = k == -d || (k != d && furthest[at(k - 1)] < furthest[at(k + 1)]);
            int x = down ? furthest[at(k + 1)] : furthest[at(k - 1)] + 1;
            while (x < n && x - k < m && a[x] == b[x - k])
                ++x;
            furthest[at(k)] = x;
            if (x < n || x - k < m)
                continue;
            std::vector<DiffLine::Kind> way;
            int atX = n;
            int atY = m;
            for (int step = d; step > 0; --step) {
                const std::vector<int> &then = trace[static_cast<std::size_t>(step)];
                const int diagonal = atX - atY;
                const bool came =
                    diagonal == -step
                    || (diagonal != step && then[at(diagonal - 1)] < then[at(diagonal + 1)]);
                const int before = came ? diagonal + 1 : diagonal - 1;
                const int fromX = then[at(before)];
                const int fromY = fromX - before;
                while (atX > fromX && atY > fromY) {
                    way.push_back(DiffLine::Kind::Same);
                    --atX;
                    --atY;
                }
                way.push_back(came ? DiffLine::Kind::Added : DiffLine::Kind::Removed);
                atX = fromX;
                atY = fromY;
            }
            return way;
        }
    }
    return {};
}

} // namespace

QStringList linesOf(const QString &text)
{
    QStringList lines = text.split(QLatin1Char('\n'));
    if (lines.last().isEmpty())
        lines.removeLast();
    return lines;
}

std::vector<DiffLine> lineDiff(const QString &before, const QString &after)
{
    const QStringList a = linesOf(before);
    const QStringList b = linesOf(after);
    Writer writer(a, b);
    const auto start = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin();
    QStringList innerA = a.mid(start);
    QStringList innerB = b.mid(start);
    const auto end =
        std::mismatch(innerA.rbegin(), innerA.rend(), innerB.rbegin(), innerB.rend()).first
        - innerA.rbegin();
    innerA.resize(innerA.size() - end);
    innerB.resize(innerB.size() - end);
    const auto write = [&writer](auto count, DiffLine::Kind kind) {
        for (qsizetype i = 0; i < count; ++i)
            writer.add(kind);
    };
    write(start, DiffLine::Kind::Same);
    const std::vector<DiffLine::Kind> way = shortestWay(innerA, innerB);
    if (way.empty()) {
        write(innerA.size(), DiffLine::Kind::Removed);
        write(innerB.size(), DiffLine::Kind::Added);
    }
    for (auto kind = way.rbegin(); kind != way.rend(); ++kind)
        writer.add(*kind);
    write(end, DiffLine::Kind::Same);
    return writer.take();
}

std::vector<DiffHunk> hunksOf(const std::vector<DiffLine> &diff, int context)
{
    std::vector<DiffHunk> hunks;
    const auto size = static_cast<std::ptrdiff_t>(diff.size());
    std::ptrdiff_t done = 0; // what comes before is in a hunk, or in none
    for (std::ptrdiff_t i = 0; i < size; ++i) {
        if (diff[static_cast<std::size_t>(i)].kind == DiffLine::Kind::Same)
            continue;
        const auto from = std::max(done, i - context);
        const auto to = std::min(size, i + context + 1);
        if (hunks.empty() || from > done)
            hunks.emplace_back();
        for (auto line = from; line < to; ++line)
            hunks.back().lines.push_back(diff[static_cast<std::size_t>(line)]);
        done = std::max(done, to);
    }
    return hunks;
}

} // namespace cradle
