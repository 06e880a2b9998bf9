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

    void same() { add(DiffLine::Kind::Same); }
    void removed() { add(DiffLine::Kind::Removed); }
    void added() { add(DiffLine::Kind::Added); }
    std::vector<DiffLine> take() { return std::move(m_lines); }

private:
    void add(DiffLine::Kind kind)
    {
        const bool isBefore = kind != DiffLine::Kind::Added;
        const bool isAfter = kind != DiffLine::Kind::Removed;
        m_lines.push_back({kind, isBefore ? m_before[m_x] : m_after[m_y], isBefore ? m_x + 1 : 0,
                           isAfter ? m_y + 1 : 0});
        m_x += isBefore ? 1 : 0;
        m_y += isAfter ? 1 : 0;
    }

    const QStringList &m_before;
    const QStringList &m_after;
    std::vector<DiffLine> m_lines{};
    int m_x = 0; ///< lines of the text before that are written
    int m_y = 0;
};

/// The steps from one text to the other, backwards: 0 both, -1 removed, 1 added. Without the lines
/// at the start and the end that are the same. \return nothing if there are too many changes
std::vector<int> shortestWay(const QStringList &a, const QStringList &b)
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
            std::vector<int> way;
            int atX = n;
            int atY = m;
            for (int step = d; step >= 0; --step) {
                const std::vector<int> &then = trace[static_cast<std::size_t>(step)];
                const int diagonal = atX - atY;
                const bool came =
                    diagonal == -step
                    || (diagonal != step && then[at(diagonal - 1)] < then[at(diagonal + 1)]);
                const int before = came ? diagonal + 1 : diagonal - 1;
                const int fromX = step == 0 ? 0 : then[at(before)];
                const int fromY = step == 0 ? 0 : fromX - before;
                while (atX > fromX && atY > fromY) {
                    way.push_back(0);
                    --atX;
                    --atY;
                }
                if (step > 0)
                    way.push_back(came ? 1 : -1);
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
    qsizetype start = 0;
    while (start < a.size() && start < b.size() && a[start] == b[start]) {
        writer.same();
        ++start;
    }
    qsizetype end = 0;
    while (end < a.size() - start && end < b.size() - start
           && a[a.size() - 1 - end] == b[b.size() - 1 - end])
        ++end;
    const QStringList innerA = a.mid(start, a.size() - start - end);
    const QStringList innerB = b.mid(start, b.size() - start - end);
    const std::vector<int> way = shortestWay(innerA, innerB);
    if (way.empty()) {
        for (qsizetype i = 0; i < innerA.size(); ++i)
            writer.removed();
        for (qsizetype i = 0; i < innerB.size(); ++i)
            writer.added();
    }
    for (auto step = way.rbegin(); step != way.rend(); ++step) {
        if (*step == 0)
            writer.same();
        else if (*step < 0)
            writer.removed();
        else
            writer.added();
    }
    for (qsizetype i = 0; i < end; ++i)
        writer.same();
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
        if (hunks.empty() || from > done || done == 0)
            hunks.emplace_back();
        const auto first = hunks.back().lines.empty() ? from : done;
        for (auto line = first; line < to; ++line)
            hunks.back().lines.push_back(diff[static_cast<std::size_t>(line)]);
        done = std::max(done, to);
    }
    return hunks;
}

} // namespace cradle
