// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab/mode.h"

#include <QRegularExpression>

namespace cradle {

QString textFor(Mode mode, const QString &markdown)
{
    static const QRegularExpression mark(QStringLiteral("^<!--\\s*(explore|code|all)\\s*-->\\s*$"));
    const QString own = mode == Mode::Code ? QStringLiteral("code") : QStringLiteral("explore");
    QStringList kept;
    bool keeps = true;
    for (const QString &line : markdown.split(QLatin1Char('\n'))) {
        if (const auto match = mark.match(line); match.hasMatch())
            keeps = match.captured(1) == own || match.captured(1) == QLatin1String("all");
        else if (keeps)
            kept.append(line);
    }
    return kept.join(QLatin1Char('\n'));
}

Task taskFor(Mode mode, Task task)
{
    task.instructions = textFor(mode, task.instructions);
    if (mode == Mode::Code && !task.codeHints.isEmpty())
        task.hints = task.codeHints;
    return task;
}

} // namespace cradle
