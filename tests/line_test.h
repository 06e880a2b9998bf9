// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/lab_test.h"
#include "tests/line_programs.h"

#include <string_view>

namespace cradle {

/// Which line of a program the first finding marks: rows of a right program, what is changed in it,
/// and whether that line is to be marked, or none.
class LineTest : public LabTest
{
protected:
    static void addColumns()
    {
        QTest::addColumn<QString>("step");
        QTest::addColumn<QString>("program");
        QTest::addColumn<QString>("right");
        QTest::addColumn<QString>("wrong");
        QTest::addColumn<bool>("marked");
    }

    /// \param program  one of line_programs.h
    static void row(const char *name, const char *program, const char *right, const char *wrong,
                    bool marked = true)
    {
        using namespace programs;
        const std::string_view given(program);
        const bool isWeighed = given == weighed;
        const bool isPart = given == angles || given == frame || given == rebounds;
        const char *step = isWeighed ? "L42T15" : given == rebounds ? "L42T16" : "L42T12";
        QString whole = QString::fromLatin1(program);
        if (isPart)
            whole += QString::fromLatin1(moves);
        if (given == rebounds) { // where that step asks for them
            whole.replace(QLatin1String("vec(-2, 2), vec(2, 0)"),
                          QLatin1String("vec(-2.5, 2), vec(1, 0)"));
            whole.replace(QLatin1String("vec(2, -2), vec(0, 2)"),
                          QLatin1String("vec(0, 2), vec(-1, 0)"));
        }
        rowOfStep(name, step, whole, right, wrong, marked);
    }
    static void rowOfStep(const char *name, const char *step, const QString &program,
                          const char *right, const char *wrong, bool marked = true)
    {
        QTest::newRow(name) << QString::fromLatin1(step) << program << QString::fromLatin1(right)
                            << QString::fromLatin1(wrong) << marked;
    }

    void compareLine()
    {
        QFETCH(QString, step);
        QFETCH(QString, program);
        QFETCH(QString, right);
        QFETCH(QString, wrong);
        QFETCH(bool, marked);
        const auto at = program.indexOf(right);
        QVERIFY(at >= 0);
        program.replace(at, right.size(), wrong);
        const Task &asked = task(step);
        const CheckReport report = *judgeTask(m_lab, asked, Submission(asked.preset, program), 1);
        QCOMPARE(report.passed, wrong == right);
        if (report.passed)
            return;
        QVERIFY(!report.findings.empty());
        const Finding &first = report.findings.front();
        const int wanted = marked ? int(program.left(at).count(QLatin1Char('\n'))) + 1 : 0;
        QVERIFY2(first.line == wanted,
                 qPrintable(QStringLiteral("%1 for %2: %3")
                                .arg(first.line)
                                .arg(wanted)
                                .arg(first.message.section(QLatin1Char('\n'), 0, 0))));
    }
};

} // namespace cradle
