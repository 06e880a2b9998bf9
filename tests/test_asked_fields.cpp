// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/asked_fields.h"

#include "tests/script_run.h"

using namespace cradle;
using namespace cradle::programs;

/// Fields of a program's own that it asks for before they are set.
class TestAskedFields : public QObject
{
    Q_OBJECT
private slots:
    void whatIsAskedForIsFound_data();
    void whatIsAskedForIsFound();
    void askedForItIsNil_data();
    void askedForItIsNil();
    void readOtherwiseItIsMissed_data();
    void readOtherwiseItIsMissed();
};

void TestAskedFields::whatIsAskedForIsFound_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<bool>("found");
    const auto row = [](const char *line, bool found) {
        QTest::newRow(line) << lua(line) << found;
    };
    row("c.mass = c.mass or 2", true);
    row("c.mass, n = c.mass or 2, 1", true);
    row("n, c.mass = 1, c.mass or 2", true);
    row("a[i].mass, c.b = c.mass and 2, 1", true);
    row("if c.mass then x = 1 end c.mass = 2", true);
    row("if not c.mass then c.mass = 2 end", true);
    row("if not a[i + 1].mass then c.mass = 2 end", true);
    row("if c.mass == nil then c.mass = 2 end", true);
    row("if nil == c.mass then c.mass = 2 end", true);
    row("if nil ~= c.mass and d then c.mass = 2 end", true);
    row("x = n == 0 and c.mass c.mass = 2", false);
    row("c.mass = 2 x = c.mass", false);
    row("c.mass = 2 x = not d c.mass = 3", false);
    row("c.mass = 2 x = c.mass * 2", false);
    row("c.mass = 2 x = not a * c.mass", false);
    row("if c.mass == nil then c.mss = 2 end", false);
    row("if f(c.mass, d) == 1 then x = c.mass or 2 end", false);
    row("if not mass then c.mass = 2 end", false);
}

void TestAskedFields::whatIsAskedForIsFound()
{
    QFETCH(QString, line);
    QFETCH(bool, found);
    const AskedFields asked(QStringLiteral("-- first\n") + line);
    QCOMPARE(asked.contains(2, QStringLiteral("mass")), found);
    QVERIFY(!asked.contains(1, QStringLiteral("mass")));
    QVERIFY(!asked.contains(2, QStringLiteral("c")));
    QVERIFY(!AskedFields().contains(2, QStringLiteral("mass")));
}

void TestAskedFields::askedForItIsNil_data()
{
    QTest::addColumn<QString>("program");
    QTest::newRow("worked out once") << lua("local function mass(c)\n"
                                            "  c.mass = c.mass or 3\n"
                                            "  return c.mass\n"
                                            "end\n"
                                            "print(mass(circle1) + mass(circle1))");
    QTest::newRow("a flag") << lua("for i = 1, 3 do\n"
                                   "  if not circles[1].late then circle1.late = 0 end\n"
                                   "  circle1.late = circle1.late + 2\n"
                                   "end\n"
                                   "print(circle1.late)");
}

void TestAskedFields::askedForItIsNil()
{
    QFETCH(QString, program);
    const ScriptRun run = runScript(program + QStringLiteral("\nfunction on_update(h) end\n"));
    QVERIFY2(!run.error, run.say());
    QCOMPARE(run.output.text, QString(QStringLiteral("6\n")));
}

void TestAskedFields::readOtherwiseItIsMissed_data()
{
    QTest::addColumn<QString>("program");
    QTest::newRow("set too late") << lua(
        "print(2 * circle1.mass)\ncircle1.mass = circle1.mass or 2");
    QTest::newRow("set nowhere") << lua("\nif not circle1.mass then circle1.mas = 2 end");
}

void TestAskedFields::readOtherwiseItIsMissed()
{
    QFETCH(QString, program);
    const ScriptRun run = runScript(program);
    QVERIFY(run.error);
    QVERIFY2(run.error->message.contains(QStringLiteral("circle1 has no field `mass`")), run.say());
}

QTEST_GUILESS_MAIN(TestAskedFields)
#include "test_asked_fields.moc"
