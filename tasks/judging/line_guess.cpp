// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/line_guess.h"

#include "tasks/judging/called_lines.h"
#include "tasks/judging/lone_lines.h"
#include "tasks/judging/push_origin.h"
#include "tasks/judging/question_lines.h"
#include "tasks/judging/telling_lines.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Who only hands a value on is not who worked it out.
int actingLine(const ProgramLines &program, int last, const std::vector<int> &calls)
{
    return !calls.empty() && appliesGiven(program, last) ? calls.back() : last;
}

/// Those of \p lines that give both circles what \p acting gives one, and those from which these
/// have it, from one to the next: what only led to the question whether there is a hit is not the
/// formula of its answer.
std::vector<int> leadingTo(int acting, const std::vector<int> &lines, const ProgramLines &program)
{
    const std::vector<ProgramAssignment> assignments = assignmentsOf(program);
    QStringList given;
    for (const ProgramAssignment &each : assignments) {
        if (each.line == acting)
            given += each.name;
    }
    QStringList needed;
    std::vector<int> found;
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
        bool leads = *line == acting;
        for (const ProgramAssignment &each : assignments) {
            if (each.line != *line
                || !(leads || needed.contains(each.name)
                     || (each.isField && given.contains(each.name))))
                continue;
            leads = true;
            needed += valuesIn(program, each.from, each.to);
        }
        if (leads)
            found.insert(found.begin(), *line);
    }
    return found;
}

/// The line with most work; of those with as much the one that goes on with the others.
int formulaIn(const std::vector<int> &lines, const QStringList &rows, int last)
{
    int best = last;
    int most = last > 0 ? worksOut(rows[last - 1]) : 0;
    for (const int line : lines) {
        const int work = worksOut(rows[line - 1]);
        if (work > most || (best > 0 && work == most && takes(rows[line - 1], rows[best - 1]))) {
            most = work;
            best = line;
        }
    }
    return best;
}

/// The only line of \p lines in which something is multiplied by the number \p times, or divided
/// by that which is one by it; of two that do the same to one circle and the other the first. 0 if
/// there is none, or several.
int factorLine(double times, const std::vector<int> &lines, const ProgramLines &program,
               const QStringList &rows)
{
    constexpr double blur = 0.02;
    const auto isNear = [](double a, double b) { return std::abs(a - b) < blur * std::abs(b); };
    if (std::abs(times) < blur || isNear(times, 1.0))
        return 0;
    const auto makesIt = [&](std::size_t i) {
        bool isNumber = false;
        const double number = program.tokens()[i].text.toDouble(&isNumber);
        const bool isFactor =
            program.is(i + 1, "*") || (i > 0 && program.is(i - 1, "*") && !program.is(i + 1, "^"));
        return isNumber
               && ((isFactor && isNear(number, times))
                   || (i > 0 && program.is(i - 1, "/") && isNear(1.0 / number, times)));
    };
    int found = 0;
    for (const int line : lines) {
        const std::vector<std::size_t> &tokens = program.tokensOf(line);
        if (worksOut(rows[line - 1]) == 0 || !std::any_of(tokens.begin(), tokens.end(), makesIt))
            continue;
        const std::vector<int> twins = program.twinsOf(line);
        if (found != 0 && std::find(twins.begin(), twins.end(), found) == twins.end())
            return 0;
        found = found == 0 ? line : found;
    }
    return found;
}

/// Where the push of a hit is worked out.
struct PushedLine {
    std::optional<int> line{}; ///< 0 if that is not known
    bool isAdded = false;      ///< the line that only applies it adds it
};

/// \param acting   the line that applies it
/// \param isAdded  whether what is added there may have been worked out wrong
PushedLine pushLine(const LastAssignment &assignment, int acting, const std::vector<int> &special,
                    const ProgramLines &lines, const QStringList &rows, const RanLines &ran,
                    bool isAdded)
{
    const HitAtMoment hit = assignment.hit();
    const PushOrigin push(lines, ran);
    const bool isSizeWrong = hit.isSizeWrong();
    const auto times = hit.timesRight();
    if (const int factor = times ? factorLine(*times, special, lines, rows) : 0)
        return {factor};
    const bool areBothWrong = hit.wrongCircles().size() == 2;
    if (const int shared = areBothWrong ? push.ofShared(acting, isSizeWrong) : 0)
        return {shared};
    if (const auto given = isSizeWrong ? push.ofGiven(acting, assignment.calls) : std::nullopt)
        return {given};
    const int added = isSizeWrong && isAdded ? push.ofAdded(acting) : 0;
    return added > 0 ? PushedLine{added, true} : PushedLine{};
}

