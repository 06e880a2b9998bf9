// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/text/program_diff.h"

#include "tasks/text/unified_diff.h"

#include <QStringList>

namespace cradle {

namespace {

const QString oldName = QStringLiteral("--- solution.lua");
const QString newName = QStringLiteral("+++ ");

QString withLineFeeds(QString text)
{
    return text.replace(QStringLiteral("\r\n"), QStringLiteral("\n"));
}

/// \p message as the comment that a program begins with, and the empty line after it.
QString commentOf(const QString &message)
{
    if (message.isEmpty())
        return {};
    QString comment;
    for (const QString &line : message.split(QLatin1Char('\n')))
        comment += line.isEmpty() ? QStringLiteral("--\n") : QStringLiteral("-- %1\n").arg(line);
    return comment + QLatin1Char('\n');
}

} // namespace

Result<QString> programFromDiff(const QString &diff, const QString &solution)
{
    const QStringList lines = withLineFeeds(diff).split(QLatin1Char('\n'));
    qsizetype names = lines.indexOf(oldName);
    while (names >= 0 && !lines.value(names + 1).startsWith(newName))
        names = lines.indexOf(oldName, names + 1);
    const qsizetype first = names < 0 ? lines.size() : names + 2; // without names all is text
    const QString message = lines.mid(0, names).join(QLatin1Char('\n')).trimmed();
    const Result<QString> changed =
        withDiff(withLineFeeds(solution), lines.mid(first).join(QLatin1Char('\n')));
    if (changed)
        return commentOf(message) + *changed;
    Error error = changed.error();
    error.line += static_cast<int>(first);
    return error;
}

QString diffOfProgram(const QString &program, const QString &solution, const QString &file)
{
    const QString message = firstCommentBlock(program);
    return (message.isEmpty() ? QString() : message + QStringLiteral("\n\n")) + oldName
           + QLatin1Char('\n') + newName + file + QLatin1Char('\n')
           + unifiedDiff(solution, withoutFirstComment(program));
}

QString withoutFirstComment(const QString &program)
{
    qsizetype at = 0;
    while (program.mid(at, 2) == QLatin1String("--")) {
        const qsizetype end = program.indexOf(QLatin1Char('\n'), at);
        at = end < 0 ? program.size() : end + 1;
    }
    if (at > 0 && program.mid(at, 1) == QLatin1String("\n"))
        ++at;
    return program.mid(at);
}

QString withCommentOf(const QString &solution, const QString &program)
{
    const QString rest = withoutFirstComment(program);
    const QString code = withoutFirstComment(solution);
    const bool follows = !rest.isEmpty() && code.startsWith(rest.section(QLatin1Char('\n'), 0, 0));
    if (code.size() == solution.size() || !follows)
        return program;
    return program.chopped(rest.size()) + solution.chopped(code.size()) + rest;
}

bool isWorthADiff(const QString &program, const QString &solution)
{
    const QString whole = withoutFirstComment(program);
    const QString diff = unifiedDiff(solution, whole);
    const qsizetype names = 2; // lines
    return !solution.isEmpty()
           && diff.count(QLatin1Char('\n')) + names < whole.count(QLatin1Char('\n'));
}

QString firstCommentBlock(const QString &source)
{
    QStringList lines;
    for (QString line : source.split(QLatin1Char('\n'))) {
        if (!line.startsWith(QLatin1String("--")))
            break;
        line.remove(0, 2);
        lines.append(line.startsWith(QLatin1Char(' ')) ? line.mid(1) : line);
    }
    return lines.join(QLatin1Char('\n')).trimmed();
}

} // namespace cradle
