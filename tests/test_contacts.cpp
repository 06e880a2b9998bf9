// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/contacts.h"

#include "tests/check_faults.h"

using namespace cradle;
using namespace cradle::motion;
using namespace cradle::programs;
using namespace cradle::programs::faults;

/// What an observation tells of contacts, worked out by hand: circles of 0.2 m, steps of 0.1 s.
class TestContacts : public QObject
{
    Q_OBJECT
private slots:
    void nearestIsThatOfTheStep_data();
    void nearestIsThatOfTheStep();
    void normalsAreThoseOfBothSteps();
    void velocitiesAreThoseWithoutGravity();
    void whatWallsGiveIsLeftOut_data();
    void whatWallsGiveIsLeftOut();
    void whatWallsGiveFirstHidesNoLaterContact();
    void threeStatesInsideAreMissed();
    void whoPartsInsideIsSeen_data();
    void whoPartsInsideIsSeen();
};

namespace {

std::vector<Circle> two(Vec2 placeA, Vec2 velocityA, Vec2 placeB, Vec2 velocityB)
{
    return {{.position = placeA, .velocity = velocityA},
            {.position = placeB, .velocity = velocityB}};
}

/// Both have these velocities after that step.
std::vector<Change> kick(int step, Vec2 a, Vec2 b)
{
    return {{step, [a, b](Circles &c) {
                 c[0].velocity = a;
                 c[1].velocity = b;
             }}};
}

bool isAt(Vec2 a, Vec2 b)
{
    return length(a - b) < 1e-12;
}

} // namespace

void TestContacts::nearestIsThatOfTheStep_data()
{
    QTest::addColumn<std::vector<Circle>>("circles");
    QTest::addColumn<double>("distance"); ///< of the centres, m
    const auto row = [](const char *name, Vec2 velocityA, Vec2 placeB, Vec2 velocityB,
                        double distance) {
        QTest::newRow(name) << two({}, velocityA, placeB, velocityB) << distance;
    };
    row("at rest", {}, {1, 0}, {}, 1.0);
    row("parting: at the start", {-1, 0}, {1, 0}, {1, 0}, 1.0);
    row("closing: at the end", {1, 0}, {1, 0}, {-1, 0}, 0.8);
    row("passing fast: on the way", {15, 0}, {1, 0.7}, {-5, 0}, 0.7);
    row("passing slowly: on the way", {0.5, 0}, {0.03, 0.7}, {0, 0}, 0.7);
    row("passing across", {0, 6}, {0.7, 0.5}, {0, -4}, 0.7);
    row("side by side: the first moved before the second", {5, 0}, {1, 0}, {5, 0}, 0.5);
    row("side by side: the second moved before the first", {-5, 0}, {1, 0}, {-5, 0}, 0.5);
}

void TestContacts::nearestIsThatOfTheStep()
{
    QFETCH(std::vector<Circle>, circles);
    QFETCH(double, distance);
    const auto contacts = contactsOf(drift(circles, kick(1, {0, 9}, {0, 9}), 0.2), 0, 1, {});
    QCOMPARE(contacts.size(), std::size_t{1});
    QCOMPARE(contacts[0].step, 0);
    QCOMPARE(contacts[0].nearest, distance - 0.4);
}

/// From (1, 1) to (1, 0.8) m and (0.9, 0.8) m between the centres, with steps of (0.1, 0) and
/// (0, -0.2) m: (0.8, 0.6) m were both moved.
void TestContacts::normalsAreThoseOfBothSteps()
{
    const auto circles = two({}, {1, 0}, {1, 1}, {0, -2});
    const auto contacts = contactsOf(drift(circles, kick(2, {}, {}), 0.3), 0, 1, {});
    QCOMPARE(contacts.size(), std::size_t{1});
    QCOMPARE(contacts[0].step, 1);
    QVERIFY(isAt(contacts[0].normalFirst, normalized(Vec2{1.0, 1.0})));
    QVERIFY(isAt(contacts[0].normalLast, {0.8, 0.6}));
    QVERIFY(isAt(contacts[0].normalA, normalized(Vec2{0.8, 0.8})));
    QVERIFY(isAt(contacts[0].normalB, normalized(Vec2{0.9, 0.6})));
    // Before the first step there is none.
    const auto first = contactsOf(drift(circles, kick(1, {}, {}), 0.2), 0, 1, {});
    QCOMPARE(first.size(), std::size_t{1});
    QVERIFY(isAt(first[0].normalFirst, normalized(Vec2{1.0, 1.0})));
    QVERIFY(isAt(first[0].normalA, normalized(Vec2{0.9, 1.0})));
}

