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
enum class Rank { Told, Single, Roundabout, Called, Twins, Doubtful };

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

/// What a row gives a value, and the value; nothing if it does not.
std::optional<std::pair<QString, QString>> assignmentIn(const QString &row)
{
    const qsizetype sign = row.indexOf(u'=');
    if (sign < 0)
        return std::nullopt;
    QStringView target = QStringView(row).first(sign).trimmed();
    const QStringView value = QStringView(row).sliced(sign + 1).trimmed();
    const QLatin1String local("local");
    if (target.startsWith(local) && target.size() > local.size() && target[local.size()].isSpace())
        target = target.sliced(local.size()).trimmed();
    const bool isTarget = std::all_of(target.begin(), target.end(), [](QChar c) {
        return isOfName(c) || c.isSpace() || QLatin1String(".,[]").contains(c);
    });
    if (target.isEmpty() || !isTarget || value.isEmpty() || value.front() == u'=')
        return std::nullopt;
    return std::pair(target.toString(), value.toString());
}

Naming namingOf(const QString &row)
{
    static const std::pair<QChar, QChar> sides[] = {{QLatin1Char('1'), QLatin1Char('2')},
                                                    {QLatin1Char('a'), QLatin1Char('b')},
                                                    {QLatin1Char('x'), QLatin1Char('y')}};
    const auto given = assignmentIn(row);
    if (!given)
        return Naming::Silent;
    QStringList targets = partsOf(given->first);
    const QStringList values = partsOf(given->second);
    if (values.size() == 1)
        targets = {given->first};
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

/// Whether a line only takes what a function of the program returns.
bool isOfCall(const QString &row, const QStringList &functions)
{
    static const QRegularExpression call(QStringLiteral(
        "^\\s*(?:(?:local\\s+)?[\\w.,\\s\\[\\]]+=|if|return)\\s+(?:[\\w\\[\\]]+[.:])*(\\w+)"
        "\\([\\w.,\\s\\[\\]]*\\)(?:\\s+then)?\\s*$"));
    const QString called = call.match(row).captured(1);
    return !called.isEmpty() && functions.contains(called);
}

/// Whether two lines differ in more than names and numbers.
bool isOtherwise(const QString &row, const QString &changed)
{
    const auto rest = [](QString text) {
        return text.removeIf([](QChar c) { return isOfName(c); });
    };
    return rest(row) != rest(changed);
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

/// Whether \p row gives a value to what the next line gives another.
bool isOverwritten(const QStringList &rows, int line, const QString &row)
{
    const auto made = assignmentIn(row);
    const auto next = assignmentIn(rows.value(line));
    return made && next && made->first == next->first && !next->second.contains(made->first);
}

/// Whether a row asks for nothing any more.
bool saysVerdict(const QString &row)
{
    static const QRegularExpression verdict(QStringLiteral("\\bif (true|false) then\\b"));
    return (row.contains(QLatin1String("if true ")) || row.contains(QLatin1String("if false ")))
           && row.contains(verdict);
}

/// Whether a row adds a term twice, or takes it away twice.
bool isDoubled(const QString &row)
{
    static const QRegularExpression doubled(
        QStringLiteral("([-+] [\\w.]+( \\* [\\w.]+)*) ?\\1\\b"));
    return (row.count(QLatin1String("+ ")) > 1 || row.count(QLatin1String("- ")) > 1)
           && row.contains(doubled);
}

/// Whether a row gives numbers to names.
bool givesNumbers(const QString &row)
{
    static const QRegularExpression number(
        QStringLiteral("^\\s*(local\\s+)?\\w+(\\s*,\\s*\\w+)*\\s*=\\s*-?[\\d.]+(\\s*,\\s*-?[\\d.]+)"
                       "*\\s*(--.*)?$"));
    return row.contains(number);
}

/// The lines of a program before any is changed, and what hundreds of changes ask of them.
class Rows
{
public:
    explicit Rows(const QString &source)
        : m_program(source)
    {
        static const QRegularExpression writeBack(
            QStringLiteral("^\\s*[\\w.\\[\\]]+\\.(velocity|position)\\s*=\\s*\\w+\\s*(--.*)?$"));
        QStringList functions;
        for (const ProgramFunction &each : functionsOf(m_program))
            functions.append(each.name);
        for (const QString &row : m_program.rows())
            m_known.push_back({.naming = namingOf(row),
                               .givesNumbers = givesNumbers(row),
                               .writesBack = row.contains(writeBack),
                               .isOfCall = isOfCall(row, functions)});
    }

    /// The line of \p changed that \p repair is of.
    [[nodiscard]] QString rowOf(const Repair &repair) const
    {
        const QStringView whole(repair.source);
        const qsizetype start = m_program.startOf(repair.line);
        // What stands before it is nearly always as it was.
        const bool isSame = whole.startsWith(QStringView(m_program.source()).first(start));
        qsizetype from = isSame ? start : 0;
        for (int k = 1; k < repair.line && !isSame; ++k)
            from = whole.indexOf(u'\n', from) + 1;
        const qsizetype to = whole.indexOf(u'\n', from);
        return whole.sliced(from, (to < 0 ? whole.size() : to) - from).toString();
    }

    [[nodiscard]] Rank rankOf(const Repair &repair, bool isSound, bool triesNumbers) const
    {
        const QString &own = m_program.row(repair.line);
        const QString row = rowOf(repair);
        const Known &known = m_known[static_cast<std::size_t>(repair.line - 1)];
        const Naming naming = row == own ? known.naming : namingOf(row);
        const bool isDisagreement = known.naming == Naming::Disagrees;
        if ((!isDisagreement && naming == Naming::Disagrees)
            || isFirstOfTwo(m_program.rows(), repair.line, row))
            return Rank::Doubtful;
        if ((triesNumbers && known.givesNumbers && givesNumbers(row)) || repair.told
            || (isDisagreement && naming != Naming::Disagrees))
            return Rank::Told;
        if (isSound || (row.isEmpty() && known.writesBack) || saysVerdict(row) || isDoubled(row)
            || (known.writesBack && isOverwritten(m_program.rows(), repair.line, row)))
            return Rank::Doubtful;
        return !repair.alone                             ? Rank::Twins
               : known.isOfCall && isOtherwise(own, row) ? Rank::Called
               : repair.isRoundabout                     ? Rank::Roundabout
                                                         : Rank::Single;
    }

private:
    struct Known {
        Naming naming;
        bool givesNumbers;
        bool writesBack;
        bool isOfCall;
    };

    ProgramLines m_program;
    std::vector<Known> m_known{};
};

} // namespace

void putInOrder(std::vector<Repair> &repairs, const QString &source, const std::set<int> &sound,
                bool triesNumbers)
{
    const Rows rows(source);
    std::vector<std::pair<Rank, Repair>> ranked;
    for (Repair &repair : repairs) {
        const Rank rank = rows.rankOf(repair, sound.contains(repair.line), triesNumbers);
        repair.isDoubtful = rank == Rank::Doubtful;
        ranked.emplace_back(rank, std::move(repair));
    }
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const auto &a, const auto &b) { return a.first < b.first; });
    std::transform(ranked.begin(), ranked.end(), repairs.begin(),
                   [](auto &each) { return std::move(each.second); });
}

} // namespace cradle