/// The same as guessedLine(), of what stands in one function.
int actedLine(const QString &program, const LawDeviation &deviation, const RanLines &ran,
              const LastAssignment &assignment)
{
    const int last = assignment.line;
    const QStringList rows = rowsOf(program);
    const ProgramLines lines(program);
    if (const int line = tellingLine(deviation, lines, rows, ran, last, assignment.isSound))
        return line;
    if (deviation.suspect == Suspect::Omission || deviation.suspect == Suspect::Begun)
        return 0;
    const auto isRow = [&](int line) { return line >= 1 && line <= rows.size(); };
    if (deviation.moment.circles.empty() || !isRow(last))
        return last;
    const bool isOfPair =
        deviation.aspect == Aspect::Contact || deviation.aspect == Aspect::Response;
    RowRange within;
    const auto specialAround = [&](int at) {
        within = functionOf(rows, at);
        std::vector<int> found = ran.special();
        std::erase_if(found, [&](int line) {
            return line < within.first || line > within.last || !isRow(line)
                   || (isOfPair && asksForWall(rows[line - 1]));
        });
        return found;
    };
    int acting = actingLine(lines, last, assignment.calls);
    std::vector<int> special = specialAround(acting);
    // What the other circle takes, too, and leaves as it should, is right.
    const auto isRightForOther = [&](int value) {
        return deviation.moment.circles.size() < 2
               && std::any_of(special.begin(), special.end(), [&](int line) {
                      return line != acting && line != value
                             && takes(rows[line - 1], rows[value - 1]);
                  });
    };
    // Who writes both circles down where he answers their hit works the answer out before.
    const bool isBehind =
        special.empty()
        || (deviation.moment.circles.size() < 2 && deviation.aspect != Aspect::Response);
    const bool isWithin =
        assignment.origin && !isOfQuestion(deviation.suspect)
        && std::find(special.begin(), special.end(), *assignment.origin) != special.end()
        && !isRightForOther(*assignment.origin);
    if (assignment.origin && (isBehind || isWithin)) {
        acting = *assignment.origin;
        if (acting == 0)
            return isOfPair && isOfQuestion(deviation.suspect)
                       ? unledQuestion(deviation.suspect, rows, ran, AskedValues(lines))
                       : 0;
        // At a wall that is all there is.
        if (!isOfPair && !isOfQuestion(deviation.suspect))
            return acting;
        special = specialAround(acting);
    }
    if (deviation.aspect == Aspect::Motion && deviation.suspect == Suspect::Question) {
        const int condition = conditionAbove(last, rows, ran);
        return condition == 0 ? last : condition;
    }
    if (isOfQuestion(deviation.suspect)) {
        const AskedValues asked(lines);
        // Where all lines run for the first time, the first question is any.
        const int condition = !isOfPair && ran.before.empty() ? conditionAbove(last, rows, ran) : 0;
        if (condition != 0)
            return askedIn(condition, deviation.suspect, asked);
        const int line = special.empty() ? 0
                                         : questionOf(deviation.suspect, special, rows, ran, within,
                                                      asked, isOfPair);
        if (line == 0 && !compares(rows[acting - 1]))
            return isOfPair ? unledQuestion(deviation.suspect, rows, ran, asked) : 0;
        const int question = line == 0 ? acting : line;
        const bool isReach = deviation.isEverywhere;
        const bool isShared = isReach || deviation.topic == Topic::Distance;
        if (const int value = isShared ? asked.valueBehind(question, isReach) : 0)
            return value;
        return askedIn(line == 0 ? acting : line, deviation.suspect, asked);
    }
    const bool isAnswer = deviation.suspect == Suspect::Answer;
    if (deviation.aspect == Aspect::Response) {
        const bool isAdded = isAnswer || deviation.topic == Topic::Shares;
        const PushedLine push = pushLine(assignment, acting, special, lines, rows, ran, isAdded);
        const bool isRight =
            push.line && *push.line > 0 && *push.line != acting && assignment.isSound(*push.line);
        if (push.line && !isRight && !(push.isAdded && isRightForOther(*push.line)))
            return *push.line;
    }
    if (special.empty())
        return acting;
    const bool isSpecial = std::find(special.begin(), special.end(), acting) != special.end();
    // What runs in every step only writes down what was worked out before.
    if (isAnswer && (isSpecial || ran.before.empty()))
        return acting;
    if (deviation.topic == Topic::Restitution)
        special = withRestitution(special, rows, lines);
    // What is known to be right is no wrong formula.
    for (;;) {
        const bool isAmong = std::find(special.begin(), special.end(), acting) != special.end();
        const int formula = isAmong ? formulaIn(leadingTo(acting, special, lines), rows, acting)
                                    : formulaIn(special, rows, 0);
        if (formula == 0 || formula == acting || !assignment.isSound(formula))
            return formula == 0 ? acting : formula;
        std::erase(special, formula);
    }
}

} // namespace

int hidingLine(const QString &program, Assignment::Field field)
{
    static const QRegularExpression gravity(QStringLiteral("^\\s*local\\s+gravity\\s*="));
    static const QRegularExpression restitution(QStringLiteral("^\\s*local\\s+restitution\\s*="));
    const bool isGravity = field == Assignment::Field::Gravity;
    if (!isGravity && field != Assignment::Field::Restitution)
        return 0;
    const QStringList rows = rowsOf(program);
    for (int line = 1; line <= rows.size(); ++line) {
        if (rows[line - 1].contains(isGravity ? gravity : restitution))
            return line;
    }
    return 0;
}

int guessedLine(const QString &program, const LawDeviation &deviation, const RanLines &ran,
                const LastAssignment &assignment)
{
    const int line = actedLine(program, deviation, ran, assignment);
    const ProgramLines lines(program);
    if (line == 0 && deviation.suspect == Suspect::Question)
        return lineOfWall(deviation, lines);
    for (const int other :
         {unwrittenTurn(deviation, lines, ran), askedOfFunction(deviation, lines, line),
          assignment.isOfOne ? callForOne(deviation, lines, line) : 0}) {
        if (other != 0)
            return other;
    }
    const bool isFormula =
        deviation.suspect == Suspect::Answer || deviation.suspect == Suspect::Formula;
    if (deviation.aspect != Aspect::Response || !isFormula || line <= 0)
        return line;
    // What is wrong with one circle alone is not in what both call.
    const int called = PushOrigin(lines, ran).ofCalled(line);
    return called != 0 && assignment.hit().wrongCircles().size() == 2 && !assignment.isSound(called)
               ? called
               : line;
}

} // namespace cradle
