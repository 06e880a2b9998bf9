// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/inferred_hits.h"
#include "tests/scenes.h"

#include <functional>

using namespace cradle;
using namespace cradle::scenes;

/// The hits that are read from the states of a run are those that the engine told.
class TestInferredHits : public QObject
{
    Q_OBJECT
private slots:
    void hitsAreThoseOfTheEngine_data();
    void hitsAreThoseOfTheEngine();
    void freeMotionHasNoHits_data();
    void freeMotionHasNoHits();
    void wayOfAnsweringDoesNotMatter_data();
    void wayOfAnsweringDoesNotMatter();
    void circlesSideBySideMeetTheFloorNotEachOther();
    void circleInACornerHitsBothWalls();
    void hitKnowsVelocitiesAndLoss();
    void hitsAreAppended();
    void missingGravityIsNoHit();
};

namespace {

constexpr Laws discrete{WallLaw::Reflect, CircleLaw::Impulse, Timing::Discrete};

/// What \p seconds of a scene show to who sees its states alone.
std::vector<Hit> inferredHits(const Preset &preset, Run &run, double seconds)
{
    std::vector<Hit> hits;
    while (run.world.time < seconds) {
        const std::vector<Circle> before = run.world.circles;
        run.steps(1);
        inferHits(preset, before, run.world.circles, preset.timestep, run.world.step,
                  run.world.time, hits);
    }
    return hits;
}

QByteArray toText(const std::vector<Hit> &hits)
{
    QByteArray text;
    for (const Hit &hit : hits)
        text += QByteArray::number(hit.step) + (hit.kind == Hit::Kind::Wall ? " wall " : " circle ")
                + QByteArray::number(hit.a) + ' ' + QByteArray::number(hit.b) + ' '
                + QByteArray::number(hit.impulse) + "; ";
    return text;
}

/// One step of two circles of 1 m that a program moved by \p move.
std::vector<Hit> hitsOfStep(Preset preset, const std::function<void(std::vector<Circle> &)> &move)
{
    std::vector<Circle> before;
    for (const PresetCircle &circle : preset.circles)
        before.push_back(circle.body);
    std::vector<Circle> after = before;
    move(after);
    std::vector<Hit> hits;
    inferHits(preset, before, after, preset.timestep, 1, preset.timestep, hits);
    return hits;
}

} // namespace

void TestInferredHits::hitsAreThoseOfTheEngine_data()
{
    QTest::addColumn<Preset>("preset");
    QTest::addColumn<int>("atLeast"); ///< hits
    const auto row = [](const char *name, Preset preset, Vec2 gravity, double restitution,
                        int atLeast) {
        preset.gravity = gravity;
        preset.restitution = restitution;
        QTest::newRow(name) << preset << atLeast;
    };
    const Vec2 down{0.0, -g};
    const auto euler = Integrator::SymplecticEuler;
    const Preset cradle = scene({circle({-2, 2}, {2, 0}), circle({2, 2})}, discrete);
    const Preset glancing = scene({circle({-2, 2.3}, {2, 0}), circle({2, 2})}, discrete);
    const Preset unequal =
        scene({circle({-2, 2}, {2, 0.3}, 0.3), circle({2, 2.1}, {-1, 0}, 0.15)}, discrete);
    const Preset thrown = scene({circle({-2, 2}, {2, 0}, 0.2, euler)}, discrete);
    const Preset apart = scene(
        {circle({-2, 2}, {0.5, 0}, 0.2, euler), circle({2, 1}, {-0.3, 0}, 0.3, euler)}, discrete);
    const Preset meeting =
        scene({circle({-1, 2}, {1, 0}, 0.2, euler), circle({1, 2}, {-1, 0}, 0.2, euler)}, discrete);
    row("Newton's cradle", cradle, {}, 1.0, 4);
    row("glancing", glancing, {}, 1.0, 4);
    row("unequal masses", unequal, {}, 1.0, 4);
    row("half elastic", unequal, {}, 0.5, 3);
    row("throw under gravity", thrown, down, 1.0, 3);
    row("two bounce apart under gravity", apart, down, 1.0, 4);
    row("two meet in the air under gravity", meeting, down, 1.0, 3);
    row("sideways gravity", thrown, {3.0, 0.0}, 1.0, 2);
}

