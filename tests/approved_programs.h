// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/approved_text.h"
#include "tests/sanitized.h"

#include "tasks/reading/lab_reader.h"
#include "tasks/text/unified_diff.h"

#include <QRegularExpression>
#include <QTest>

#include <utility>
#include <vector>

/// The programs of tests/approved, as test_approved_reports.cpp tells.
namespace cradle::approved {

/// What is wrong in a difference, and its hunks.
inline std::pair<QString, QString> readDiff(const QString &path)
{
    const QString text = read(path);
    const auto hunks =
        text.startsWith(QLatin1String("@@")) ? 0 : text.indexOf(QLatin1String("\n@@")) + 1;
    return {text.left(hunks), text.mid(hunks)};
}

/// The values of N; one empty where there are none.
inline QStringList valuesOf(const QString &path)
{
    static const QRegularExpression given(QStringLiteral("^N = (.+)$"),
                                          QRegularExpression::MultilineOption);
    const auto match = given.match(readDiff(path).first);
    return match.hasMatch() ? match.captured(1).split(QLatin1Char(' ')) : QStringList{QString()};
}

/// \return empty if the difference does not fit its program
inline QString readProgram(const QString &step, const QString &file, const QString &value)
{
    const QString folder = step + QLatin1Char('/');
    if (file.endsWith(QLatin1String(".lua")))
        return read(folder + file);
    const QString base = file.section(QLatin1Char('.'), 0, 0) + QStringLiteral(".lua");
    const auto program = withDiff(read(folder + base), readDiff(folder + file).second);
    if (!program || value.isEmpty())
        return program ? *program : QString();
    return QString(*program).replace(
        QRegularExpression(QStringLiteral("\\bN\\b")),
        value.startsWith(QLatin1Char('-')) ? QLatin1Char('(') + value + QLatin1Char(')') : value);
}

/// What it is called in the reports.
inline QString nameOf(const QString &file, const QString &value)
{
    return value.isEmpty() ? file : file + QStringLiteral(" N = ") + value;
}

/// A program and what it is called.
struct Program {
    QString name;
    QString source;
};

/// All programs of a step, those with N for each of its values.
inline std::vector<Program> programsOf(const QString &step)
{
    std::vector<Program> all;
    for (const QString &file : QDir(path(step)).entryList(QDir::Files, QDir::Name)) {
        if (file.endsWith(QLatin1String(".json")))
            continue;
        for (const QString &value : valuesOf(step + QLatin1Char('/') + file))
            all.push_back({nameOf(file, value), readProgram(step, file, value)});
    }
    return all;
}

/// Fails the test on Qt's warnings, as of a text with too many arguments: the process that judges
/// students' programs may not write, and ends.
inline void failOnWarnings()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".")));
}

/// A row "task" for every step of the shipped labs.
inline void addSteps()
{
    QTest::addColumn<Task>("task");
    int count = 0;
    for (const char *folder : {shippedLab, bouncingBallLab}) {
        const Result<Lab> lab = readLab(QLatin1String(folder));
        QVERIFY2(lab.ok(), lab ? "" : qPrintable(lab.error().toString()));
        for (const Task &task : lab->tasks) {
            if (++count % oneOf(5) == 0)
                QTest::newRow(qPrintable(task.id)) << task;
        }
    }
}

} // namespace cradle::approved
