// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"

#include <QTest>

/// Reports of each sort, of a step with two checks.
namespace cradle::reports {

inline CheckReport passed()
{
    CheckReport report{.labId = QStringLiteral("lab-4.2"),
                       .labHash = QStringLiteral("0123abcd"),
                       .taskId = QStringLiteral("L42T5"),
                       .seed = 7,
                       .passed = true,
                       .commit = QStringLiteral("L42T5 Integrating one circle using Euler "
                                                "integration and one using Symplectic Euler"),
                       .elapsedMs = 12};
    report.checks.push_back(
        {.id = QStringLiteral("walls"), .title = QStringLiteral("Walls"), .passed = true});
    report.checks.push_back({.id = QStringLiteral("circle1-euler"),
                             .title = QStringLiteral("Circle 1 still moves by Euler"),
                             .passed = true});
    return report;
}

inline CheckReport remarked()
{
    CheckReport report = passed();
    report.remarks.push_back(
        {.id = QStringLiteral("integer"),
         .message = QStringLiteral("Your 4/3 is 1\n\nThe position misses $\\frac{1}{2} g\\,\\Delta "
                                   "t^2$; look at:\n\n- the *division*\n- `//`\n\n```lua\nlocal "
                                   "a = 4 // 3\n```")});
    return report;
}

inline CheckReport failed()
{
    CheckReport report = passed();
    report.passed = false;
    CheckOutcome &check = report.checks[1];
    check.passed = false;
    check.message = QStringLiteral("At step 1 circle 1 moved by (0, -0.002725) m; by Euler it "
                                   "moves by (0, 0) m");
    check.expected = -0.002725;
    check.observed = 0.0;
    check.unit = QStringLiteral("m");
    check.step = 1;
    check.variant = QStringLiteral("throw 3, timestep 1/60 s");
    check.line = 17;
    return report;
}

inline CheckReport diagnosed()
{
    CheckReport report = failed();
    report.findings = {Finding{
        .mistake = QStringLiteral("both-symplectic"),
        .message = QStringLiteral(
            "Both circles switched\n\nAt $t = 2.9$ s circle 1 is where symplectic Euler puts it, "
            "with the velocity (2,\n0) m/s. Only circle 2 was to change: look at **which** circle "
            "your second formula moves."),
        .check = QStringLiteral("circle1-euler")}};
    return report;
}

/// The program has an error of syntax.
inline CheckReport unloadable()
{
    CheckReport report = passed();
    report.passed = false;
    report.error = ProgramError{.message = QStringLiteral("unexpected symbol near '='"),
                                .kind = ProgramError::Kind::Syntax,
                                .line = 3};
    for (CheckOutcome &check : report.checks) {
        check.passed = false;
        check.message = QStringLiteral("not judged: the program stopped with an error");
    }
    return report;
}

/// The program stopped in the scene of the second check.
inline CheckReport stopped()
{
    CheckReport report = passed();
    report.passed = false;
    report.error = ProgramError{.message = QStringLiteral("`speed` is nil, not a number"),
                                .line = 12,
                                .step = 40,
                                .time = 0.65,
                                .locals = {{QStringLiteral("dt"), QStringLiteral("0.0166667")}}};
    CheckOutcome &check = report.checks[1];
    check.passed = false;
    check.message = report.error->message;
    check.step = 40;
    check.variant = QStringLiteral("preset");
    return report;
}

/// A program may say what it likes where it calls error().
inline CheckReport odd()
{
    CheckReport report = stopped();
    QString word = QStringLiteral("<&>\"']]> \\ \u00fc \U0001F3B1 # TODO\nok 3\nBail out!\t");
    word += QChar(0);
    word += QChar(0x1b);
    word += QChar(0xd800);
    word += QChar(0xffff);
    report.error->message = word;
    report.checks[1].message = word;
    report.checks[0].title = word;
    return report;
}

/// A row for each sort, with what is hard to write.
inline void addReports()
{
    QTest::addColumn<CheckReport>("report");
    QTest::newRow("passed") << passed();
    QTest::newRow("passed with a remark") << remarked();
    QTest::newRow("failed") << failed();
    QTest::newRow("diagnosed") << diagnosed();
    QTest::newRow("does not load") << unloadable();
    QTest::newRow("stopped") << stopped();
    QTest::newRow("odd letters") << odd();
}

} // namespace cradle::reports
