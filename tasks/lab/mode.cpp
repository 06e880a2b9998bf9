// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab/mode.h"

#include <QRegularExpression>

namespace cradle {

namespace {

const QString both = QStringLiteral("all");

} // namespace

QString wordOf(Mode mode)
{
    return mode == Mode::Code ? QStringLiteral("code") : QStringLiteral("explore");
}

std::optional<Mode> modeFrom(const QString &word)
{
    for (const Mode mode : {Mode::Explore, Mode::Code})
        if (word == wordOf(mode))
            return mode;
    return std::nullopt;
}

QStringList partWords()
{
    return {wordOf(Mode::Explore), wordOf(Mode::Code), both};
}

QString textFor(Mode mode, const QString &markdown)
{
    static const QRegularExpression mark(
        QStringLiteral("^<!--\\s*(%1)\\s*-->\\s*$").arg(partWords().join(QLatin1Char('|'))));
    const QString own = wordOf(mode);
    QStringList kept;
    bool keeps = true;
    for (const QString &line : markdown.split(QLatin1Char('\n'))) {
        if (const auto match = mark.match(line); match.hasMatch())
            keeps = match.captured(1) == own || match.captured(1) == both;
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
