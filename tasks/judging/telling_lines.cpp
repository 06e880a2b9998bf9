// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/telling_lines.h"

#include "tasks/judging/begun_line.h"
#include "tasks/judging/called_lines.h"
#include "tasks/judging/early_line.h"
#include "tasks/judging/lone_lines.h"
#include "tasks/judging/program_functions.h"
#include "tasks/judging/program_rows.h"

#include <QRegularExpression>

#include <algorithm>
#include <iterator>

namespace cradle {

namespace {

/// The line that works out a mass; 0 if none is found.
int massLine(const ProgramLines &program, const QStringList &rows,
             const std::function<bool(int)> &isSound)
{
    const std::vector<ProgramAssignment> assignments = assignmentsOf(program);
    const QStringList copies =
        copiesOf(program, assignments, {QStringLiteral("radius"), QStringLiteral("density")});
    const QString quantities =
        (QStringList{QStringLiteral("radius|density|volume|masse?")} + copies)
            .join(QLatin1Char('|'));
    const QString densities = (QStringList{QStringLiteral("density")}
                               + copiesOf(program, assignments, {QStringLiteral("density")}))
                                  .join(QLatin1Char('|'));
    const QRegularExpression quantity(QStringLiteral("\\b(%1)\\b").arg(quantities));
    const QRegularExpression power(QStringLiteral("\\bpi\\b|\\^|\\b(%1)\\b").arg(densities));
    const std::set<int> dead = deadLines(program);
    int best = 0;
    int most = 0;
    for (int i = 0; i < rows.size(); ++i) {
        const QString &row = rows[i];
        if (!row.contains(quantity) || !row.contains(power) || compares(row)
            || row.contains(QLatin1String("velocity")) || dead.contains(i + 1))
            continue;
        const int work = worksOut(row);
        if (work > most && !isSound(i + 1)) {
            most = work;
            best = i + 1;
        }
    }
    return best;
}

/// The line in which what is called a mass is given a value; 0 if there are several.
int namedMassLine(const ProgramLines &program, const std::function<bool(int)> &isSound)
{
    static const QRegularExpression mass(QStringLiteral("^m(ass(es)?)?_?(\\d|[abij]|one|two)?$"),
                                         QRegularExpression::CaseInsensitiveOption);
    const std::set<int> dead = deadLines(program);
    int found = 0;
    for (const ProgramAssignment &each : assignmentsOf(program)) {
        const QStringList values = valuesIn(program, each.from, each.to);
        // What is worked out of masses is no circle's.
        if (!each.name.contains(mass) || each.line == found || dead.contains(each.line)
            || isSound(each.line)
            || std::any_of(values.begin(), values.end(),
                           [](const QString &value) { return value.contains(mass); }))
            continue;
        const std::vector<int> twins = program.twinsOf(each.line);
        if (found != 0 && std::find(twins.begin(), twins.end(), found) == twins.end())
            return 0;
        found = found == 0 ? each.line : found;
    }
    return found;
}

/// The line that copies a value of the scene; 0 if there is none.
int copyLine(const QStringList &rows)
{
    static const QRegularExpression copy(
        QStringLiteral("^\\s*(local\\s+)?\\w+\\s*=\\s*(restitution|gravity(\\.[xy])?)\\s*$"));
    for (int line = 1; line <= rows.size(); ++line) {
        if (rows[line - 1].contains(copy))
            return line;
    }
    return 0;
}

/// The line that runs at the moment and works a value out only where there is none yet; 0 if there
/// is none.
int keepingLine(const QStringList &rows, const RanLines &ran)
{
    static const QRegularExpression keeps(QStringLiteral(
        "(\\b[\\w.]+)\\s*=\\s*\\(?\\s*\\1\\s+or\\b|\\bif\\s+not\\s+[\\w.]+\\s+then"));
    for (const int line : ran.now) {
        if (line >= 1 && line <= rows.size() && rows[line - 1].contains(keeps))
            return line;
    }
    return 0;
}

/// The only line at the start of a program, at the top of the file or in on_load, that gives what
/// \p line takes, but for numbers and what circles have; 0 if there is none, or several.
int startLine(const ProgramLines &program, int line)
{
    static const QSet<QString> given{QStringLiteral("position"), QStringLiteral("velocity"),
                                     QStringLiteral("radius"),   QStringLiteral("density"),
                                     QStringLiteral("mass"),     QStringLiteral("x"),
                                     QStringLiteral("y")};
    const std::vector<ProgramFunction> functions = functionsOf(program);
    const auto &row = program.tokensOf(line);
    int found = 0;
    for (const ProgramAssignment &each : assignmentsOf(program)) {
        const bool isTaken = std::any_of(row.begin(), row.end(), [&](std::size_t i) {
            const bool isField = i > 0 && program.is(i - 1, ".");
            return program.tokens()[i].text == each.name && isField == each.isField;
        });
        if (!isOfStart(functions, each.line) || !isTaken || isNumber(program, each)
            || each.from == each.to || program.is(each.from, "nil") || given.contains(each.name)
            || each.line == found)
            continue;
        if (found != 0)
            return 0;
        found = each.line;
    }
    return found;
}

/// The only line of those that run at the moment that has \p sought in it; 0 if there is none, or
/// several.
int onlyLineWith(const QRegularExpression &sought, const QStringList &rows, const RanLines &ran)
{
    int found = 0;
    for (const int line : ran.now) {
        if (line < 1 || line > rows.size() || !rows[line - 1].contains(sought))
            continue;
        if (found != 0)
            return 0;
        found = line;
    }
    return found;
}

/// The first line that runs at the moment and asks what a step noted for later ones: a value that
/// is true or false, or nothing yet, before the first step. 0 if there is none.
int rememberedLine(const ProgramLines &program, const QStringList &rows, const RanLines &ran)
{
    const std::vector<ProgramFunction> functions = functionsOf(program);
    QStringList begun;
    QStringList noted;
    for (const ProgramAssignment &each : assignmentsOf(program)) {
        const bool isOfStart = cradle::isOfStart(functions, each.line);
        const bool isVerdict = program.is(each.from, "false") || program.is(each.from, "true")
                               || program.is(each.from, "nil");
        if (isOfStart ? isVerdict : program.tokens()[each.target].text == each.name)
            (isOfStart ? begun : noted).append(each.name);
    }
    static const QRegularExpression question(QStringLiteral("\\b(if|and|or|not)\\b"));
    for (const int line : ran.now) {
        if (line < 1 || line > rows.size() || !rows[line - 1].contains(question))
            continue;
        const auto &row = program.tokensOf(line);
        if (std::any_of(row.begin(), row.end(), [&](std::size_t i) {
                const QString &name = program.tokens()[i].text;
                return begun.contains(name) && noted.contains(name) && !program.is(i + 1, "=");
            }))
            return line;
    }
    return 0;
}

/// The first of the lines that only the moment needs in which a velocity is set, or, \p ofTimestep,
/// the timestep stands; 0 if there is none.
int steppedLine(const ProgramLines &program, const QStringList &rows, const RanLines &ran,
                bool ofTimestep)
{
    static const QRegularExpression step(QStringLiteral("function\\s+on_update\\s*\\(\\s*(\\w+)"));
    static const QRegularExpression velocity(QStringLiteral("\\.velocity\\s*(,[^=]*)?=[^=]"));
    const QString name = step.match(rows.join(QLatin1Char('\n'))).captured(1);
    if (ofTimestep && name.isEmpty())
        return 0;
    const QRegularExpression sought =
        ofTimestep ? QRegularExpression(QStringLiteral("\\b%1\\b").arg(name)) : velocity;
    const std::set<int> dead = deadLines(program);
    for (const int line : ran.special()) {
        if (line >= 1 && line <= rows.size() && !dead.contains(line) && worksOut(rows[line - 1]) > 0
            && rows[line - 1].contains(sought))
            return line;
    }
    return 0;
}

} // namespace

std::vector<int> withRestitution(const std::vector<int> &lines, const QStringList &rows,
                                 const ProgramLines &program)
{
    const QStringList names =
        QStringList{QStringLiteral("restitution")}
        + copiesOf(program, assignmentsOf(program), {QStringLiteral("restitution")});
    const QRegularExpression e(QStringLiteral("\\b(%1)\\b").arg(names.join(QLatin1Char('|'))));
    std::vector<int> found;
    std::copy_if(lines.begin(), lines.end(), std::back_inserter(found),
                 [&](int line) { return rows[line - 1].contains(e); });
    return found.empty() ? lines : found;
}

int tellingLine(const LawDeviation &deviation, const ProgramLines &program, const QStringList &rows,
                const RanLines &ran, int last, const std::function<bool(int)> &isSound)
{
    static const QRegularExpression angle(QStringLiteral("\\bmath\\.(atan|asin|acos)\\b"));
    static const QRegularExpression rounds(
        QStringLiteral("//|\\bmath\\.(floor|ceil|tointeger|modf)\\b"));
    if (const int line = deviation.topic == Topic::Direction  ? onlyLineWith(angle, rows, ran)
                         : deviation.topic == Topic::Rounding ? onlyLineWith(rounds, rows, ran)
                                                              : 0)
        return line;
    if (const int line = deviation.topic == Topic::Memory ? rememberedLine(program, rows, ran) : 0)
        return line;
    if (deviation.topic == Topic::Timestep && deviation.aspect == Aspect::Motion)
        return timestepGiven(program, last);
    if (deviation.topic == Topic::Timestep)
        return steppedLine(program, rows, ran, true);
    if (deviation.topic == Topic::Depth && deviation.suspect == Suspect::Answer)
        return steppedLine(program, rows, ran, false);
    switch (deviation.suspect) {
    case Suspect::Masses:
        // Where the own scene alone is wrong, the formula is right.
        if (const int line =
                deviation.moment.stage.pinned
                    ? 0
                    : earlyLine(program, {QStringLiteral("radius"), QStringLiteral("density")}))
            return line;
        if (const int line = massLine(program, rows, isSound))
            return line;
        return namedMassLine(program, isSound);
    case Suspect::Copy:
        if (const int line = copyLine(rows))
            return line;
        return earlyLine(program, {QStringLiteral("radius"), QStringLiteral("density"),
                                   QStringLiteral("restitution"), QStringLiteral("gravity")});
    case Suspect::Kept:
        if (const int line = keepingLine(rows, ran))
            return line;
        return last < 1 || last > program.count() ? 0 : startLine(program, last);
    case Suspect::Begun:
        if (const int line = last < 1 || last > program.count()
                                 ? 0
                                 : begunLine(program, last, deviation.moment.isPosition))
            return line;
        return earlyLine(program, {QStringLiteral("position"), QStringLiteral("velocity")});
    case Suspect::Omission:
        return deviation.aspect == Aspect::Walls ? lineOfMissingWall(deviation, program, rows) : 0;
    case Suspect::Answer:
    case Suspect::Question:
    case Suspect::Reach:
    case Suspect::Formula:
        break;
    }
    return 0;
}

} // namespace cradle
