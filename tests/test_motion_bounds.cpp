// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/motion.h"

#include "tests/check_faults.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::programs::faults;

/// Where what the checks ask of a step begins and ends: each bound from both sides.
class TestMotionBounds : public QObject
{
    Q_OBJECT
private slots:
    void velocitiesAreTheSameWithinTheirTolerance();
    void waysAreThoseOfVelocityAndGravity();
    void wallsAndCirclesAreNearWithinAStep();
    void leapsAreLongerThanThreeWays_data();
    void leapsAreLongerThanThreeWays();
    void steadyIsWhatMostStepsInTheOpenAre_data();
    void steadyIsWhatMostStepsInTheOpenAre();
    void straysGoBesideTheWayOfAnyMethod_data();
    void straysGoBesideTheWayOfAnyMethod();
    void changesAreToldAlongTheirLargerPart_data();
    void changesAreToldAlongTheirLargerPart();
};

namespace {

/// Circle 2 at the start, and after each step.
Observation states(const std::vector<Circle> &of, Vec2 gravity = {})
{
    std::vector<Change> changes;
    for (std::size_t k = 1; k < of.size(); ++k)
        changes.push_back({static_cast<int>(k), [to = of[k]](Circles &c) {
                               c[1].position = to.position;
                               c[1].velocity = to.velocity;
                           }});
    return drift(beside(of.front()), changes, h * static_cast<double>(of.size() - 1), gravity);
}

Circle at(Vec2 position, Vec2 velocity = {})
{
    return {.position = position, .velocity = velocity};
}

bool isNear(double a, double b)
{
    return std::abs(a - b) < 1e-12;
}

} // namespace

void TestMotionBounds::velocitiesAreTheSameWithinTheirTolerance()
{
    // A tenth of 1 + 3 m/s.
    QVERIFY(motion::isSame({3.39, 0}, {3, 0}, 0.1));
    QVERIFY(!motion::isSame({3.41, 0}, {3, 0}, 0.1));
    QVERIFY(motion::isSame({0, 2.61}, {0, 3}, 0.1));
    QVERIFY(!motion::isSame({0, 2.59}, {0, 3}, 0.1));
    // At the bound itself nothing is changed.
    QVERIFY(motion::isSame({3.5, 0}, {3, 0}, 0.125));
    const Observation even = states({at({2, 2}, {3, 0}), at({2, 2}, {3.5, 0})});
    QVERIFY(!motion::isKicked(even, 1, 0, {}, 0.125));
    for (const auto &[speed, isKicked] :
         {std::pair{3.29, false}, {3.31, true}, {2.51, false}, {2.49, true}}) {
        const Observation o = states({at({2, 2}, {3, 0}), at({2, 2}, {speed, 0})}, {-1, 0});
        QCOMPARE(motion::isKicked(o, 1, 0, {-1, 0}, 0.1), isKicked);
        QVERIFY(isNear(motion::kick(o, 1, 0, {-1, 0}).x, speed - 2.9));
        QVERIFY(isNear(motion::kick(o, 1, 0, {0, -1}).y, 0.1));
    }
}

void TestMotionBounds::waysAreThoseOfVelocityAndGravity()
{
    const Vec2 gravity{0, -2};
    const Observation o = states({at({2, 2}, {3, 4}), at({2, 2}, {6, 8}), at({2, 2})}, gravity);
    QVERIFY(isNear(motion::travel(o, 1, 0, gravity), 0.52 + 1e-9));
    QVERIFY(isNear(motion::travel(o, 1, 1, gravity), 1.02 + 1e-9));
    QVERIFY(isNear(motion::recentTravel(o, 1, 0, gravity), 1.04 + 2e-9));
    QVERIFY(isNear(motion::recentTravel(o, 1, 1, gravity), 1.54 + 2e-9));
    const Circle c = o.circle(1, 0);
    QVERIFY(isNear(motion::wallGap(o, c, Wall::Left), 5.8));
    QVERIFY(isNear(motion::wallGap(o, c, Wall::Right), 1.8));
    QVERIFY(isNear(motion::wallGap(o, c, Wall::Bottom), 5.8));
    QVERIFY(isNear(motion::wallGap(o, c, Wall::Top), 1.8));
}

