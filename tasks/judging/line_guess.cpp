// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/line_guess.h"

#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <set>

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

/// The lines that run in the step of the moment, and in the one before.
struct Ran {
    std::set<int> now{};
    std::set<int> before{};

    /// Those that only the moment needs.
    [[nodiscard]] std::vector<int> special() const
    {
        std::vector<int> lines;
        std::set_difference(now.begin(), now.end(), before.begin(), before.end(),
                            std::back_inserter(lines));
        return lines;
    }
};

std::set<int> linesIn(const QString &program, const Moment &moment, qint64 step)
{
    Probe probe(&program, moment.stage);
    for (qint64 k = 1; k < step; ++k) {
        if (!probe.step())
            return {};
    }
    const std::vector<int> lines = probe.lines();
    return {lines.begin(), lines.end()};
}

/// The line that works out a mass; 0 if none is found.
int massLine(const QStringList &rows)
{
    static const QRegularExpression quantity(
        QStringLiteral("\\b(radius|density|volume|masse?)\\b"));
    static const QRegularExpression power(QStringLiteral("\\bpi\\b|\\^|\\bdensity\\b"));
    int best = 0;
    int most = 0;
    for (int i = 0; i < rows.size(); ++i) {
        const QString &row = rows[i];
        if (!row.contains(quantity) || !row.contains(power) || compares(row)
            || row.contains(QLatin1String("velocity")))
            continue;
        const int work = worksOut(row);
        if (work > most) {
            most = work;
            best = i + 1;
        }
    }
    return best;
}

/// The question that leads to the first of \p special.
int questionBefore(const std::vector<int> &special, const QStringList &rows, const Ran &ran)
{
    for (int line = special.front(); line > 0; --line) {
        if (ran.now.contains(line) && compares(rows[line - 1]))
            return line;
    }
    return 0;
}

int formulaIn(const std::vector<int> &lines, const QStringList &rows, int last)
{
    int best = last;
    int most = last > 0 ? worksOut(rows[last - 1]) : 0;
    for (const int line : lines) {
        if (const int work = worksOut(rows[line - 1]); work > most) {
            most = work;
            best = line;
        }
    }
    return best;
}

} // namespace

int guessedLine(const QString &program, const LawDeviation &deviation, int last)
{
    const QStringList rows = rowsOf(program);
    const auto isRow = [&](int line) { return line >= 1 && line <= rows.size(); };
    switch (deviation.suspect) {
    case Suspect::Omission:
        return 0;
    case Suspect::Masses:
        if (const int line = massLine(rows))
            return line;
        break;
    case Suspect::Answer:
        return last;
    case Suspect::Question:
    case Suspect::Formula:
        break;
    }
    if (deviation.moment.circles.empty() || !isRow(last))
        return last;
    const Moment &moment = deviation.moment;
    const Ran ran{linesIn(program, moment, moment.step),
                  moment.step > 1 ? linesIn(program, moment, moment.step - 1) : std::set<int>{}};
    const std::vector<int> special = ran.special();
    const bool isQuestion = deviation.suspect == Suspect::Question;
    if (special.empty() || !isRow(special.back()))
        return !isQuestion || compares(rows[last - 1]) ? last : 0;
    if (isQuestion) {
        const int line = questionBefore(special, rows, ran);
        return line == 0 ? last : line;
    }
    return formulaIn(special, rows, last);
}

} // namespace cradle
