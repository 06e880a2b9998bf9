// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/called_lines.h"

#include <QRegularExpression>

#include <algorithm>

namespace cradle {

namespace {

const ProgramFunction *functionNamed(const std::vector<ProgramFunction> &functions,
                                     const QString &name)
{
    const auto found =
        std::find_if(functions.begin(), functions.end(), [&](const ProgramFunction &each) {
            return !each.name.isEmpty() && each.name == name;
        });
    return found == functions.end() ? nullptr : &*found;
}

/// The only line of a function that returns something; 0 if there are several, or none.
int returnOf(const ProgramLines &program, const ProgramFunction &function)
{
    int found = 0;
    for (int line = function.first; line <= function.last; ++line) {
        const auto &row = program.tokensOf(line);
        if (std::none_of(row.begin(), row.end(),
                         [&](std::size_t i) { return program.is(i, "return"); }))
            continue;
        if (found != 0)
            return 0;
        found = line;
    }
    return found;
}

/// The circle, from 0, that token \p i names by its number; -1 if it names none.
int circleAt(const ProgramLines &program, std::size_t i)
{
    static const QRegularExpression named(QStringLiteral("^circle(\\d+)$"));
    const QString &text = program.tokens()[i].text;
    if (text == QLatin1String("circles") && program.is(i + 1, "["))
        return program.tokens()[i + 2].text.toInt() - 1;
    const QRegularExpressionMatch match = named.match(text);
    return match.hasMatch() ? match.captured(1).toInt() - 1 : -1;
}

bool isUnaryMinus(const ProgramLines &program, std::size_t i)
{
    return program.is(i, "-") && i > 0
           && (program.is(i - 1, "=") || program.is(i - 1, "(") || program.is(i - 1, ",")
               || program.is(i - 1, "and") || program.is(i - 1, "or"));
}

/// Whether a value is made of numbers alone, and not of none or of nothing.
bool isOfNumbers(const ProgramLines &program, const TokenRange &value)
{
    bool isAny = false;
    for (std::size_t i = value.from; i < value.to; ++i) {
        const ProgramToken &token = program.tokens()[i];
        isAny = isAny || (token.kind == ProgramToken::Kind::Number && token.text.toDouble() != 0.0);
        if (token.kind == ProgramToken::Kind::Name)
            return false;
    }
    return isAny;
}

} // namespace

int askedOfFunction(const LawDeviation &deviation, const ProgramLines &program, int question)
{
    const bool isDistance = deviation.topic == Topic::Distance;
    if (question < 1 || question > program.count()
        || (deviation.suspect != Suspect::Reach && !isDistance))
        return 0;
    const std::vector<ProgramFunction> functions = functionsOf(program);
    int found = 0;
    for (const std::size_t i : program.tokensOf(question)) {
        // Who is given nothing only hands on what it has.
        const ProgramFunction *function = argumentsOf(program, i).empty()
                                              ? nullptr
                                              : functionNamed(functions, program.tokens()[i].text);
        if (!function || (function->first <= question && question <= function->last))
            continue;
        const int returned = returnOf(program, *function);
        if (returned == 0 || found != 0)
            return 0;
        found = returned;
    }
    // What is asked beside the function may be what is wrong with a reach.
    const QString outside = QString(program.row(question))
                                .remove(QRegularExpression(QStringLiteral("\\w+\\s*\\([^()]*\\)")));
    const QRegularExpression length(QStringLiteral("radius|[-+*/]|\\br\\d?\\b"));
    return !isDistance && outside.contains(length) ? 0 : found;
}

int callForOne(const LawDeviation &deviation, const ProgramLines &program, int line)
{
    // What comes out right at times, or in the own scene, is told of one, though others do the
    // same.
    if (deviation.aspect != Aspect::Motion || deviation.isConditional
        || !deviation.moment.stage.pinned || deviation.moment.circles.size() != 1)
        return 0;
    const std::vector<ProgramFunction> functions = functionsOf(program);
    const ProgramFunction *function = functionAt(functions, line);
    if (!function || function->name.isEmpty() || function->name.startsWith(QLatin1String("on_")))
        return 0;
    int found = 0;
    bool isOfOther = false;
    for (std::size_t i = 0; i < program.tokens().size(); ++i) {
        const int at = program.tokens()[i].line;
        const bool isWithin = function->first <= at && at <= function->last;
        // Who names a circle does not do the same for all.
        if (isWithin && circleAt(program, i) >= 0)
            return 0;
        if (isWithin || program.tokens()[i].text != function->name)
            continue;
        const std::vector<TokenRange> given = argumentsOf(program, i);
        const int circle = given.empty() ? -1 : circleAt(program, given.front().from);
        if (circle < 0)
            return 0;
        isOfOther = isOfOther || circle != deviation.moment.circles.front();
        if (found == 0 && circle == deviation.moment.circles.front())
            found = at;
    }
    return isOfOther ? found : 0;
}

int timestepGiven(const ProgramLines &program, int line)
{
    if (line < 1 || line > program.count())
        return 0;
    const std::vector<ProgramFunction> functions = functionsOf(program);
    const std::vector<ProgramAssignment> assignments = assignmentsOf(program);
    const ProgramFunction *function = functionAt(functions, line);
    std::set<int> found;
    for (const std::size_t i : program.tokensOf(line)) {
        const QString &name = program.tokens()[i].text;
        const bool isField = i > 0 && program.is(i - 1, ".");
        if (program.tokens()[i].kind != ProgramToken::Kind::Name || isField
            || program.is(i + 1, "."))
            continue;
        bool isStepped = false;
        for (const bool ofStart : {false, true}) {
            for (const ProgramAssignment &each : assignments) {
                if (each.name != name || each.isField || each.line == line
                    || isOfStart(functions, each.line) != ofStart || (ofStart && isStepped))
                    continue;
                const QStringList values = valuesIn(program, each.from, each.to);
                const bool isOfItself = values == QStringList{name} && each.from + 1 < each.to;
                if (isOfNumbers(program, {each.from, each.to}) || isOfItself)
                    found.insert(each.line);
                isStepped = isStepped || !ofStart;
            }
        }
        const qsizetype parameter = function ? function->parameters.indexOf(name) : -1;
        for (std::size_t k = 0; parameter >= 0 && k < program.tokens().size(); ++k) {
            const std::vector<TokenRange> given = program.tokens()[k].text == function->name
                                                      ? argumentsOf(program, k)
                                                      : std::vector<TokenRange>{};
            const auto at = static_cast<std::size_t>(parameter);
            if (at < given.size() && isOfNumbers(program, given[at]))
                found.insert(program.tokens()[k].line);
        }
        const ProgramFunction *called =
            program.is(i + 1, "(") ? functionNamed(functions, name) : nullptr;
        const int returned = called ? returnOf(program, *called) : 0;
        const auto &row = program.tokensOf(returned);
        if (std::any_of(row.begin(), row.end(), [&](std::size_t k) {
                return program.tokens()[k].kind == ProgramToken::Kind::Number;
            }))
            found.insert(returned);
    }
    return found.size() == 1 ? *found.begin() : 0;
}

int unwrittenTurn(const LawDeviation &deviation, const ProgramLines &program, const RanLines &ran)
{
    if (deviation.topic != Topic::Held)
        return 0;
    std::vector<ProgramAssignment> assignments = assignmentsOf(program);
    const std::vector<ProgramAssignment> rows = rowAssignmentsOf(program);
    assignments.insert(assignments.end(), rows.begin(), rows.end());
    const std::vector<int> special = ran.special();
    const auto isSpecial = [&](int line) {
        return std::find(special.begin(), special.end(), line) != special.end();
    };
    const auto turns = [&](const ProgramAssignment &each) {
        bool isTurned = false;
        bool isOfItself = false;
        for (std::size_t i = each.from; i < each.to; ++i) {
            isTurned = isTurned || isUnaryMinus(program, i) || program.is(i, "abs");
            isOfItself = isOfItself || program.tokens()[i].text == each.name;
        }
        return isTurned && isOfItself && each.name != QLatin1String("position");
    };
    int turned = 0;
    int placed = 0;
    bool isSet = false;
    bool isAnyTurned = false;
    for (const ProgramAssignment &each : assignments) {
        if (!ran.now.contains(each.line))
            continue;
        const bool isVelocity = each.isField && each.name == QLatin1String("velocity");
        if (isVelocity && isSpecial(each.line))
            return 0;
        isSet = isSet || isVelocity;
        isAnyTurned = isAnyTurned || turns(each);
        if (each.isField && each.name == QLatin1String("position"))
            placed = each.line;
        else if (isSpecial(each.line) && turns(each) && (turned == 0 || each.line < turned))
            turned = each.line;
    }
    // Who sets no velocity in a step does not do so where he sets the place.
    return isAnyTurned && !isSet && placed != 0 && !isSpecial(placed) ? placed : turned;
}

} // namespace cradle