void TestMotionBounds::wallsAndCirclesAreNearWithinAStep()
{
    const Vec2 gravity{0, -1};
    const CheckSpec alone = check("conserves", {1});
    const CheckSpec among = check("conserves", {1}, {{QStringLiteral("collisions"), true}});
    // 0.11 m in a step, whichever way it goes; and 0.01 m the one that rests.
    for (const Vec2 n : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}}) {
        const Observation near = states({at((3.8 - 0.1099) * n, {0, 1}), at({})}, gravity);
        QVERIFY(motion::isNearWall(near, 1, 0, gravity));
        QVERIFY(!motion::isFree(alone, near, 1, 0, gravity));
        const Observation far = states({at((3.8 - 0.1101) * n, {0, 1}), at({})}, gravity);
        QVERIFY(!motion::isNearWall(far, 1, 0, gravity));
        QVERIFY(motion::isFree(among, far, 1, 0, gravity));
        const Observation met = states({at((0.4 + 0.1199) * n, {0, 1}), at({})}, gravity);
        QVERIFY(motion::isNearCircle(met, 1, 0, gravity)
                && motion::isNearCircle(met, 0, 0, gravity));
        QVERIFY(motion::isFree(alone, met, 1, 0, gravity));
        QVERIFY(!motion::isFree(among, met, 1, 0, gravity));
        const Observation missed = states({at((0.4 + 0.1201) * n, {0, 1}), at({})}, gravity);
        QVERIFY(!motion::isNearCircle(missed, 1, 0, gravity));
        QVERIFY(motion::isFree(among, missed, 1, 0, gravity));
    }
}

void TestMotionBounds::leapsAreLongerThanThreeWays_data()
{
    QTest::addColumn<double>("way");
    QTest::addColumn<double>("after"); // m/s
    QTest::addColumn<double>("moved");
    QTest::addColumn<double>("own"); // what is told, m; −1: it is no leap
    QTest::newRow("two ways") << 0.1 << 0.0 << 0.2999 << -1.0;
    QTest::newRow("three ways") << 0.1 << 0.0 << 0.3001 << 0.05;
    QTest::newRow("three ways to the bit") << 0.125 << 0.0 << 0.375 << -1.0;
    QTest::newRow("as it goes on") << 0.1 << 5.0 << 0.4999 << -1.0;
    QTest::newRow("further than it goes on") << 0.1 << 5.0 << 0.5001 << 0.05;
    QTest::newRow("rounding goes on") << 0.0 << 0.0 << 0.9e-9 << -1.0;
    QTest::newRow("more than rounding") << 0.0 << 0.0 << 1.1e-9 << 0.0;
    QTest::newRow("way of rest") << 3.9e-9 << 0.0 << 1.0 << 0.0;
    QTest::newRow("small way") << 4.1e-9 << 0.0 << 1.0 << 2.05e-9;
}

void TestMotionBounds::leapsAreLongerThanThreeWays()
{
    QFETCH(double, way);
    QFETCH(double, after);
    QFETCH(double, moved);
    QFETCH(double, own);
    const Observation o =
        states({at({0, 2}), at({0, 2}), at({moved, 2}, {0, after}), at({moved, 2})});
    const auto fault = motion::leap(o, 1, 1, way);
    QCOMPARE(fault.has_value(), own >= 0.0);
    if (!fault)
        return;
    QVERIFY(std::abs(*fault->expected - own) < 1e-15 && isNear(*fault->observed, moved));
    QCOMPARE(fault->step, 2);
    QCOMPARE(fault->circle, 1);
}

void TestMotionBounds::steadyIsWhatMostStepsInTheOpenAre_data()
{
    QTest::addColumn<int>("atWall"); // so many steps, and then
    QTest::addColumn<int>("open");
    QTest::addColumn<QList<int>>("changed");
    QTest::addColumn<int>("told"); // the step; 0: nothing
    QTest::newRow("none") << 0 << 10 << QList<int>{} << 0;
    QTest::newRow("half of them") << 0 << 10 << QList<int>{2, 3, 5, 7, 9} << 0;
    QTest::newRow("most of them") << 0 << 9 << QList<int>{2, 3, 5, 7, 9} << 2;
    QTest::newRow("at the wall") << 5 << 3 << QList<int>{1, 2, 3, 4, 5} << 0;
    QTest::newRow("after the wall") << 5 << 3 << QList<int>{7, 8} << 7;
}

void TestMotionBounds::steadyIsWhatMostStepsInTheOpenAre()
{
    QFETCH(int, atWall);
    QFETCH(int, open);
    QFETCH(QList<int>, changed);
    QFETCH(int, told);
    std::vector<Circle> pushed{at({2, atWall > 0 ? 3.8 : 2.0})};
    std::vector<Circle> strays = pushed;
    for (int k = 1; k <= atWall + open; ++k) {
        const double y = k < atWall ? 3.8 : 2.0;
        const bool isChanged = changed.contains(k);
        const Circle &last = pushed.back();
        pushed.push_back(at({last.position.x + h * last.velocity.x, y},
                            last.velocity + Vec2{isChanged ? 0.001 : 0.0, 0}));
        const double x = strays.back().position.x;
        strays.push_back(at({x + (isChanged ? 0.01 : 0.0), y}));
    }
    const auto change = motion::steadyFault(states(pushed), 1, {}, Vec2{1, 0});
    const auto stray = motion::steadyFault(states(strays), 1, {});
    QCOMPARE(change ? change->step : 0, told);
    QCOMPARE(stray ? stray->step : 0, told);
    QVERIFY(!change || change->message.contains(QStringLiteral("velocity of circle 2")));
    // Along the other axis no velocity is changed.
    const auto across = motion::steadyFault(states(pushed), 1, {}, Vec2{0, 1});
    QVERIFY(!across || !across->message.contains(QStringLiteral("velocity of circle 2")));
}

