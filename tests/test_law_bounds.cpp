// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/law_programs.h"

#include "tasks/judging/measured_laws.h"

using namespace cradle;
using namespace cradle::programs;

/// How far a motion may be off before walls and hits are no longer measured by it, and from where
/// on it counts as another motion. Both sides of every bound.
class TestLawBounds : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void wallsBearADriftOfAThird_data();
    void wallsBearADriftOfAThird();
    void hitsBearADriftOfATenth_data();
    void hitsBearADriftOfATenth();
    void roundingIsNoPull_data();
    void roundingIsNoPull();
    void smallestDifferenceOfALawIsSeen_data();
    void smallestDifferenceOfALawIsSeen();
    void leaderIsFollowedExactly_data();
    void leaderIsFollowedExactly();
    void whoIsPutAtAnothersPlaceFollows_data();
    void whoIsPutAtAnothersPlaceFollows();

private:
    [[nodiscard]] LawBench bench(const char *step) const
    {
        return LawBench(task(QLatin1String(step)));
    }
};

namespace {

/// Besides their way, \p way times as long as it should be, circles drift with \p drift m/s.
QString drifting(double way, double drift, bool falls)
{
    return written({.move = QStringLiteral("c.position = c.position + %1 * c.velocity * h + "
                                           "vec(%2, 0) * h %3")
                                .arg(way)
                                .arg(drift)
                                .arg(falls ? QStringLiteral("c.velocity = c.velocity + gravity * h")
                                           : QString()),
                    .walls = wallsOf(wallWays[1], "c.radius", "1"),
                    .hit = hitOf(hitWays[1], {.mass = QStringLiteral("1")})},
                   structures[1]);
}

} // namespace

void TestLawBounds::wallsBearADriftOfAThird_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<double>("way");
    QTest::addColumn<double>("most"); // m/s
    // Of 1.07 m/s, the slowest throw, three tenths; who goes too far is thrown so much slower.
    QTest::newRow("straight") << "L42T17" << 1.0 << 0.321;
    QTest::newRow("straight, but half as far") << "L42T17" << 0.5 << 0.321;
    // Of 4.7 m/s; where they go too far under gravity, of the throw.
    QTest::newRow("falling") << "L42T3" << 1.0 << 1.41;
    QTest::newRow("falling, but too far") << "L42T3" << 1.3 << 1.41 / 1.3;
}

void TestLawBounds::wallsBearADriftOfAThird()
{
    QFETCH(QString, step);
    QFETCH(double, way);
    QFETCH(double, most);
    const LawBench on = bench(step.toLatin1().constData());
    for (const double share : {0.9, 1.1}) {
        const QString program = drifting(way, share * most, step == QLatin1String("L42T3"));
        const MeasuredLaws own(&program, on.ground);
        QCOMPARE(own.walls().judged.empty(), share > 1.0);
    }
}

void TestLawBounds::hitsBearADriftOfATenth_data()
{
    QTest::addColumn<double>("way");
    // Whatever the way: who goes too far is thrown so much slower.
    QTest::newRow("as far as it should be") << 1.0;
    QTest::newRow("half as far") << 0.5;
    QTest::newRow("twice as far") << 2.0;
}

/// Of 1 m/s.
void TestLawBounds::hitsBearADriftOfATenth()
{
    QFETCH(double, way);
    const LawBench on = bench("L42T12");
    for (const double drift : {0.09, 0.11}) {
        const QString program = drifting(way, drift, false);
        const MeasuredLaws own(&program, on.ground);
        QCOMPARE(own.pair().isJudged, drift < 0.1);
    }
    // They are told to have come as fast as was meant.
    const LawBench both = bench("L42T16");
    const QString program = drifting(way, 0.0, false);
    const MeasuredLaws own(&program, both.ground);
    QVERIFY(!own.pair().equals.empty());
    for (const PairHit &hit : own.pair().equals) {
        const PairVelocities came = hit.cameParts();
        const PairVelocities &meant = hit.meeting.velocities;
        QVERIFY(std::abs(came.along1 - meant.along1) < 0.01);
        QVERIFY(std::abs(came.along2 - meant.along2) < 0.01);
        QVERIFY(std::abs(came.across1 - meant.across1) < 0.01);
        QVERIFY(std::abs(came.across2 - meant.across2) < 0.01);
    }
}

void TestLawBounds::roundingIsNoPull_data()
{
    QTest::addColumn<double>("pull"); // 1/s²
    QTest::addColumn<bool>("pulls");
    QTest::newRow("none") << 0.0 << false;
    QTest::newRow("hardly any") << 4e-7 << false;
    QTest::newRow("some") << 2e-6 << true;
}