void TestContacts::velocitiesAreThoseWithoutGravity()
{
    const auto contacts = contactsOf(
        drift(two({}, {1, 0}, {1, 0}, {-1, 0}), kick(2, {-2, 0.5}, {3, 0.25}), 0.3, unitGravity), 0,
        1, unitGravity);
    QCOMPARE(contacts.size(), std::size_t{1});
    QVERIFY(isAt(contacts[0].beforeA, {1, -0.1}));
    QVERIFY(isAt(contacts[0].beforeB, {-1, -0.1}));
    QVERIFY(isAt(contacts[0].afterA, {-2, 0.6}));
    QVERIFY(isAt(contacts[0].afterB, {3, 0.35}));
}

/// Circle 1 is 0.05 m from the right wall, at 3.75 m.
void TestContacts::whatWallsGiveIsLeftOut_data()
{
    QTest::addColumn<Vec2>("placeB");
    QTest::addColumn<Vec2>("velocityB");
    QTest::addColumn<Vec2>("afterA");
    QTest::addColumn<Vec2>("afterB");
    QTest::addColumn<bool>("isContact");
    const auto row = [](const char *name, Vec2 placeB, Vec2 velocityB, Vec2 afterA, Vec2 afterB,
                        bool isContact) {
        QTest::newRow(name) << placeB << velocityB << afterA << afterB << isContact;
    };
    row("turned by the wall, far from the other", {0, 0}, {}, {-1, 0}, {}, false);
    row("turned aslant, far from the other", {0, 0}, {}, {-1, 0.5}, {}, false);
    row("turned by the wall, beside the other", {3.3, 0}, {}, {-1, 0}, {}, false);
    row("turned aslant, beside the other", {3.3, 0}, {}, {-1, 0.5}, {}, true);
    row("pushed into the wall", {3.3, 0}, {}, {2, 0}, {}, true);
    row("pushed a little into the wall", {3.3, 0}, {}, {1.5, 0}, {}, true);
    row("turned aslant by rounding", {3.3, 0}, {}, {-1, 2.9e-9}, {}, false);
    row("turned aslant by more", {3.3, 0}, {}, {-1, 3.1e-9}, {}, true);
    row("turned, but did not come to it", {3.75, 0.45}, {}, {1, 0}, {-1, 0}, true);
    row("the other is pushed, too", {3.3, 0}, {}, {-1, 0}, {-1, 0}, true);
    row("the other alone", {3.3, 0}, {}, {1, 0}, {-1, 0}, true);
    row("each by a wall, far away", {-3.75, 0}, {-1, 0}, {-1, 0}, {1, 0}, false);
    row("each by the same wall", {3.75, 0.45}, {1, 0}, {-1, 0}, {-1, 0}, false);
    row("the other in the open, far away", {0, 0}, {}, {-1, 0}, {1, 0}, true);
}

void TestContacts::whatWallsGiveIsLeftOut()
{
    QFETCH(Vec2, placeB);
    QFETCH(Vec2, velocityB);
    QFETCH(Vec2, afterA);
    QFETCH(Vec2, afterB);
    QFETCH(bool, isContact);
    const auto isSeen = [&](int a, int b) {
        const Circle one{.position = {3.75, 0}, .velocity = {1, 0}};
        const Circle other{.position = placeB, .velocity = velocityB};
        const Observation o = drift({one, other}, kick(1, afterA, afterB), 0.2);
        const auto contacts = contactsOf(o, a, b, {});
        return contacts.size() == 1 && contacts[0].step == 0
               && isBesideWall(o, a, b, contacts[0], {});
    };
    QCOMPARE(isSeen(0, 1), isContact);
    QCOMPARE(isSeen(1, 0), isContact);
}