void TestMotionBounds::straysGoBesideTheWayOfAnyMethod_data()
{
    QTest::addColumn<Vec2>("gravity");
    QTest::addColumn<Vec2>("beside");  // of the way of its velocity, m a step
    QTest::addColumn<QString>("said"); // nothing, or how it begins and ends
    const auto row = [](const char *name, Vec2 gravity, Vec2 beside, const char *said) {
        QTest::newRow(name) << gravity << beside << QString::fromUtf8(said);
    };
    const Vec2 down{0, -2}; // 0.02 m in a step
    row("none", {}, {}, "");
    row("rounding", {}, {0.9e-9, 0}, "");
    row("more than rounding", {}, {0, 1.1e-9}, "y");
    row("beside", {}, {0.01, 0}, "x");
    row("as far as gravity takes it", down, {0, -0.01999999}, "");
    row("further", down, {0, -0.02001}, "y gravity");
    row("a rounding further", down, {0, -0.0200000009}, "");
    row("against gravity", down, {0, 1.1e-9}, "y gravity");
    row("a rounding against it", down, {0, 0.9e-9}, "");
    row("a rounding across", down, {0.9e-9, -0.01}, "");
    row("across", down, {1.1e-9, 0}, "x gravity");
    row("across the other way", down, {-0.01, 0}, "x gravity");
}

void TestMotionBounds::straysGoBesideTheWayOfAnyMethod()
{
    QFETCH(Vec2, gravity);
    QFETCH(Vec2, beside);
    QFETCH(QString, said);
    std::vector<Circle> all{at({1, 2}, {0.5, 0.5})};
    for (int k = 1; k <= 4; ++k) {
        const Circle &last = all.back();
        all.push_back(at(last.position + h * last.velocity + beside, last.velocity + h * gravity));
    }
    const auto fault = motion::steadyFault(states(all, gravity), 1, gravity);
    QCOMPARE(fault.has_value(), !said.isEmpty());
    if (!fault)
        return;
    const bool isX = said.startsWith(QLatin1Char('x'));
    QVERIFY(isNear(*fault->expected, 0.05));
    QVERIFY(isNear(*fault->observed, 0.05 + (isX ? beside.x : beside.y)));
    QCOMPARE(fault->step, 1);
    QCOMPARE(fault->message.contains(QStringLiteral("gravity adds at most (0, -0.02) m")),
             said.contains(QLatin1String("gravity")));
}

void TestMotionBounds::changesAreToldAlongTheirLargerPart_data()
{
    QTest::addColumn<Vec2>("after");
    QTest::addColumn<double>("right");
    QTest::addColumn<double>("observed");
    QTest::addColumn<bool>("isTurned");
    // From (1, 0.5), with gravity to (1, 0.4).
    QTest::newRow("faster") << Vec2{1.5, 0.3} << 1.0 << 1.5 << false;
    QTest::newRow("slower") << Vec2{0.5, 0.8} << 1.0 << 0.5 << false;
    QTest::newRow("stopped") << Vec2{1, 0} << 0.4 << 0.0 << false;
    QTest::newRow("stopped along its way") << Vec2{0, 0.4} << 1.0 << 0.0 << false;
    QTest::newRow("turned") << Vec2{-0.1, 0.4} << 1.0 << -0.1 << true;
    QTest::newRow("turned the other way") << Vec2{1, -0.1} << 0.4 << -0.1 << true;
}

void TestMotionBounds::changesAreToldAlongTheirLargerPart()
{
    QFETCH(Vec2, after);
    QFETCH(double, right);
    QFETCH(double, observed);
    QFETCH(bool, isTurned);
    const Observation o = states({at({1, 2}, {1, 0.5}), at({1, 2}, after)}, {0, -1});
    const Fault fault = motion::changedInOpen(o, 1, 0, {0, -1});
    QVERIFY(isNear(*fault.expected, right) && isNear(*fault.observed, observed));
    QCOMPARE(fault.message.contains(QStringLiteral("which began away from the walls")), isTurned);
    QVERIFY(fault.message.contains(QStringLiteral("(1, 0.4) m/s is right")));
    QCOMPARE(fault.step, 1);
}

QTEST_GUILESS_MAIN(TestMotionBounds)
#include "test_motion_bounds.moc"
