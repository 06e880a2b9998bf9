// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/question_lines.h"

#include <QRegularExpression>

#include <algorithm>

namespace cradle {

int questionOf(Suspect suspect, const std::vector<int> &special, const QStringList &rows,
               const RanLines &ran, const RowRange &within, const AskedValues &asked, bool isOfPair)
{
    const auto isOne = [&](int line) {
        return compares(rows[line - 1]) && !(isOfPair && asksForWall(rows[line - 1]));
    };
    const auto fits = [&](int line) {
        return suspect == Suspect::Reach ? asked.asksReach(line) || asksForWall(rows[line - 1])
                                         : !asked.asksReach(line) || asked.isJoined(line);
    };
    std::vector<int> questions; // the likeliest first
    if (suspect == Suspect::Question || ran.before.empty()) {
        for (const int line : special) {
            if (isOne(line))
                questions.push_back(line);
        }
    }
    for (int line = special.front(); line >= within.first && !ran.before.empty(); --line) {
        if (ran.now.contains(line) && isOne(line))
            questions.push_back(line);
    }
    const auto best = std::find_if(questions.begin(), questions.end(), fits);
    return best != questions.end() ? *best : questions.empty() ? 0 : questions.front();
}

int askedIn(int question, Suspect suspect, const AskedValues &asked)
{
    // Another part of it may be what is wrong.
    if (suspect == Suspect::Question && asked.isJoined(question))
        return question;
    int found = 0;
    for (const AskedValue &value : asked.of(question)) {
        if (value.isReach != (suspect == Suspect::Reach))
            continue;
        if (found != 0 && found != value.line)
            return question;
        found = value.line;
    }
    return found == 0 ? question : found;
}

int conditionAbove(int line, const QStringList &rows, const RanLines &ran)
{
    static const QRegularExpression asks(QStringLiteral("\\b(else)?if\\b"));
    static const QRegularExpression goesOn(QStringLiteral("\\belseif\\b"));
    static const QRegularExpression then(QStringLiteral("\\bthen\\b"));
    static const QRegularExpression ends(QStringLiteral("\\bend\\b"));
    static const QRegularExpression closes(QStringLiteral("^\\s*end\\b"));
    int closed = 0;
    const int first = functionOf(rows, line).first;
    for (int at = line; at >= first; --at) {
        closed += at < line && rows[at - 1].contains(closes) ? 1 : 0;
        if (!rows[at - 1].contains(then) || !ran.now.contains(at))
            continue;
        const bool isOneLine = rows[at - 1].contains(ends);
        if (closed == 0 && (at == line || !isOneLine)) {
            // A question of several lines begins with the first.
            while (at > first && !rows[at - 1].contains(asks))
                --at;
            return at;
        }
        closed -= isOneLine || rows[at - 1].contains(goesOn) ? 0 : 1;
    }
    return 0;
}

int unledQuestion(Suspect suspect, const QStringList &rows, const RanLines &ran,
                  const AskedValues &asked)
{
    const auto isOne = [&](int line) {
        return line >= 1 && line <= rows.size() && compares(rows[line - 1])
               && !asksForWall(rows[line - 1]);
    };
    int found = 0;
    if (suspect != Suspect::Reach) {
        for (const int line : ran.special())
            found = isOne(line) ? line : found;
        if (found != 0)
            return found;
    }
    // Where nothing is answered, the only question for a distance is the one that said no.
    static const QRegularExpression equal(QStringLiteral("[^=~<>]==[^=]"));
    const auto isEquality = [&](int line) {
        return line >= 1 && line <= rows.size() && rows[line - 1].contains(equal);
    };
    for (const int line : ran.now) {
        if (!(isOne(line) || isEquality(line)) || !asked.asksReach(line))
            continue;
        if (found != 0)
            return 0;
        found = line;
    }
    return found == 0 ? 0 : askedIn(found, suspect, asked);
}

int avoidedLine(const ProgramLines &program, int line, bool verdict)
{
    const std::vector<ProgramToken> &tokens = program.tokens();
    std::size_t at = program.tokensOf(line).front();
    while (at < tokens.size() && !program.is(at, "then"))
        ++at;
    const std::size_t then = at + 1;
    std::size_t otherwise = 0;
    for (at = then; at < tokens.size() && !program.is(at, "end") && !program.is(at, "until");
         ++at) {
        if (opensBlock(program, at))
            at = endOfBlock(program, at);
        else if (program.is(at, "else"))
            otherwise = at + 1;
    }
    if (otherwise == 0)
        return 0;
    const int first = tokens[verdict ? otherwise : then].line;
    const int last = tokens[verdict ? at - 1 : otherwise - 1].line;
    for (const ProgramAssignment &each : assignmentsOf(program)) {
        if (each.line >= first && each.line <= last && each.line != line)
            return each.line;
    }
    return 0;
}

} // namespace cradle