/// Towards the middle, as a spring does, in x and y half of it each.
void TestLawBounds::roundingIsNoPull()
{
    QFETCH(double, pull);
    QFETCH(bool, pulls);
    const LawBench on = bench("L42T7");
    const QString program =
        written({.move = QStringLiteral("c.position = c.position + c.velocity * h "
                                        "c.velocity = c.velocity + (gravity - %1 * c.position) * h")
                             .arg(0.5 * pull, 0, 'g', 17)},
                structures[0]);
    const MeasuredFlight measured(&program, on.ground);
    for (const int circle : {0, 1}) {
        const Flight &flight = measured.at({0.0, -9.81}, on.ground.timesteps.front(), circle);
        QCOMPARE(flight.pull != Vec2{}, pulls);
        if (pulls)
            QVERIFY(length(flight.pull + 0.5 * pull * Vec2{1.0, 1.0}) < 1e-10);
    }
}

void TestLawBounds::smallestDifferenceOfALawIsSeen_data()
{
    QTest::addColumn<QString>("more"); // besides Euler
    QTest::addColumn<bool>("alike");
    QTest::newRow("nothing") << "" << true;
    // In two steps none of them brings a circle or its velocity a hundred thousandth away.
    QTest::newRow("air") << "c.velocity = c.velocity - 5e-5 * c.velocity * h" << false;
    QTest::newRow("air, hardly any") << "c.velocity = c.velocity - 5e-6 * c.velocity * h" << true;
    QTest::newRow("spring") << "c.velocity = c.velocity - 5e-5 * c.position * h" << false;
    QTest::newRow("spring, hardly any")
        << "c.velocity = c.velocity - 5e-6 * c.position * h" << true;
    QTest::newRow("drift") << "c.position = c.position + vec(5e-5, 0) * h * h" << false;
    QTest::newRow("drift, hardly any") << "c.position = c.position + vec(5e-6, 0) * h * h" << true;
}

void TestLawBounds::smallestDifferenceOfALawIsSeen()
{
    QFETCH(QString, more);
    QFETCH(bool, alike);
    const LawBench on = bench("L42T7");
    const auto moving = [](const QString &text) {
        // In the own scene nothing moves, and nothing shows.
        return written({.start = QStringLiteral("gravity = vec(0, 0) for _, c in ipairs(circles) "
                                                "do c.velocity = vec(0, 0) end"),
                        .move = QStringLiteral("c.position = c.position + c.velocity * h "
                                               "c.velocity = c.velocity + gravity * h ")
                                + text},
                       structures[1]);
    };
    const QString plain = moving({});
    const QString other = moving(more);
    const MeasuredFlight a(&plain, on.ground);
    const MeasuredFlight b(&other, on.ground);
    QCOMPARE(a.isLike(b), alike);
    QCOMPARE(b.isLike(a), alike);
}

void TestLawBounds::leaderIsFollowedExactly_data()
{
    QTest::addColumn<double>("share");
    QTest::addColumn<int>("leader");
    QTest::newRow("as it") << 1.0 << 0;
    QTest::newRow("but for roundings") << 1.0 + 5e-7 << 0;
    QTest::newRow("nearly") << 1.0 + 2e-6 << -1;
}

/// Circle 2 goes where the velocity of circle 1 leads.
void TestLawBounds::leaderIsFollowedExactly()
{
    QFETCH(double, share);
    QFETCH(int, leader);
    const LawBench on = bench("L42T12");
    const QString program = QStringLiteral("function on_update(h) "
                                           "circle1.position = circle1.position + "
                                           "circle1.velocity * h "
                                           "circle2.position = circle2.position + %1 * "
                                           "circle1.velocity * h end")
                                .arg(share, 0, 'g', 17);
    const MeasuredFlight measured(&program, on.ground);
    QCOMPARE(measured.at({}, on.ground.timesteps.front(), 1).leader, leader);
    QCOMPARE(measured.at({}, on.ground.timesteps.front(), 0).leader, -1);
}

void TestLawBounds::whoIsPutAtAnothersPlaceFollows_data()
{
    QTest::addColumn<int>("follower");
    QTest::newRow("the first") << 0;
    QTest::newRow("the second") << 1;
}

void TestLawBounds::whoIsPutAtAnothersPlaceFollows()
{
    QFETCH(int, follower);
    const LawBench on = bench("L42T12");
    const QString program = QStringLiteral("function on_update(h) for _, c in ipairs(circles) do "
                                           "c.position = c.position + c.velocity * h end "
                                           "circle%1.position = circle%2.position end")
                                .arg(follower + 1)
                                .arg(2 - follower);
    const MeasuredFlight measured(&program, on.ground);
    const double h = on.ground.timesteps.front();
    QCOMPARE(measured.at({}, h, follower).follows, 1 - follower);
    QCOMPARE(measured.at({}, h, 1 - follower).follows, -1);
}

QTEST_GUILESS_MAIN(TestLawBounds)
#include "test_law_bounds.moc"
