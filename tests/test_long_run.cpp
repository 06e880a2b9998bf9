// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/long_run.h"

#include "tests/law_programs.h"

using namespace cradle;
using namespace cradle::programs;

/// A run in which circles are set anew is believed only where the program goes on from there.
class TestLongRun : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void whoKeepsAStateToItselfIsNotFollowed_data();
    void whoKeepsAStateToItselfIsNotFollowed();
};

void TestLongRun::whoKeepsAStateToItselfIsNotFollowed_data()
{
    QTest::addColumn<QString>("before"); // the start of a run
    QTest::addColumn<QString>("step");
    QTest::addColumn<bool>("isFollowed");
    const char *free = "c.velocity = c.velocity + gravity * dt "
                       "c.position = c.position + c.velocity * dt";
    QTest::newRow("goes on") << "" << free << true;
    QTest::newRow("falls twice as fast")
        << ""
        << "c.velocity = c.velocity + 2 * gravity * dt c.position = c.position + c.velocity * dt"
        << true;
    QTest::newRow("own place") << "local p = c.position"
                               << "p = p + c.velocity * dt c.position = p" << false;
    QTest::newRow("own velocity")
        << "local v = c.velocity"
        << "v = v + gravity * dt c.velocity = v c.position = c.position + v * dt" << false;
    QTest::newRow("own speed, other way")
        << "local v = c.velocity"
        << "c.velocity = -1 * v c.position = c.position - v * dt" << false;
}

void TestLongRun::whoKeepsAStateToItselfIsNotFollowed()
{
    QFETCH(const QString, before);
    QFETCH(const QString, step);
    QFETCH(const bool, isFollowed);
    const LawBench bench(task(QStringLiteral("L42T3")));
    const QString program =
        QStringLiteral("local c = circle1 %1 function on_update(dt) %2 end").arg(before, step);
    Preset scene = bench.ground.stage();
    scene.gravity = {0.0, -9.81};
    for (PresetCircle &circle : scene.circles) {
        circle.body.position = {2.0, 1.0}; // m, far from where circles wait
        circle.body.velocity = {6.0, 2.2}; // m/s
    }
    LongRun run(&program, bench.ground, scene);
    run.wait(0.5);
    QCOMPARE(run.runs(), isFollowed);
    if (isFollowed)
        QVERIFY(run.time() >= 0.5);
}

QTEST_GUILESS_MAIN(TestLongRun)
#include "test_long_run.moc"
