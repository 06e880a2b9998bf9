// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/unread_field.h"

#include "tests/lab_test.h"

#include "tasks/judging/judgement.h"

using namespace cradle;

/// A field that is set in place of what moves a circle stops no program, and is told.
class TestUnreadField : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void whatNothingReadsIsFound_data();
    void whatNothingReadsIsFound();
    void findingTellsIt();
};

void TestUnreadField::whatNothingReadsIsFound_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("meant");
    const auto row = [](const char *program, const char *name, const char *meant) {
        QTest::addRow("%s", program) << QString::fromLatin1(program) << QString::fromLatin1(name)
                                     << QString::fromLatin1(meant);
    };
    row("local x = 1\ncircle1.pos = vec(0, 0)", "pos", "position");
    row("local x = 1\nc.Vel, x = vec(0, 0), 2", "Vel", "velocity");
    row("local x = 1\ncircles[1].rad = 0.3 c.position = vec(1, 1)", "rad", "radius");
    row("local x = 1\nc.pos = vec(0, 0) c.position = c.pos", "", "");
    row("local x = 1\nc.position = vec(0, 0) c.po = 1 c.post = 2 c.old = 3", "", "");
    row("local x = 1\nlocal pos = vec(0, 0)", "", "");
}

void TestUnreadField::whatNothingReadsIsFound()
{
    QFETCH(QString, program);
    QFETCH(QString, name);
    QFETCH(QString, meant);
    const auto found = unreadField(program);
    QCOMPARE(found.has_value(), !name.isEmpty());
    if (found)
        QCOMPARE(*found, (UnreadField{2, name, meant}));
}

void TestUnreadField::findingTellsIt()
{
    const Task &of = task(QStringLiteral("L42T2"));
    const auto report = judgeTask(
        m_lab, of,
        Submission(of.preset,
                   QStringLiteral("function on_load()\n  circle1.velocity = vec(2, 0)\nend\n"
                                  "function on_update(dt)\n"
                                  "  circle1.pos = circle1.position + circle1.velocity * dt\n"
                                  "end\n")),
        1);
    QCOMPARE(report->findings.size(), std::size_t{1});
    QCOMPARE(report->findings[0].line, 5);
    QVERIFY(report->findings[0].message.endsWith(
        QStringLiteral("Line 5 sets a field `pos` of your own, which nothing reads: a circle has a "
                       "`position`.\n\nUntil this is right, no more can be said of the walls.")));
}

QTEST_GUILESS_MAIN(TestUnreadField)
#include "test_unread_field.moc"
