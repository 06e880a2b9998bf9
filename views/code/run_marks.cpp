// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/run_marks.h"

#include <algorithm>
#include <array>

namespace cradle {

namespace {

constexpr QChar leftToRight(0x200E);
constexpr QChar isolateFromTheRight(0x2067);
constexpr QChar endOfIsolate(0x2069);
constexpr std::array<QChar, 3> marks{isolateFromTheRight, endOfIsolate, leftToRight};

bool isFromTheRight(QChar letter)
{
    const QChar::Direction direction = letter.direction();
    return direction == QChar::DirR || direction == QChar::DirAL
           || direction == QChar::DirNSM; // vowels
}

/// What no run goes beyond: a string ends there, or the line.
bool endsRun(QChar letter)
{
    return letter == QLatin1Char('"') || letter == QLatin1Char('\'') || letter == QLatin1Char('\n');
}

} // namespace

bool needsRunMarks(const QString &text)
{
    return std::any_of(text.begin(), text.end(), isFromTheRight);
}

bool isWithinRunMarks(const QString &before)
{
    return before.count(isolateFromTheRight) > before.count(endOfIsolate);
}

QString withRunMarks(const QString &program)
{
    const QString plain = withoutRunMarks(program);
    if (!needsRunMarks(plain))
        return plain;
    QString marked;
    marked.reserve(plain.size() + plain.size() / 8);
    for (qsizetype i = 0; i < plain.size();) {
        if (!isFromTheRight(plain[i])) {
            marked += plain[i++];
            continue;
        }
        qsizetype end = i; // behind the last letter of the run; between, there may be any
        for (qsizetype k = i; k < plain.size() && !endsRun(plain[k]); ++k) {
            if (isFromTheRight(plain[k]))
                end = k + 1;
        }
        marked += isolateFromTheRight + plain.mid(i, end - i) + endOfIsolate + leftToRight;
        i = end;
    }
    return marked;
}

QString withoutRunMarks(QString program)
{
    for (const QChar mark : marks)
        program.remove(mark);
    return program;
}

} // namespace cradle
