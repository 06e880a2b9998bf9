// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/repairs.h"

#include <algorithm>

/// The changes that are tried for a line of a program, to be compared with those that are wanted.
namespace cradle::changes {

/// A function with two circles and some names, around a line; line 7 of it.
inline QString around(const QString &line)
{
    return QStringLiteral("function on_update(h)\n"
                          "  a.position = p\n"
                          "  b.position = q\n"
                          "  local m1, m2, va, vb = f(), f(), f(), f()\n"
                          "  local d, n = f(), f()\n"
                          "\n"
                          "%1\n"
                          "\n"
                          "end")
        .arg(line);
}

inline constexpr int theLine = 7;

inline std::vector<Repair> tried(const QString &program, const std::vector<int> &lines = {theLine},
                                 std::size_t most = 1000)
{
    return repairsOf(program, QStringLiteral("x = restitution"), lines, most);
}

inline QString withoutSpaces(QString text)
{
    return text.remove(QLatin1Char(' '));
}

/// Whether \p right is among the changes that are tried, spaces aside.
inline bool isTried(const std::vector<Repair> &all, const QString &right)
{
    return std::any_of(all.begin(), all.end(), [&](const Repair &each) {
        return withoutSpaces(each.source) == withoutSpaces(right);
    });
}

} // namespace cradle::changes
