// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/work_bound.h"

#include <QTest>

using namespace cradle;

/// The work that a text promises at most, to the instruction; of some it promises nothing.
class TestWorkEstimate : public QObject
{
    Q_OBJECT
private slots:
    void loopsRunAsOftenAsTheyAreWritten_data();
    void loopsRunAsOftenAsTheyAreWritten();
};

void TestWorkEstimate::loopsRunAsOftenAsTheyAreWritten_data()
{
    QTest::addColumn<QByteArray>("program");
    QTest::addColumn<qint64>("bound");
    const auto row = [](const char *program, qint64 bound) {
        QTest::newRow(program) << QByteArray(program) << bound;
    };
    const auto none = [&](const char *program) { row(program, -1); };
    none("for i = 1, 1000 do end");
    none("function t.f() end");
    none("circles = x");
    none("f(circles)");
    none("end");
    none("for 1 = 1, 2 do end");
    none("for circles = 1, 2 do end");
    none("for ipairs = 1, 2 do end");
    none("function f() end for f = 1, 2 do end");
    none("for i, circles in ipairs(circles) do end");
    none("for i = n, 2 do end");
    none("for i = 1 + 2 do end");
    none("for i = 1, #t do end");
    none("for i = 1, #circles - n do end");
    none("for i = 1, #circles + 1 do end");
    none("for i = 1, 2 + 3 do end");
    none("for i = 1, 2 do for j = i - 1, 2 do end end");
    none("for i = 1, 2 do for j = i + n, 2 do end end");
    none("for i = 1, 2 do for j = n, 2 do end end");
    none("for i = 1, 2 do end for j = i, 2 do end");
    none("for i = 1, 2 do function f() for j = i, 2 do end end end");
    for (const char *name : {"i", "circle", "("}) {
        none(qPrintable(QStringLiteral("for i, c in %1(circles) do end").arg(QLatin1String(name))));
        none(qPrintable(QStringLiteral("for i, c in ipairs(%1) do end").arg(QLatin1String(name))));
    }
    none("for i = 1, 2 do f(i) i, x = 1, 2 for j = i, 2 do end end");
    none("for i = 1, 2 do x = {i} i, x = 1, 2 for j = i, 2 do end end");
    row("x = #circles", 3 + 4 * 3);
    row("circles[1] = x", 3 + 6 * 3);
    // What is spoken of in a call or a table is not set there.
    row("for i = 1, 2 do for j = i, 2 do f(i, j) end end",
        3 + 3 + 3 * (6 + 4) + 3 * (3 + 3 * (6 + 4) + 3 * (3 * 6 + 3) + 3));
    row("for i = 1, 2 do x = {i, 1} for j = i, 2 do end end",
        3 + 3 + 3 * (6 + 4) + 3 * (3 * 7 + 3 + 3 * (6 + 4) + 3 * 3 + 3));
    row("for i = 1, 2 do if x then for j = i, 2 do end end end",
        3 + 3 + 3 * (6 + 4) + 3 * (3 * 3 + 3 + 3 * (6 + 4) + 3 * 3 + 3 + 3));
    // Three a token, and three for the return of the file or function that has most.
    row("", 3);
    row("x = 1", 3 + 3 * 3);
    row("function f() end", 3 + 3 * 3);
    row("function f() end f()", 3 + 4 * 3 + 12); // and what it calls
    // "for", the six tokens to "do", a time for each number from 0 and two more; "end" as often as
    // there are numbers.
    row("for i = 1, 0 do end", 3 + 3 + 3 * (6 + 2) + 3 * 1);
    row("for i = 1, 7 do end", 3 + 3 + 3 * (6 + 9) + 3 * 8);
    row("for i = 1, 10 do end", 3 + 3 + 3 * (6 + 12) + 3 * 11);
    row("for i = 1, 29 do end", 3 + 3 + 3 * (6 + 31) + 3 * 30);
    row("for i = 1, 999 do end", 3 + 3 + 3 * (6 + 1001) + 3 * 1000);
    row("for i = 1, 3 do for j = i + 1, 4 do end end",
        3 + 3 + 3 * (6 + 5) + 4 * (3 + 3 * (8 + 6) + 5 * 3 + 3));
    // Of two circles.
    row("for i = 1, #circles do end", 3 + 3 + 3 * (7 + 4) + 3 * 3);
    row("for i = 1, #circles - 1 do end", 3 + 3 + 3 * (9 + 4) + 3 * 3);
    row("for i, c in ipairs(circles) do end", 3 + 3 + 3 * (9 + 4) + 3 * 3);
}

void TestWorkEstimate::loopsRunAsOftenAsTheyAreWritten()
{
    QFETCH(QByteArray, program);
    const std::string_view text(program.constData(), static_cast<std::size_t>(program.size()));
    QTEST(workBound(text, 2).value_or(-1), "bound");
}

QTEST_APPLESS_MAIN(TestWorkEstimate)
#include "test_work_estimate.moc"
