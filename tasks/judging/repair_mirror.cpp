// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/repair_list.h"

#include <QHash>
#include <QRegularExpression>

#include <algorithm>

namespace cradle {

namespace {

/// Lines between what is said of one circle and of the other.
constexpr int near = 6;

/// What a name is of the other circle, or of the other coordinate; the name itself if it has no
/// partner in the program.
QString partnerOf(const ProgramLines &program, const QString &name, bool isCoordinate)
{
    static const QHash<QString, QString> words{{QStringLiteral("one"), QStringLiteral("two")},
                                               {QStringLiteral("two"), QStringLiteral("one")},
                                               {QStringLiteral("self"), QStringLiteral("other")},
                                               {QStringLiteral("other"), QStringLiteral("self")}};
    if (!isCoordinate && program.hasName(words.value(name)))
        return words.value(name);
    for (const auto &[one, two] :
         isCoordinate ? std::vector<std::pair<char, char>>{{'x', 'y'}}
                      : std::vector<std::pair<char, char>>{{'1', '2'}, {'a', 'b'}}) {
        QString partner = name;
        QChar &last = partner.back();
        if (last == QLatin1Char(one))
            last = QLatin1Char(two);
        else if (last == QLatin1Char(two))
            last = QLatin1Char(one);
        if (partner != name && program.hasName(partner))
            return partner;
    }
    return name;
}

/// A line, said of the other.
QString mirrored(const ProgramLines &program, int line, bool isCoordinate)
{
    const QString row = program.row(line);
    const qsizetype start = program.startOf(line);
    QString result;
    qsizetype done = 0;
    for (const std::size_t i : program.tokensOf(line)) {
        const ProgramToken &token = program.tokens()[i];
        const bool isIndex = !isCoordinate && token.kind == ProgramToken::Kind::Number && i > 0
                             && program.is(i - 1, "[") && program.is(i + 1, "]");
        QString text = token.text;
        if (token.kind == ProgramToken::Kind::Name)
            text = partnerOf(program, text, isCoordinate);
        else if (isIndex && (token.is("1") || token.is("2")))
            text = token.is("1") ? QStringLiteral("2") : QStringLiteral("1");
        result += row.mid(done, token.start - start - done) + text;
        done = token.end() - start;
    }
    return result + row.mid(done);
}

/// What a line gives a value or calls: up to the sign = or the bracket; empty for other lines.
QString headOf(const QString &row)
{
    static const QRegularExpression head(
        QStringLiteral("^\\s*((?:local\\s+)?[\\w.:,\\s\\[\\]]+(?:=(?!=)|\\())"));
    static const QRegularExpression other(QStringLiteral("^\\s*(if|elseif|for|while|return)\\b"));
    return row.contains(other) ? QString() : head.match(row).captured(1);
}

} // namespace

void repairMirror(RepairList &repairs, int line)
{
    const ProgramLines &program = repairs.program();
    const QString row = line < 1 || line > program.count() ? QString() : program.row(line);
    const QString head = headOf(row);
    if (head.isEmpty())
        return;
    for (int at = std::max(1, line - near); at <= std::min(program.count(), line + near); ++at) {
        for (const bool isCoordinate : {false, true}) {
            const QString other = mirrored(program, at, isCoordinate);
            if (at != line && other != program.row(at) && headOf(other) == head)
                repairs.replaceTelling(line, program.startOf(line),
                                       program.startOf(line) + row.size(), other);
        }
    }
}

} // namespace cradle
