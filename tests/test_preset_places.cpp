// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/preset.h"

#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::scenes;

/// Where the circles of a scene may be.
class TestPresetPlaces : public QObject
{
    Q_OBJECT
private slots:
    void overlapIsAFaultWhereCirclesAct_data();
    void overlapIsAFaultWhereCirclesAct();
    void theOverlappingPairIsNamed();
    void aSmallCircleInALargeOneOverlaps();
    void aCrowdWithOneOverlapIsCaught();
    void outsideIsAFaultWhereWallsReflect_data();
    void outsideIsAFaultWhereWallsReflect();
};

void TestPresetPlaces::overlapIsAFaultWhereCirclesAct_data()
{
    QTest::addColumn<CircleLaw>("law");
    QTest::addColumn<double>("distance"); // of circles of r = ¼ and ½ m
    QTest::addColumn<bool>("faulty");
    QTest::newRow("none: on top of each other") << CircleLaw::None << 0.0 << false;
    for (const auto &[name, law] : {std::pair{"stop", CircleLaw::Stop},
                                    {"swap velocities", CircleLaw::SwapVelocities},
                                    {"swap normal", CircleLaw::SwapNormal},
                                    {"impulse", CircleLaw::Impulse}}) {
        QTest::addRow("%s: apart", name) << law << 1.0 << false;
        QTest::addRow("%s: touching", name) << law << 0.75 << false;
        QTest::addRow("%s: within the tolerance", name) << law << 0.75 * (1.0 - 0.9e-9) << false;
        QTest::addRow("%s: beyond the tolerance", name) << law << 0.75 * (1.0 - 1.1e-9) << true;
        QTest::addRow("%s: overlapping", name) << law << 0.7 << true;
        QTest::addRow("%s: on top of each other", name) << law << 0.0 << true;
    }
}

void TestPresetPlaces::overlapIsAFaultWhereCirclesAct()
{
    QFETCH(CircleLaw, law);
    QFETCH(double, distance);
    QFETCH(bool, faulty);
    for (const Vec2 direction : {Vec2{1, 0}, Vec2{0, -1}}) {
        const Preset preset =
            scene({circle({0, 0}, {}, 0.25), circle(distance * direction, {}, 0.5)},
                  {WallLaw::None, law, Timing::Discrete});
        QCOMPARE(findFault(preset).has_value(), faulty);
    }
}

void TestPresetPlaces::theOverlappingPairIsNamed()
{
    Preset preset = scene({circle({3, 0}), circle({0, 0}), circle({-3, 0}), circle({0.3, 0})},
                          {WallLaw::None, CircleLaw::Stop, Timing::Discrete});
    const std::optional<Error> fault = findFault(preset);
    QVERIFY(fault.has_value());
    QCOMPARE(fault->pointer, QStringLiteral("/circles/3/position"));
    QVERIFY2(fault->message.contains(QStringLiteral("circles 2 and 4")),
             qPrintable(fault->message));
    QVERIFY2(fault->message.contains(QStringLiteral("0.3 m")), qPrintable(fault->message));
    QVERIFY2(fault->message.contains(QStringLiteral("0.4 m")), qPrintable(fault->message));
}

void TestPresetPlaces::aSmallCircleInALargeOneOverlaps()
{
    // Many left edges lie between those of the two that overlap.
    Preset preset = scene({circle({0, 0}, {}, 2.0)}, {WallLaw::None, CircleLaw::Stop, {}});
    for (int i = 0; i < 20; ++i)
        preset.circles.push_back(circle({-1.9 + 0.15 * i, 3.0}, {}, 0.05));
    QVERIFY(!findFault(preset).has_value());
    preset.circles.push_back(circle({1.9, 0}, {}, 0.05));
    const std::optional<Error> fault = findFault(preset);
    QVERIFY(fault.has_value());
    QCOMPARE(fault->pointer, QStringLiteral("/circles/21/position"));
}

void TestPresetPlaces::aCrowdWithOneOverlapIsCaught()
{
    Preset preset = scene({}, {WallLaw::None, CircleLaw::Impulse, Timing::Discrete});
    for (int i = 0; i < 2500; ++i)
        preset.circles.push_back(circle({0.5 * (i % 50), 0.5 * (i / 50)}));
    QVERIFY(!findFault(preset).has_value());
    preset.circles[1234].body.position.y += 0.2;
    const std::optional<Error> fault = findFault(preset);
    QVERIFY(fault.has_value());
    QCOMPARE(fault->pointer, QStringLiteral("/circles/1284/position"));
}

void TestPresetPlaces::outsideIsAFaultWhereWallsReflect_data()
{
    QTest::addColumn<Vec2>("position");
    QTest::addColumn<bool>("faulty");
    QTest::newRow("in the middle") << Vec2{0, 0} << false;
    QTest::newRow("touching right") << Vec2{3.75, 0} << false;
    QTest::newRow("touching a corner") << Vec2{-3.75, -3.75} << false;
    QTest::newRow("a rounding beyond") << Vec2{3.75 + 1e-12, 0} << false;
    QTest::newRow("right") << Vec2{3.76, 0} << true;
    QTest::newRow("left") << Vec2{-3.76, 0} << true;
    QTest::newRow("above") << Vec2{0, 3.76} << true;
    QTest::newRow("below") << Vec2{0, -3.76} << true;
    QTest::newRow("far away") << Vec2{50, 50} << true;
}

void TestPresetPlaces::outsideIsAFaultWhereWallsReflect()
{
    QFETCH(Vec2, position);
    QFETCH(bool, faulty);
    Preset preset = scene({circle(position, {}, 0.25)}, {WallLaw::Reflect, {}, {}});
    const std::optional<Error> fault = findFault(preset);
    QCOMPARE(fault.has_value(), faulty);
    if (fault) {
        QCOMPARE(fault->pointer, QStringLiteral("/circles/0/position"));
        QVERIFY2(fault->message.contains(QStringLiteral("-3.75 to 3.75 m")),
                 qPrintable(fault->message));
    }
    preset.laws.walls = WallLaw::None;
    QVERIFY(!findFault(preset).has_value());
}

QTEST_GUILESS_MAIN(TestPresetPlaces)
#include "test_preset_places.moc"
