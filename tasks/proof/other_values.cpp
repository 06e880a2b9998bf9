// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/proof/other_values.h"

#include "tasks/text/line_diff.h"
#include "tasks/text/program_diff.h"

#include <QRegularExpression>
#include <QStringList>

namespace cradle {

namespace {

/// A line as far as it does something.
QString codeOf(const QString &line)
{
    return line.section(QStringLiteral("--"), 0, 0).simplified();
}

/// The code with a mark in place of each number.
QString withoutNumbers(const QString &code)
{
    static const QRegularExpression number(
        QStringLiteral("(?<![\\w.])-?\\d+(?:\\.\\d*)?(?:[eE][+-]?\\d+)?"));
    return QString(code).replace(number, QStringLiteral("#"));
}

/// Lines that take the place of others.
struct Change {
    QStringList before{};
    QStringList after{};
};

std::vector<Change> changesOf(const QString &solution, const QString &program)
{
    std::vector<Change> changes;
    bool open = false;
    for (const DiffLine &line : lineDiff(solution, program)) {
        if (line.kind == DiffLine::Kind::Same) {
            open = false;
            continue;
        }
        if (codeOf(line.text).isEmpty())
            continue; // a comment does nothing
        if (!open)
            changes.emplace_back();
        open = true;
        (line.kind == DiffLine::Kind::Removed ? changes.back().before : changes.back().after)
            .append(codeOf(line.text));
    }
    return changes;
}

bool isOfNumbersAlone(const Change &change)
{
    if (change.before.size() != change.after.size())
        return false;
    for (qsizetype i = 0; i < change.before.size(); ++i) {
        if (withoutNumbers(change.before[i]) != withoutNumbers(change.after[i]))
            return false;
    }
    return true;
}

} // namespace

std::vector<OtherValue> otherValues(const QString &program, const QString &solution)
{
    std::vector<OtherValue> others;
    bool hasMistake = false;
    for (const Change &change : changesOf(solution, program)) {
        if (!isOfNumbersAlone(change)) {
            hasMistake = true;
            continue;
        }
        for (qsizetype i = 0; i < change.before.size(); ++i) {
            if (change.before[i] != change.after[i])
                others.push_back({change.after[i], change.before[i]});
        }
    }
    return hasMistake ? others : std::vector<OtherValue>();
}

} // namespace cradle
