// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/lone_lines.h"

#include "tasks/judging/program_functions.h"
#include "tasks/judging/program_rows.h"

#include <QRegularExpression>

#include <algorithm>

namespace cradle {

namespace {

/// The functions, by name, in which walls are asked for.
QStringList askingForWalls(const std::vector<ProgramFunction> &functions, const QStringList &rows)
{
    QStringList names;
    for (const ProgramFunction &function : functions) {
        if (function.name.isEmpty() || function.name.startsWith(QLatin1String("on_")))
            continue;
        for (int line = function.first; line <= function.last; ++line) {
            if (!names.contains(function.name) && asksForWall(rows[line - 1]))
                names.append(function.name);
        }
    }
    return names;
}

/// The last line that gives a circle to what asks for walls, where each that does names another
/// than that one, from 0; 0 if one names none, or that one.
int lineForOthers(int circle, const ProgramLines &program, const QStringList &rows)
{
    static const QRegularExpression named(QStringLiteral("\\bcircles?\\[?(\\d+)\\b"));
    const std::vector<ProgramFunction> functions = functionsOf(program);
    QStringList asking = askingForWalls(functions, rows);
    int found = 0;
    for (qsizetype k = 0; k < asking.size(); ++k) {
        const QRegularExpression call(QStringLiteral("\\b%1\\s*\\((.*)").arg(asking[k]));
        for (int line = 1; line <= program.count(); ++line) {
            const ProgramFunction *function = functionAt(functions, line);
            const QString given = call.match(rows[line - 1]).captured(1);
            if (!function || function->name == asking[k] || given.isEmpty())
                continue;
            auto each = named.globalMatch(given);
            // Who hands on what it is given asks for it, too.
            const bool handsOn =
                !each.hasNext() && !function->name.isEmpty()
                && std::any_of(
                    function->parameters.begin(), function->parameters.end(),
                    [&](const QString &name) { return withName(given, name, {}) != given; });
            if (handsOn && !asking.contains(function->name))
                asking.append(function->name);
            if (!each.hasNext() && !handsOn)
                return 0;
            while (each.hasNext()) {
                if (each.next().captured(1).toInt() == circle + 1)
                    return 0;
                found = std::max(found, line);
            }
        }
    }
    return found;
}

} // namespace

int equalityLine(const ProgramLines &program, const QStringList &rows)
{
    static const QRegularExpression equal(QStringLiteral("[^=~<>]==[^=]"));
    static const QRegularExpression length(QStringLiteral("\\bradius\\b|\\bsquare\\b"));
    const std::set<int> dead = deadLines(program);
    int found = 0;
    for (int line = 1; line <= program.count(); ++line) {
        const QString &row = rows[line - 1];
        if (!row.contains(equal) || !row.contains(length) || dead.contains(line))
            continue;
        if (found != 0)
            return 0;
        found = line;
    }
    return found;
}

int lineOfWall(const LawDeviation &deviation, const ProgramLines &program)
{
    static constexpr const char *names[] = {"left", "right", "bottom", "top"};
    if (!deviation.wall)
        return 0;
    const auto isWall = [&](std::size_t i, const char *name) {
        return i > 1 && program.is(i, name) && program.is(i - 1, ".")
               && program.is(i - 2, "square");
    };
    const char *own = names[static_cast<int>(*deviation.wall)];
    // What names a circle asks for that one.
    static const QRegularExpression named(QStringLiteral("\\bcircles?\\[?(\\d+)\\b"));
    const auto isOfAnother = [&](int line) {
        const QRegularExpressionMatch match = named.match(program.row(line));
        const std::vector<int> &circles = deviation.moment.circles;
        return match.hasMatch()
               && std::find(circles.begin(), circles.end(), match.captured(1).toInt() - 1)
                      == circles.end();
    };
    const std::set<int> dead = deadLines(program);
    int found = 0;
    for (int line = 1; line <= program.count(); ++line) {
        const auto &row = program.tokensOf(line);
        const auto hasWall = [&](const char *name) {
            return std::any_of(row.begin(), row.end(),
                               [&](std::size_t i) { return isWall(i, name); });
        };
        if (dead.contains(line) || !hasWall(own))
            continue;
        const bool isOfOthers =
            std::any_of(std::begin(names), std::end(names),
                        [&](const char *name) { return name != own && hasWall(name); });
        const bool asks = std::any_of(row.begin(), row.end(), [&](std::size_t i) {
            return program.is(i, "<") || program.is(i, ">") || program.is(i, "<=")
                   || program.is(i, ">=") || program.is(i, "(") || program.is(i, "{");
        });
        if (found != 0 || isOfOthers || !asks || isOfAnother(line))
            return 0;
        found = line;
    }
    return found;
}

int lineOfMissingWall(const LawDeviation &deviation, const ProgramLines &program,
                      const QStringList &rows)
{
    if (const int line = equalityLine(program, rows))
        return line;
    const int line = deviation.moment.circles.size() == 1
                         ? lineForOthers(deviation.moment.circles.front(), program, rows)
                         : 0;
    return line != 0 ? line : lineOfWall(deviation, program);
}

} // namespace cradle
