// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/repair_list.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <map>

namespace cradle {

namespace {

/// Lines between what is said of one circle and of the other.
constexpr int nearLines = 6;

/// What a name is of the other circle, or of the other coordinate; the name itself if it has no
/// partner in the program.
QString partnerOf(const RepairList &repairs, const QString &name, bool isCoordinate)
{
    if (!isCoordinate) {
        const QString partner = repairs.partnerOf(name);
        return partner.isEmpty() ? name : partner;
    }
    QString partner = name;
    QChar &last = partner.back();
    if (last == QLatin1Char('x'))
        last = QLatin1Char('y');
    else if (last == QLatin1Char('y'))
        last = QLatin1Char('x');
    return repairs.program().hasName(partner) ? partner : name;
}

/// What stands in a line from place \p from of the source to \p to, said of the other.
QString mirrored(const RepairList &repairs, int line, qsizetype from, qsizetype to,
                 bool isCoordinate)
{
    const ProgramLines &program = repairs.program();
    QString result;
    qsizetype done = from;
    for (const std::size_t i : program.tokensOf(line)) {
        const ProgramToken &token = program.tokens()[i];
        if (token.start < from || token.end() > to)
            continue;
        const bool isIndex = !isCoordinate && token.kind == ProgramToken::Kind::Number
                             && program.is(i - 1, "[") && program.is(i + 1, "]");
        QString text = token.text;
        if (token.kind == ProgramToken::Kind::Name)
            text = partnerOf(repairs, text, isCoordinate);
        else if (isIndex && (token.is("1") || token.is("2")))
            text = token.is("1") ? QStringLiteral("2") : QStringLiteral("1");
        result += program.source().mid(done, token.start - done) + text;
        done = token.end();
    }
    return result + program.source().mid(done, to - done);
}

/// A line with the signs of its sums turned round, outside of brackets: a push on the other circle
/// points the other way.
QString opposed(const QString &row)
{
    QString turned = row;
    int depth = 0;
    bool isBehindOperand = false;
    for (qsizetype at = row.indexOf(QLatin1Char('=')) + 1; at < row.size(); ++at) {
        const QChar c = row[at];
        depth += c == QLatin1Char('(') || c == QLatin1Char('[') ? 1 : 0;
        depth -= c == QLatin1Char(')') || c == QLatin1Char(']') ? 1 : 0;
        if (depth == 0 && isBehindOperand && (c == QLatin1Char('+') || c == QLatin1Char('-')))
            turned[at] = QLatin1Char(c == QLatin1Char('+') ? '-' : '+');
        if (!c.isSpace())
            isBehindOperand = c.isLetterOrNumber() || c == QLatin1Char('_') || c == QLatin1Char(')')
                              || c == QLatin1Char(']');
    }
    return turned;
}

/// Tokens \p from to \p to without \p to.
struct Value {
    std::size_t from;
    std::size_t to;
};

/// What `return A, B` gives back.
std::vector<Value> returnedAt(const RepairList &repairs, int line)
{
    std::vector<Value> values;
    for (const std::size_t i : repairs.program().tokensOf(line)) {
        if (!repairs.is(i, "return"))
            continue;
        std::size_t from = i + 1;
        std::size_t to = afterExpression(repairs.program(), from);
        for (; to > from; from = to + 1, to = afterExpression(repairs.program(), from)) {
            values.push_back({from, to});
            if (!repairs.is(to, ","))
                break;
        }
    }
    return values;
}

/// Of `local f1, f2 = A, B` or `return A, B` the one value as the other has it.
void mirrorWithin(RepairList &repairs, int line)
{
    std::vector<Value> both = returnedAt(repairs, line);
    for (const ProgramAssignment &each : repairs.assignments()) {
        if (each.line == line && each.from < each.to)
            both.push_back({each.from, each.to});
    }
    if (both.size() != 2)
        return;
    const auto &tokens = repairs.tokens();
    const auto startOf = [&](const Value &each) { return tokens[each.from].start; };
    const auto endOf = [&](const Value &each) { return tokens[each.to - 1].end(); };
    for (const bool isCoordinate : {false, true}) {
        for (const auto &[to, as] : {std::pair(both[1], both[0]), std::pair(both[0], both[1])}) {
            const QString own =
                repairs.program().source().mid(startOf(as), endOf(as) - startOf(as));
            const QString other = mirrored(repairs, line, startOf(as), endOf(as), isCoordinate);
            if (other != own)
                repairs.replaceTelling(line, startOf(to), endOf(to), other);
        }
    }
}

/// What a line gives a value or calls: up to the sign = or the bracket; empty for other lines.
QString headOf(const QString &row)
{
    static const QRegularExpression head(
        QStringLiteral("^\\s*((?:local\\s+)?[\\w.:,\\s\\[\\]]+(?:=(?!=)|\\())"));
    static const QRegularExpression other(QStringLiteral("^\\s*(if|elseif|for|while|return)\\b"));
    return row.contains(other) ? QString() : head.match(row).captured(1);
}

/// What a line says, said of the other.
struct Mirrored {
    QString row{}; ///< empty where it names nothing that has another
    QString head{};
};

/// The lines of a program as they are said of the other circle and of the other coordinate; of each
/// it is asked for many others.
class Mirrors
{
public:
    explicit Mirrors(const RepairList &repairs)
        : m_repairs(repairs)
    {
    }

    const std::array<Mirrored, 2> &of(int line)
    {
        const auto known = m_known.find(line);
        if (known != m_known.end())
            return known->second;
        return m_known.emplace(line, std::array{made(line, false), made(line, true)}).first->second;
    }

private:
    [[nodiscard]] Mirrored made(int line, bool isCoordinate) const
    {
        const ProgramLines &program = m_repairs.program();
        const qsizetype start = program.startOf(line);
        const QString &row = program.row(line);
        const QString other = mirrored(m_repairs, line, start, start + row.size(), isCoordinate);
        return other == row ? Mirrored() : Mirrored{other, headOf(other)};
    }

    const RepairList &m_repairs;
    std::map<int, std::array<Mirrored, 2>> m_known{};
};

void repairMirror(RepairList &repairs, Mirrors &mirrors, int line)
{
    const ProgramLines &program = repairs.program();
    const QString row = line < 1 || line > program.count() ? QString() : program.row(line);
    const QString head = headOf(row);
    if (head.isEmpty())
        return mirrorWithin(repairs, line);
    for (int at = std::max(1, line - nearLines); at <= std::min(program.count(), line + nearLines);
         ++at) {
        if (at == line)
            continue;
        for (const Mirrored &other : mirrors.of(at)) {
            if (other.head != head)
                continue;
            for (const QString &said : {other.row, opposed(other.row)})
                repairs.replaceTelling(line, program.startOf(line),
                                       program.startOf(line) + row.size(), said);
        }
    }
    mirrorWithin(repairs, line);
}

} // namespace

void repairMirrors(RepairList &repairs, const std::vector<int> &lines)
{
    Mirrors mirrors(repairs);
    for (const int line : lines)
        repairMirror(repairs, mirrors, line);
}

} // namespace cradle