void TestInferredHits::hitsAreThoseOfTheEngine()
{
    QFETCH(Preset, preset);
    QFETCH(int, atLeast);
    Run run(preset);
    const std::vector<Hit> inferred = inferredHits(preset, run, 8.0);
    const std::vector<Hit> &told = run.hits;
    const QByteArray both = "told " + toText(told) + "inferred " + toText(inferred);
    QVERIFY2(static_cast<int>(told.size()) >= atLeast, both);
    QCOMPARE(inferred.size(), told.size());
    for (std::size_t i = 0; i < told.size(); ++i) {
        QVERIFY2(inferred[i].kind == told[i].kind && inferred[i].a == told[i].a
                     && inferred[i].b == told[i].b && inferred[i].step == told[i].step,
                 both);
        COMPARE_NEAR(inferred[i].time, told[i].time, 1e-9);
        COMPARE_NEAR(length(inferred[i].normal - told[i].normal), 0.0, 1e-9);
        COMPARE_NEAR(inferred[i].impulse, told[i].impulse, 1e-9 * (1.0 + told[i].impulse));
    }
}

void TestInferredHits::freeMotionHasNoHits_data()
{
    QTest::addColumn<Preset>("preset");
    for (const Integrator integrator : allIntegrators) {
        Preset preset = scene({circle({-1, 2}, {0.4, 3}, 0.2, integrator),
                               circle({-1, 2}, {0.4, 3}, 0.2, integrator)},
                              {WallLaw::None, CircleLaw::None, Timing::Discrete});
        preset.gravity = {0.0, -g};
        QTest::newRow(shortName(integrator)) << preset;
    }
}

/// Two circles that fall through walls and each other, always within reach.
void TestInferredHits::freeMotionHasNoHits()
{
    QFETCH(Preset, preset);
    Run run(preset);
    const std::vector<Hit> inferred = inferredHits(preset, run, 8.0);
    QVERIFY2(inferred.empty(), toText(inferred));
}

void TestInferredHits::wayOfAnsweringDoesNotMatter_data()
{
    QTest::addColumn<Vec2>("position"); ///< after the step
    QTest::addColumn<double>("speed");  ///< away from the wall
    QTest::addColumn<bool>("elastic");  ///< the hit itself takes no energy
    const double old = 3.79;
    QTest::newRow("goes back, gravity forgotten") << Vec2{0, -old} << 3.0 << false;
    QTest::newRow("goes back, gravity before") << Vec2{0, -old} << 3.0 + g * dt << true;
    QTest::newRow("is put to the wall") << Vec2{0, -3.8} << 3.0 - g * dt << true;
    QTest::newRow("is mirrored") << Vec2{0, -3.76} << 3.0 << false;
    QTest::newRow("stops") << Vec2{0, -3.8} << 0.0 << false;
}

void TestInferredHits::wayOfAnsweringDoesNotMatter()
{
    QFETCH(Vec2, position);
    QFETCH(double, speed);
    Preset preset = scene({circle({0, -3.79}, {1, -3})}, discrete);
    preset.gravity = {0.0, -g};
    const std::vector<Hit> hits = hitsOfStep(preset, [&](std::vector<Circle> &circles) {
        circles[0].position = position;
        circles[0].velocity = {1, speed};
    });
    QCOMPARE(hits.size(), std::size_t{1});
    QCOMPARE(hits[0].kind, Hit::Kind::Wall);
    QCOMPARE(hits[0].b, static_cast<int>(Wall::Bottom));
    QVERIFY(hits[0].normal == (Vec2{0, -1}));
    // The velocity changed by this much besides gravity's part.
    COMPARE_NEAR(hits[0].impulse, mass(preset.circles[0].body) * (3.0 + speed + g * dt), 1e-9);
    QFETCH(bool, elastic);
    QCOMPARE(std::abs(hits[0].loss) < 1e-6, elastic);
    // Before and after tell of the hit alone: its impulse and its loss follow from them.
    const Vec2 change = hits[0].afterA - hits[0].beforeA;
    COMPARE_NEAR(mass(preset.circles[0].body) * change.y, hits[0].impulse, 1e-9);
    COMPARE_NEAR(change.x, 0.0, 1e-12);
    COMPARE_NEAR(0.5 * mass(preset.circles[0].body)
                     * (lengthSquared(hits[0].beforeA) - lengthSquared(hits[0].afterA)),
                 hits[0].loss, 1e-9);
}