void TestContacts::whatWallsGiveFirstHidesNoLaterContact()
{
    std::vector<Change> changes = kick(1, {-1, 0}, {});
    changes.push_back(kick(2, {1, 0}, {-1, 0}).front());
    const auto circles = two({3.75, 0}, {1, 0}, {3.3, 0}, {});
    const auto contacts = contactsOf(drift(circles, changes, 0.3), 0, 1, {});
    QCOMPARE(contacts.size(), std::size_t{1});
    QCOMPARE(contacts[0].step, 1);
}

/// They come 0.05 m nearer in each step.
void TestContacts::threeStatesInsideAreMissed()
{
    const auto missed = [](double distance, const std::vector<Change> &changes,
                           double duration = 0.8) {
        return missedContact(drift(two({}, {0.5, 0}, {distance, 0}, {}), changes, duration), 0, 1);
    };
    QCOMPARE(missed(0.43, {}, 0.3), 1); // by its very last state
    QCOMPARE(missed(0.43, {}, 0.2), -1);
    QCOMPARE(missed(0.43, {}), 1);
    QCOMPARE(missed(0.38, {}), 0);
    QCOMPARE(missed(0.53, {}), 3);
    QCOMPARE(missed(0.43, kick(4, {}, {})), 1);
    // Two states inside may be shown.
    QCOMPARE(missed(0.43, kick(3, {-0.5, 0}, {})), -1);
    QCOMPARE(missed(0.43, kick(3, {}, {})), -1);
    QCOMPARE(missed(1.43, {}), -1);
    // Whoever comes in twice begins anew.
    std::vector<Change> twice = kick(3, {-0.5, 0}, {});
    twice.push_back(kick(4, {0.5, 0}, {}).front());
    QCOMPARE(missed(0.43, twice), 4);
}

/// Circle 1 comes with 1 m/s and is 0.35 m from circle 2 after a step, 0.25 m after two.
void TestContacts::whoPartsInsideIsSeen_data()
{
    QTest::addColumn<Vec2>("after");
    QTest::addColumn<double>("place"); ///< of circle 1 after the hit, m before that of circle 2
    QTest::addColumn<bool>("isSeen");
    // Both move aside with 3 m/s as well: 1 + 3 + 3 times a rounding.
    QTest::newRow("parting by rounding") << Vec2{6.9e-9, 3} << 0.25 << false;
    QTest::newRow("parting by more") << Vec2{7.1e-9, 3} << 0.25 << true;
    QTest::newRow("parting inside") << Vec2{1, 0} << 0.25 << true;
    QTest::newRow("parting slowly inside") << Vec2{1e-3, 0} << 0.25 << true;
    QTest::newRow("at one speed inside") << Vec2{} << 0.25 << false;
    QTest::newRow("closing inside") << Vec2{-0.1, 0} << 0.25 << false;
    QTest::newRow("parting just inside") << Vec2{1, 0} << 0.399 << true;
    QTest::newRow("parting at the rim") << Vec2{1, 0} << 0.4 << false;
    QTest::newRow("parting outside") << Vec2{1, 0} << 0.45 << false;
}

void TestContacts::whoPartsInsideIsSeen()
{
    QFETCH(Vec2, after);
    QFETCH(double, place);
    QFETCH(bool, isSeen);
    const Observation o = drift(two({-0.45, 0}, {1, 0}, {}, {}),
                                {{2,
                                  [&](Circles &c) {
                                      c[0].position = {-place, 0};
                                      c[0].velocity = {0, after.y};
                                      c[1].velocity = after;
                                  }}},
                                0.3);
    QCOMPARE(leavesInside(o, 0, 1, {}), isSeen);
    QCOMPARE(leavesInside(o, 1, 0, {}), isSeen);
}

QTEST_APPLESS_MAIN(TestContacts)
#include "test_contacts.moc"
