// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/repair_list.h"

#include <utility>

namespace cradle {

namespace {

/// Of longer lists every order is too many.
constexpr std::size_t mostElements = 4;

/// The tokens of each value in the list that begins behind token \p i, in its line.
std::vector<std::pair<std::size_t, std::size_t>> elementsBehind(const RepairList &repairs,
                                                                std::size_t i)
{
    std::vector<std::pair<std::size_t, std::size_t>> elements;
    for (std::size_t from = i + 1;; ++from) {
        const std::size_t to = afterExpression(repairs.program(), from);
        if (to == from || repairs.tokens()[to - 1].line != repairs.tokens()[i].line)
            return elements;
        elements.emplace_back(from, to);
        if (!repairs.is(to, ","))
            return elements;
        from = to;
    }
}

} // namespace

void repairElements(RepairList &repairs, std::size_t i)
{
    if (!(repairs.is(i, "(") || repairs.is(i, "{") || repairs.is(i, "=")
          || repairs.is(i, "return")))
        return;
    const auto elements = elementsBehind(repairs, i);
    if (elements.size() > mostElements)
        return;
    const QString &source = repairs.program().source();
    const std::vector<ProgramToken> &tokens = repairs.tokens();
    for (std::size_t a = 0; a < elements.size(); ++a) {
        for (std::size_t b = a + 1; b < elements.size(); ++b) {
            const qsizetype first = tokens[elements[a].first].start;
            const qsizetype afterFirst = tokens[elements[a].second - 1].end();
            const qsizetype second = tokens[elements[b].first].start;
            const qsizetype afterSecond = tokens[elements[b].second - 1].end();
            repairs.replace(tokens[i].line, first, afterSecond,
                            source.mid(second, afterSecond - second)
                                + source.mid(afterFirst, second - afterFirst)
                                + source.mid(first, afterFirst - first));
        }
    }
}

} // namespace cradle