void TestInferredHits::circlesSideBySideMeetTheFloorNotEachOther()
{
    Preset preset = scene({circle({0, 0}, {0.1, 0}, 0.2, Integrator::SymplecticEuler),
                           circle({0.42, 0}, {0.1, 0}, 0.2, Integrator::SymplecticEuler)},
                          discrete);
    preset.gravity = {0.0, -g};
    Run run(preset);
    const std::vector<Hit> inferred = inferredHits(preset, run, 1.0);
    QCOMPARE(run.hits.size(), std::size_t{2});
    QVERIFY2(inferred.size() == 2, toText(inferred));
    for (std::size_t i = 0; i < 2; ++i) {
        QCOMPARE(inferred[i].kind, Hit::Kind::Wall);
        QCOMPARE(inferred[i].a, static_cast<int>(i));
        COMPARE_NEAR(inferred[i].impulse, run.hits[i].impulse, 1e-9 * inferred[i].impulse);
    }
}

void TestInferredHits::circleInACornerHitsBothWalls()
{
    const Preset preset = scene({circle({3.79, -3.79}, {2, -1})}, discrete);
    const std::vector<Hit> hits = hitsOfStep(preset, [](std::vector<Circle> &circles) {
        circles[0].velocity = {-2, 1};
    });
    QCOMPARE(hits.size(), std::size_t{2});
    QCOMPARE(hits[0].b, static_cast<int>(Wall::Right));
    QCOMPARE(hits[1].b, static_cast<int>(Wall::Bottom));
    COMPARE_NEAR(hits[0].impulse, 4.0 * mass(preset.circles[0].body), 1e-9);
    COMPARE_NEAR(hits[1].impulse, 2.0 * mass(preset.circles[0].body), 1e-9);
}

void TestInferredHits::hitKnowsVelocitiesAndLoss()
{
    // Both stop: all of the kinetic energy, ½ m (2 m/s)² = 2 m, is lost.
    const Preset preset = scene({circle({0, 0}, {2, 0}), circle({0.41, 0})}, discrete);
    const std::vector<Hit> hits = hitsOfStep(preset, [](std::vector<Circle> &circles) {
        circles[0].velocity = {0, 0};
    });
    QCOMPARE(hits.size(), std::size_t{1});
    const Hit &hit = hits[0];
    QCOMPARE(hit.kind, Hit::Kind::Circle);
    QVERIFY(hit.a == 0 && hit.b == 1);
    QVERIFY(hit.normal == (Vec2{1, 0}));
    QVERIFY(hit.beforeA == (Vec2{2, 0}) && hit.afterA == (Vec2{0, 0}));
    QVERIFY(hit.beforeB == (Vec2{0, 0}) && hit.afterB == (Vec2{0, 0}));
    const double m = mass(preset.circles[0].body);
    COMPARE_NEAR(hit.impulse, 2.0 * m, 1e-9);
    COMPARE_NEAR(hit.loss, 2.0 * m, 1e-9);
}

void TestInferredHits::hitsAreAppended()
{
    const Preset preset = scene({circle({0, -3.79}, {0, -1})}, discrete);
    std::vector<Circle> before{preset.circles[0].body};
    std::vector<Circle> after = before;
    after[0].velocity = {0, 1};
    std::vector<Hit> hits(1);
    inferHits(preset, before, after, dt, 7, 0.25, hits);
    QCOMPARE(hits.size(), std::size_t{2});
    QCOMPARE(hits[1].step, 7);
    QCOMPARE(hits[1].time, 0.25);
}

/// A program that leaves gravity out for a step has hit nothing, however fast it flies to the wall.
void TestInferredHits::missingGravityIsNoHit()
{
    for (const double speed : {0.5, 3.0, -0.5, -3.0}) {
        const double side = speed > 0.0 ? 1.0 : -1.0;
        Preset preset = scene({circle({0, side * (4 - 0.21)}, {0, speed})}, discrete);
        preset.gravity = {0, -g};
        const auto drift = [](std::vector<Circle> &c) { c[0].position += dt * c[0].velocity; };
        QCOMPARE(toText(hitsOfStep(preset, drift)), QByteArray());
    }
}

QTEST_APPLESS_MAIN(TestInferredHits)
#include "test_inferred_hits.moc"
