// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/line_guess.h"

#include "tasks/judging/asked_values.h"
#include "tasks/judging/push_origin.h"

#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <iterator>

namespace cradle {

namespace {

/// The lines of \p program without comments.
QStringList rowsOf(const QString &program)
{
    QStringList rows = program.split(QLatin1Char('\n'));
    for (QString &row : rows)
        row = row.section(QLatin1String("--"), 0, 0);
    return rows;
}

bool compares(const QString &row)
{
    static const QRegularExpression sign(QStringLiteral("[<>]"));
    return row.contains(sign);
}

/// How much is worked out in a line: its operators, products most.
int worksOut(const QString &row)
{
    static const QRegularExpression assigns(QStringLiteral("(^|[^=<>~])=([^=]|$)|\\breturn\\b"));
    if (!row.contains(assigns) || row.contains(QLatin1String("position")))
        return 0;
    return 2 * static_cast<int>(row.count(QRegularExpression(QStringLiteral("[*/^]"))))
           + static_cast<int>(row.count(QRegularExpression(QStringLiteral("[-+]"))));
}

/// The line that works out a mass; 0 if none is found.
int massLine(const QString &source, const QStringList &rows)
{
    const ProgramLines program(source);
    const QStringList copies =
        copiesOf(program, {QStringLiteral("radius"), QStringLiteral("density")});
    const QString quantities =
        (QStringList{QStringLiteral("radius|density|volume|masse?")} + copies)
            .join(QLatin1Char('|'));
    const QString densities =
        (QStringList{QStringLiteral("density")} + copiesOf(program, {QStringLiteral("density")}))
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
        if (work > most) {
            most = work;
            best = i + 1;
        }
    }
    return best;
}

/// Those of \p lines that take e, or a copy of it; all, if none does.
std::vector<int> withRestitution(const std::vector<int> &lines, const QStringList &rows,
                                 const ProgramLines &program)
{
    const QStringList names = QStringList{QStringLiteral("restitution")}
                              + copiesOf(program, {QStringLiteral("restitution")});
    const QRegularExpression e(QStringLiteral("\\b(%1)\\b").arg(names.join(QLatin1Char('|'))));
    std::vector<int> found;
    std::copy_if(lines.begin(), lines.end(), std::back_inserter(found),
                 [&](int line) { return rows[line - 1].contains(e); });
    return found.empty() ? lines : found;
}

/// The line in which what is called a mass is given a value; 0 if there are several.
int namedMassLine(const QString &source)
{
    static const QRegularExpression mass(QStringLiteral("^m(ass(es)?)?_?(\\d|[abij]|one|two)?$"),
                                         QRegularExpression::CaseInsensitiveOption);
    const ProgramLines program(source);
    const std::set<int> dead = deadLines(program);
    int found = 0;
    for (const ProgramAssignment &each : assignmentsOf(program)) {
        const QStringList values = valuesIn(program, each.from, each.to);
        // What is worked out of masses is no circle's.
        if (!each.name.contains(mass) || each.line == found || dead.contains(each.line)
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

/// The only line of those that run at the moment that works an angle out of a
/// direction; 0 if there is none, or several.
int angleLine(const QStringList &rows, const RanLines &ran)
{
    static const QRegularExpression angle(QStringLiteral("\\bmath\\.(atan|asin|acos)\\b"));
    int found = 0;
    for (const int line : ran.now) {
        if (line < 1 || line > rows.size() || !rows[line - 1].contains(angle))
            continue;
        if (found != 0)
            return 0;
        found = line;
    }
    return found;
}

/// The lines of the function in which a line stands.
struct Lines {
    int first = 1;
    int last = 0;
};
Lines functionOf(const QStringList &rows, int line)
{
    static const QRegularExpression header(QStringLiteral("\\bfunction\\b"));
    static const QRegularExpression whole(QStringLiteral("\\bfunction\\b.*\\bend\\b"));
    const auto begins = [&](int at) {
        return rows[at - 1].contains(header) && !rows[at - 1].contains(whole);
    };
    Lines lines{line, line};
    while (lines.first > 1 && !begins(lines.first))
        --lines.first;
    while (lines.last < rows.size() && !begins(lines.last + 1))
        ++lines.last;
    return lines;
}

/// Who only hands a value on is not who worked it out.
int actingLine(const QStringList &rows, int last, const std::vector<int> &calls)
{
    static const QRegularExpression setter(
        QStringLiteral("\\bfunction\\b.*\\.(velocity|position)\\s*=\\s*\\w+\\s+end\\b"));
    return !calls.empty() && rows[last - 1].contains(setter) ? calls.back() : last;
}

/// Whether a line asks for a wall.
bool asksForWall(const QString &row)
{
    static const QRegularExpression wall(
        QStringLiteral("\\b(square|left|right|top|bottom|half_width)\\b"));
    return row.contains(wall);
}

/// The question that leads to the first of \p special, or that is among them: of those within a
/// function such as ask for a distance, or for more than that.
int questionOf(Suspect suspect, const std::vector<int> &special, const QStringList &rows,
               const RanLines &ran, const Lines &within, const AskedValues &asked)
{
    const auto fits = [&](int line) {
        return suspect == Suspect::Reach ? asked.asksReach(line) || asksForWall(rows[line - 1])
                                         : !asked.asksReach(line) || asked.isJoined(line);
    };
    std::vector<int> questions; // the likeliest first
    if (suspect == Suspect::Question || ran.before.empty()) {
        for (const int line : special) {
            if (compares(rows[line - 1]))
                questions.push_back(line);
        }
    }
    for (int line = special.front(); line >= within.first && !ran.before.empty(); --line) {
        if (ran.now.contains(line) && compares(rows[line - 1]))
            questions.push_back(line);
    }
    const auto best = std::find_if(questions.begin(), questions.end(), fits);
    return best != questions.end() ? *best : questions.empty() ? 0 : questions.front();
}

/// Where the value is worked out that a question asks, if it is one.
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

/// Whether a line takes what another, a local value, gives.
bool takes(const QString &row, const QString &giving)
{
    static const QRegularExpression local(QStringLiteral("^\\s*local\\s+(\\w+)\\s*="));
    const QRegularExpressionMatch match = local.match(giving);
    return match.hasMatch()
           && row.contains(QRegularExpression(QStringLiteral("\\b%1\\b").arg(match.captured(1))));
}

/// The condition of the block in which \p line stands; 0 if there is none in its function.
int conditionAbove(int line, const QStringList &rows, const RanLines &ran)
{
    static const QRegularExpression condition(QStringLiteral("\\bif\\b.*\\bthen\\b"));
    static const QRegularExpression closes(QStringLiteral("^\\s*end\\b"));
    int closed = 0;
    for (int at = line; at >= functionOf(rows, line).first; --at) {
        closed += at < line && rows[at - 1].contains(closes) ? 1 : 0;
        if (!rows[at - 1].contains(condition) || !ran.now.contains(at))
            continue;
        const bool isOneLine =
            rows[at - 1].contains(QRegularExpression(QStringLiteral("\\bend\\b")));
        if (closed == 0 && (at == line || !isOneLine))
            return at;
        closed -= isOneLine ? 0 : 1;
    }
    return 0;
}

/// The question about two circles that no answer leads to: the last that was asked for the first
/// time, which let them go on; of those for a reach the only one. 0 if there is none.
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
        return found;
    }
    for (const int line : ran.now) {
        if (!isOne(line) || !asked.asksReach(line))
            continue;
        if (found != 0)
            return 0;
        found = line;
    }
    return found == 0 ? 0 : askedIn(found, suspect, asked);
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
    const int last = assignment.line;
    const QStringList rows = rowsOf(program);
    if (const int line = deviation.topic == Topic::Direction ? angleLine(rows, ran) : 0)
        return line;
    const auto isRow = [&](int line) { return line >= 1 && line <= rows.size(); };
    const ProgramLines lines(program);
    switch (deviation.suspect) {
    case Suspect::Omission:
        return 0;
    case Suspect::Masses:
        if (const int line = massLine(program, rows))
            return line;
        if (const int line = namedMassLine(program))
            return line;
        break;
    case Suspect::Copy:
        if (const int line = copyLine(rows))
            return line;
        break;
    case Suspect::Kept:
        if (const int line = keepingLine(rows, ran))
            return line;
        break;
    case Suspect::Answer:
    case Suspect::Question:
    case Suspect::Reach:
    case Suspect::Formula:
        break;
    }
    if (deviation.moment.circles.empty() || !isRow(last))
        return last;
    const bool isOfPair =
        deviation.aspect == Aspect::Contact || deviation.aspect == Aspect::Response;
    Lines within;
    const auto specialAround = [&](int at) {
        within = functionOf(rows, at);
        std::vector<int> found = ran.special();
        std::erase_if(found, [&](int line) {
            return line < within.first || line > within.last || !isRow(line)
                   || (isOfPair && asksForWall(rows[line - 1]));
        });
        return found;
    };
    int acting = actingLine(rows, last, assignment.calls);
    std::vector<int> special = specialAround(acting);
    // Who writes both circles down where he answers their hit works the answer out before.
    const bool isBehind =
        special.empty()
        || (deviation.moment.circles.size() < 2 && deviation.aspect != Aspect::Response);
    if (assignment.origin && isBehind) {
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
        const int line =
            special.empty() ? 0 : questionOf(deviation.suspect, special, rows, ran, within, asked);
        if (line == 0 && !compares(rows[acting - 1]))
            return isOfPair ? unledQuestion(deviation.suspect, rows, ran, asked) : 0;
        const int question = line == 0 ? acting : line;
        const bool isReach = deviation.isEverywhere;
        const bool isShared = isReach || deviation.topic == Topic::Distance;
        if (const int value = isShared ? asked.valueBehind(question, isReach) : 0)
            return value;
        return askedIn(line == 0 ? acting : line, deviation.suspect, asked);
    }
    if (deviation.aspect == Aspect::Response && assignment.isSizeWrong()) {
        const PushOrigin push(lines, ran);
        if (const auto given = push.ofGiven(acting, assignment.calls))
            return *given;
        const int added = deviation.suspect == Suspect::Answer ? push.ofAdded(acting) : 0;
        // What the other circle takes, too, and leaves as it should, is right.
        const bool isRight =
            added > 0 && deviation.moment.circles.size() < 2
            && std::any_of(special.begin(), special.end(), [&](int line) {
                   return line != acting && line != added && takes(rows[line - 1], rows[added - 1]);
               });
        if (added > 0 && !isRight)
            return added;
    }
    if (special.empty())
        return acting;
    const bool isSpecial = std::find(special.begin(), special.end(), acting) != special.end();
    // What runs in every step only writes down what was worked out before.
    if (deviation.suspect == Suspect::Answer && (isSpecial || ran.before.empty()))
        return acting;
    if (deviation.topic == Topic::Restitution)
        special = withRestitution(special, rows, lines);
    const bool isAmong = std::find(special.begin(), special.end(), acting) != special.end();
    const int formula = formulaIn(special, rows, isAmong ? acting : 0);
    return formula == 0 ? acting : formula;
}

} // namespace cradle
