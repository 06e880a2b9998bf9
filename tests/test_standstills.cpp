// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/standstill.h"
#include "tasks/checks/substeps.h"

#include "tests/check_faults.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::programs::faults;

/// Who stands still behind a hit, and in how many parts a step is made: each at its bounds.
class TestStandstills : public QObject
{
    Q_OBJECT
private slots:
    void whoStandsStillIsTold_data();
    void whoStandsStillIsTold();
    void partsOfAStepAreCounted_data();
    void partsOfAStepAreCounted();
};

void TestStandstills::whoStandsStillIsTold_data()
{
    QTest::addColumn<Vec2>("place");    // of circle 2, hit in the first step
    QTest::addColumn<Vec2>("velocity"); // from then on
    QTest::addColumn<double>("share");  // of its way that it makes in the three steps behind
    QTest::addColumn<Circle>("other");
    QTest::addColumn<Vec2>("gravity");
    QTest::addColumn<bool>("isTold");
    const auto row = [](const char *name, bool isTold, Vec2 place, Vec2 velocity,
                        double share = 0.0, const Circle &other = {.position = {-2, -2}},
                        Vec2 gravity = {}) {
        QTest::newRow(name) << place << velocity << share << other << gravity << isTold;
    };
    row("in the open", true, {0, 0}, {1, 0});
    row("less than six tenths of its way", true, {0, 0}, {1, 0}, 0.59);
    row("more", false, {0, 0}, {1, 0}, 0.61);
    row("into a wall", false, {3.79, 0}, {1, 0});
    row("off a wall", true, {3.79, 0}, {-1, 0});
    row("along a wall", false, {3.79, 0}, {0, 1});
    // Three steps of gravity are 0.3 m/s.
    row("held at the floor", false, {0, -3.8}, {0, 0.29}, 0, {.position = {-2, -2}}, unitGravity);
    row("off the floor", true, {0, -3.8}, {0, 0.31}, 0, {.position = {-2, -2}}, unitGravity);
    row("slow in the air", false, {0, 0}, {0.29, 0}, 0, {.position = {-2, -2}}, unitGravity);
    row("into the other", false, {2, 2}, {1, 0}, 0, {.position = {2.45, 2}});
    row("off the other", true, {2, 2}, {-1, 0}, 0, {.position = {2.45, 2}});
    row("into one that goes on faster", true, {2, 2}, {1, 0}, 0,
        {.position = {2.41, 2}, .velocity = {1.5, 0}});
    row("far from the other", true, {2, 2}, {1, 0}, 0, {.position = {3, 2}});
}

void TestStandstills::whoStandsStillIsTold()
{
    QFETCH(Vec2, place);
    QFETCH(Vec2, velocity);
    QFETCH(double, share);
    QFETCH(Circle, other);
    QFETCH(Vec2, gravity);
    QFETCH(bool, isTold);
    const auto run = [&](int stays) {
        std::vector<Change> changes;
        for (int step = 1; step <= stays; ++step)
            changes.push_back({step, [=](Circles &c) {
                                   c[1].position = place + (step - 1) * share * h * velocity;
                                   c[1].velocity = velocity;
                               }});
        return drift({other, {.position = place, .velocity = -1.0 * velocity}}, changes, 1.2,
                     gravity);
    };
    const auto fault = motion::standstillAfter(run(4), 1, 0, gravity);
    QCOMPARE(fault.has_value(), isTold);
    // Who does so for good is told that by checks of the motion; who goes on in time is right.
    QVERIFY(place != Vec2{} || !motion::standstillAfter(run(12), 1, 0, gravity));
    QVERIFY(!motion::standstillAfter(run(3), 1, 0, gravity));
    if (!fault)
        return;
    QVERIFY(std::abs(*fault->expected - 0.3 * length(velocity)) < 1e-12);
    QVERIFY(std::abs(*fault->observed - 0.3 * share * length(velocity)) < 1e-12);
    QVERIFY(fault->message.startsWith(QStringLiteral("After a hit at step 1 circle 2 has")));
    QVERIFY(fault->message.contains(QStringLiteral("From there to step 4")));
    QCOMPARE(fault->step, 2);
    QCOMPARE(fault->circle, 1);
}

void TestStandstills::partsOfAStepAreCounted_data()
{
    QTest::addColumn<double>("share"); // of a Δt², in each step
    QTest::addColumn<double>("aside"); // m
    QTest::addColumn<double>("tolerance");
    QTest::addColumn<bool>("isOne");
    QTest::newRow("symplectic Euler") << 1.0 << 0.0 << 1e-9 << true;
    QTest::newRow("Euler") << 0.0 << 0.0 << 1e-9 << true;
    QTest::newRow("in two parts") << 0.75 << 0.0 << 1e-9 << true;
    QTest::newRow("Euler in three") << 1.0 / 3.0 << 0.0 << 1e-9 << true;
    QTest::newRow("in two and a half") << 0.7 << 0.0 << 1e-9 << false;
    QTest::newRow("exactly") << 0.5 << 0.0 << 1e-9 << false;
    QTest::newRow("in 999") << 0.5 + 0.5 / 999 << 0.0 << 1e-9 << true;
    QTest::newRow("in 1001") << 0.5 + 0.5 / 1001 << 0.0 << 1e-9 << false;
    // Two ten-thousandths of two parts are no other number of them.
    QTest::newRow("nearly two") << 0.5 + 0.5 / 2.00019 << 0.0 << 1e-3 << true;
    QTest::newRow("not quite two") << 0.5 + 0.5 / 2.00021 << 0.0 << 1e-3 << false;
    QTest::newRow("nearly two, measured well") << 0.5 + 0.5 / 2.00019 << 0.0 << 1e-8 << false;
    // A hundredth of 1 m and the 3 m from the middle.
    QTest::newRow("nearly beside") << 1.0 << 0.0399 << 0.01 << true;
    QTest::newRow("beside") << 1.0 << 0.0401 << 0.01 << false;
}

void TestStandstills::partsOfAStepAreCounted()
{
    QFETCH(double, share);
    QFETCH(double, aside);
    QFETCH(double, tolerance);
    QFETCH(bool, isOne);
    std::vector<Change> changes;
    for (int step = 1; step <= 2; ++step)
        changes.push_back({step, [=](Circles &c) {
                               // Symplectic Euler has come a Δt² down already.
                               c[1].position.y += (1.0 - share) * h * h;
                               c[1].position.x += step == 1 ? aside : 0.0;
                           }});
    const Observation o =
        drift(beside({.position = {0, 3}, .velocity = {1, 0}}), changes, 0.2, unitGravity);
    Substeps substeps;
    QCOMPARE(substeps.take(o, 1, 0, unitGravity, tolerance), isOne);
    QCOMPARE(substeps.take(o, 1, 1, unitGravity, tolerance), isOne);
    // Another share is none of the first's; without gravity there is nothing to share.
    Substeps first;
    const Observation other =
        drift(beside({.position = {0, 3}}), {changes.front()}, 0.2, unitGravity);
    (void)first.take(other, 1, 0, unitGravity, tolerance);
    QCOMPARE(first.take(other, 1, 1, unitGravity, tolerance),
             isOne && (share == 1.0 || tolerance > 1e-4));
    Substeps still;
    const Observation none = drift(beside({.position = {0, 3}, .velocity = {1, 0}}), {}, 0.1);
    QVERIFY(still.take(none, 1, 0, {}, tolerance));
}

QTEST_GUILESS_MAIN(TestStandstills)
#include "test_standstills.moc"
