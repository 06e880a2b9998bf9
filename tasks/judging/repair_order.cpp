// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/repair_order.h"

#include "tasks/judging/repair_list.h"

#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <iterator>

namespace cradle {

namespace {

/// Whose a value is, by its names: of the first, of the second, of both or of nobody.
enum class Side { Nobody, First, Second, Both };
/// Whether the names of what is given and of what gets it tell of the same.
enum class Naming { Silent, Agrees, Disagrees };

/// The likelier a repair is what was meant, the sooner it is tried.
enum class Rank { Told, Single, Called, Twins, Doubtful };

bool isOfName(QChar c)
{
    return (c.unicode() < 128 && c.isLetterOrNumber()) || c == QLatin1Char('_');
}

Side sideOf(const QString &text, QChar first, QChar second)
{
    constexpr qsizetype shortName = 3;
    bool isFirst = false;
    bool isSecond = false;
    for (qsizetype at = 0, end = 0; at < text.size(); at = end) {
        end = at + 1;
        if (!isOfName(text[at]) || text[at].isDigit())
            continue;
        while (end < text.size() && isOfName(text[end]))
            ++end;
        const QStringView word = QStringView(text).mid(at, end - at);
        const bool ends = first.isDigit() || word.size() <= shortName || word.back().isUpper()
                          || word[word.size() - 2] == QLatin1Char('_');
        isFirst = isFirst || (ends && word.back().toLower() == first);
        isSecond = isSecond || (ends && word.back().toLower() == second);
    }
    return isFirst && isSecond ? Side::Both
           : isFirst           ? Side::First
           : isSecond          ? Side::Second
                               : Side::Nobody;
}

/// The parts of a list, without the commas between brackets.
QStringList partsOf(const QString &list)
{
    QStringList parts{QString()};
    int depth = 0;
    for (const QChar c : list) {
        depth += c == QLatin1Char('(') || c == QLatin1Char('{') ? 1 : 0;
        depth -= c == QLatin1Char(')') || c == QLatin1Char('}') ? 1 : 0;
        if (c == QLatin1Char(',') && depth == 0)
            parts.append(QString());
        else
            parts.back() += c;
    }
    return parts;
}

Naming namingOf(const QString &row)
{
    static const QRegularExpression assignment(
        QStringLiteral("^\\s*(?:local\\s+)?([\\w.\\s,\\[\\]]+?)\\s*=\\s*([^=].*)$"));
    static const std::pair<QChar, QChar> sides[] = {{QLatin1Char('1'), QLatin1Char('2')},
                                                    {QLatin1Char('a'), QLatin1Char('b')},
                                                    {QLatin1Char('x'), QLatin1Char('y')}};
    const QRegularExpressionMatch match = assignment.match(row);
    if (!match.hasMatch())
        return Naming::Silent;
    QStringList targets = partsOf(match.captured(1));
    const QStringList values = partsOf(match.captured(2));
    if (values.size() == 1)
        targets = {match.captured(1)};
    Naming naming = Naming::Silent;
    for (qsizetype k = 0; k < targets.size() && k < values.size(); ++k) {
        for (const auto &[first, second] : sides) {
            const Side to = sideOf(targets[k], first, second);
            const Side of = sideOf(values[k], first, second);
            const auto isOne = [](Side side) {
                return side == Side::First || side == Side::Second;
            };
            if (!isOne(to) || !isOne(of))
                continue;
            if (to != of)
                return Naming::Disagrees;
            naming = Naming::Agrees;
        }
    }
    return naming;
}

/// Whether a line only takes what a function of the program returns, and \p changed takes something
/// else than other names: then what is returned may be changed as well.
bool isOfCall(const QString &row, const QString &changed, const QStringList &functions)
{
    static const QRegularExpression call(QStringLiteral(
        "^\\s*(?:(?:local\\s+)?[\\w.,\\s\\[\\]]+=|if|return)\\s+(?:[\\w\\[\\]]+[.:])*(\\w+)"
        "\\([\\w.,\\s\\[\\]]*\\)(?:\\s+then)?\\s*$"));
    static const QRegularExpression name(QStringLiteral("\\w+"));
    const QString called = call.match(row).captured(1);
    if (called.isEmpty() || !functions.contains(called))
        return false;
    return QString(row).remove(name) != QString(changed).remove(name);
}

/// Whether a line stands twice, where only one is meant for the second or none at all, and this is
/// the other.
bool isFirstOfTwo(const QStringList &rows, int line, const QString &changed)
{
    constexpr int nearby = 8;
    const QString row = rows.value(line - 1);
    if (changed.isEmpty())
        return rows.value(line) == row;
    const auto stands = [&](int step) {
        for (int at = line - 1 + step; std::abs(at - line + 1) <= nearby; at += step) {
            if (rows.value(at) == row)
                return true;
        }
        return false;
    };
    return std::any_of(std::begin(circleEnds), std::end(circleEnds), [&](const auto &ends) {
        const Side was = sideOf(row, QLatin1Char(ends.first), QLatin1Char(ends.second));
        const Side is = sideOf(changed, QLatin1Char(ends.first), QLatin1Char(ends.second));
        return (was == Side::First && is == Side::Second && stands(1))
               || (was == Side::Second && is == Side::First && stands(-1));
    });
}

QString rowOf(const QString &source, int line)
{
    qsizetype from = 0;
    for (int k = 1; k < line; ++k)
        from = source.indexOf(QLatin1Char('\n'), from) + 1;
    const qsizetype to = source.indexOf(QLatin1Char('\n'), from);
    return source.mid(from, to < 0 ? -1 : to - from);
}

} // namespace

void putInOrder(std::vector<Repair> &repairs, const QString &source, const std::set<int> &sound,
                bool triesNumbers)
{
    static const QRegularExpression verdict(QStringLiteral("\\bif (true|false) then\\b"));
    static const QRegularExpression number(
        QStringLiteral("^\\s*(local\\s+)?\\w+(\\s*,\\s*\\w+)*\\s*=\\s*-?[\\d.]+(\\s*,\\s*-?[\\d.]+)"
                       "*\\s*(--.*)?$"));
    static const QRegularExpression writeBack(
        QStringLiteral("^\\s*[\\w.\\[\\]]+\\.(velocity|position)\\s*=\\s*\\w+\\s*(--.*)?$"));
    static const QRegularExpression doubled(
        QStringLiteral("([-+] [\\w.]+( \\* [\\w.]+)*) ?\\1\\b"));
    const QStringList rows = source.split(QLatin1Char('\n'));
    QStringList functions;
    const ProgramLines program(source);
    for (const ProgramFunction &each : functionsOf(program))
        functions.append(each.name);
    std::vector<Naming> namings;
    std::transform(rows.begin(), rows.end(), std::back_inserter(namings), namingOf);
    const auto rankOf = [&](const Repair &repair) {
        const auto index = static_cast<std::size_t>(repair.line - 1);
        const Naming before = namings[index];
        const QString row = rowOf(repair.source, repair.line);
        const Naming after = row == rows[repair.line - 1] ? before : namingOf(row);
        if (before != Naming::Disagrees && after == Naming::Disagrees)
            return Rank::Doubtful;
        if (isFirstOfTwo(rows, repair.line, row))
            return Rank::Doubtful;
        if (triesNumbers && row.contains(number) && rows[repair.line - 1].contains(number))
            return Rank::Told;
        if (repair.told || (before == Naming::Disagrees && after != Naming::Disagrees))
            return Rank::Told;
        const bool isDropped = row.isEmpty() && rows[repair.line - 1].contains(writeBack);
        const bool isLast = isDropped || row.contains(verdict) || row.contains(doubled)
                            || sound.contains(repair.line);
        if (isLast)
            return Rank::Doubtful;
        return !repair.alone                                     ? Rank::Twins
               : isOfCall(rows[repair.line - 1], row, functions) ? Rank::Called
                                                                 : Rank::Single;
    };
    std::vector<std::pair<Rank, Repair>> ranked;
    for (Repair &repair : repairs) {
        const Rank rank = rankOf(repair);
        repair.isDoubtful = rank == Rank::Doubtful;
        ranked.emplace_back(rank, std::move(repair));
    }
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const auto &a, const auto &b) { return a.first < b.first; });
    std::transform(ranked.begin(), ranked.end(), repairs.begin(),
                   [](auto &each) { return std::move(each.second); });
}

} // namespace cradle
