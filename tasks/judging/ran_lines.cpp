// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/ran_lines.h"

#include <algorithm>
#include <iterator>

namespace cradle {

std::vector<int> RanLines::special() const
{
    std::vector<int> lines;
    std::set_difference(now.begin(), now.end(), before.begin(), before.end(),
                        std::back_inserter(lines));
    return lines;
}

namespace {

std::set<int> linesIn(const QString &program, const Moment &moment, qint64 step)
{
    Probe probe(&program, moment.stage);
    for (qint64 k = 1; k < step; ++k) {
        if (!probe.step())
            return {};
    }
    const std::vector<int> lines = probe.lines();
    return {lines.begin(), lines.end()};
}

} // namespace

RanLines ranLines(const QString &program, const Moment &moment)
{
    if (moment.circles.empty())
        return {};
    return {linesIn(program, moment, moment.step),
            moment.step > 1 ? linesIn(program, moment, moment.step - 1) : std::set<int>{}};
}

} // namespace cradle
