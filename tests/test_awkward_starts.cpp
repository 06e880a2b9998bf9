// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/measurements.h"
#include "tests/awkward_scenes.h"

#include <algorithm>
#include <numeric>

using namespace cradle;
using namespace cradle::scenes;

namespace {

/// m beyond a wall, and of the sum of the radii two may overlap: roundings of a position.
constexpr double position = 1e-9;
/// Of the smaller radius, by which continuous timing may let two overlap, or reach into a wall.
constexpr double squeeze = 2e-4;
/// Of the energy's size, by which roundings may let it grow.
constexpr double energyRounding = 1e-11;
/// Of a radius: how high circles that lie on each other hop in exact timing, for each row.
constexpr double lying = 1e-5;

/// The largest overlap there is, each divided by what is allowed for its pair; a sweep along x.
double deepestOverlap(const std::vector<Circle> &circles, Timing timing)
{
    std::vector<std::size_t> order(circles.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto left = [&](std::size_t i) { return circles[i].position.x - circles[i].radius; };
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return left(i) < left(j); });
    double deepest = 0.0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Circle &a = circles[order[i]];
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const Circle &b = circles[order[j]];
            if (left(order[j]) > a.position.x + a.radius)
                break;
            const double sum = a.radius + b.radius;
            const double allowed =
                timing == Timing::Exact ? position * sum : squeeze * std::min(a.radius, b.radius);
            const double apart = lengthSquared(b.position - a.position);
            if (apart < sum * sum)
                deepest = std::max(deepest, (sum - std::sqrt(apart)) / allowed);
        }
    }
    return deepest;
}

/// The farthest beyond a wall, divided by what is allowed; infinite if any number is not finite.
double farthestOutside(const std::vector<Circle> &circles, Timing timing)
{
    double farthest = 0.0;
    for (const Circle &c : circles) {
        if (!isFinite(c.position) || !isFinite(c.velocity))
            return infinity;
        const double out = std::max(std::abs(c.position.x), std::abs(c.position.y));
        const double allowed =
            timing == Timing::Exact ? position : std::max(position, squeeze * c.radius);
        farthest = std::max(farthest, (out + c.radius - halfWidth) / allowed);
    }
    return farthest;
}

/// What exact timing may give to circles that lie on each other, so that they hop instead of
/// meeting without end; a circle lies on up to three others.
double energyOfHops(const Preset &preset)
{
    double sum = 0.0;
    for (const PresetCircle &c : preset.circles)
        sum += 3.0 * mass(c.body) * length(preset.gravity) * lying * c.body.radius;
    const auto count = static_cast<double>(preset.circles.size());
    const double rows = std::floor(std::sqrt(count));
    return preset.laws.timing == Timing::Exact && count > 1.0 ? rows * sum : 0.0;
}

/// Kinetic energy, and the potential one of the whole height: what errors are measured by.
double sizeOfEnergy(const Preset &preset)
{
    double size = 0.0;
    for (const PresetCircle &c : preset.circles)
        size +=
            kineticEnergy(c.body) + mass(c.body) * length(preset.gravity) * 2.0 * preset.halfWidth;
    return size;
}

} // namespace

/// Starts that solvers stumble over: none hangs, nothing escapes, overlaps or gains
/// energy, and elastic hits lose none.
class TestAwkwardStarts : public QObject
{
    Q_OBJECT
private slots:
    void nothingGoesWrong_data();
    void nothingGoesWrong();
    void oneInOneOut_data();
    void oneInOneOut();
    void aCornerTurnsBack_data();
    void aCornerTurnsBack();
    void whatRestsStays_data();
    void whatRestsStays();
    void collapseEndsInOneMotion_data();
    void collapseEndsInOneMotion();
    void hitsCountTheDigitsOfPi_data();
    void hitsCountTheDigitsOfPi();
};

namespace {

void addTimings()
{
    QTest::addColumn<Timing>("timing");
    for (const Timing timing : {Timing::Exact, Timing::Continuous})
        QTest::newRow(shortName(timing)) << timing;
}

Preset timed(Preset preset, Timing timing)
{
    preset.laws.timing = timing;
    return preset;
}

} // namespace

void TestAwkwardStarts::nothingGoesWrong_data()
{
    QTest::addColumn<Preset>("preset");
    QTest::addColumn<double>("seconds");
    QTest::addColumn<std::size_t>("mostHits");
    for (const AwkwardScene &scene : awkwardScenes()) {
        for (const Timing timing : {Timing::Exact, Timing::Continuous})
            QTest::addRow("%s, %s", scene.name, shortName(timing))
                << timed(scene.preset, timing) << scene.seconds << scene.mostHits;
    }
}

void TestAwkwardStarts::nothingGoesWrong()
{
    QFETCH(Preset, preset);
    QFETCH(double, seconds);
    QFETCH(std::size_t, mostHits);
    QVERIFY(!findFault(preset).has_value());
    const double rounding = energyRounding * sizeOfEnergy(preset);
    const double hops = energyOfHops(preset);

    Run run(preset);
    double least = measure(run.world.circles, preset.gravity, halfWidth).total();
    const int steps = static_cast<int>(std::lround(seconds / preset.timestep));
    for (int step = 1; step <= steps; ++step) {
        run.steps(1);
        QVERIFY(run.hits.size() <= mostHits);
        const Timing timing = preset.laws.timing;
        COMPARE_NEAR(std::max(0.0, farthestOutside(run.world.circles, timing)), 0.0, 1.0);
        COMPARE_NEAR(deepestOverlap(run.world.circles, timing), 0.0, 1.0);
        const double energy = measure(run.world.circles, preset.gravity, halfWidth).total();
        COMPARE_NEAR(std::max(0.0, energy - least), 0.0, rounding + hops);
        if (preset.restitution == 1.0)
            COMPARE_NEAR(std::min(0.0, energy - least), 0.0, rounding);
        least = std::min(least, energy);
    }
    // What lies on each other hops, or hits would come without end and exact timing give up.
    QVERIFY(!run.stepper.mergedFrom().has_value());
    for (const Hit &hit : run.hits) {
        QVERIFY(std::isfinite(hit.time) && std::isfinite(hit.impulse) && std::isfinite(hit.loss));
        QVERIFY(isFinite(hit.normal) && isFinite(hit.afterA) && isFinite(hit.afterB));
    }
}

void TestAwkwardStarts::oneInOneOut_data()
{
    addTimings();
}

void TestAwkwardStarts::oneInOneOut()
{
    QFETCH(Timing, timing);
    Run run(timed(cradleOfFive(), timing));
    run.steps(60);
    // After ½ s the first touches the row; the last then runs on for ½ s at 2 m/s.
    for (std::size_t i = 0; i < 5; ++i)
        COMPARE_NEAR(length(run[i].velocity), 0.0, 1e-12);
    COMPARE_NEAR(run[0].position.x, -0.5, 1e-12);
    COMPARE_NEAR(length(run[5].velocity - Vec2{2, 0}), 0.0, 1e-12);
    COMPARE_NEAR(run[5].position.x, 3.0, 1e-12);
}

void TestAwkwardStarts::aCornerTurnsBack_data()
{
    addTimings();
}

void TestAwkwardStarts::aCornerTurnsBack()
{
    QFETCH(Timing, timing);
    const double e = 0.5;
    Run run(timed(fourCorners(e), timing));
    run.steps(60);
    // 1.75 m at 2 m/s along each axis, then back at half of it for 0.125 s.
    QCOMPARE(run.hits.size(), std::size_t{8});
    for (const Hit &hit : run.hits)
        COMPARE_NEAR(hit.time, 0.875, 1e-12);
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 side{std::copysign(1.0, run[i].position.x),
                        std::copysign(1.0, run[i].position.y)};
        COMPARE_NEAR(length(run[i].velocity + 2.0 * e * side), 0.0, 1e-12);
        COMPARE_NEAR(length(run[i].position - 3.625 * side), 0.0, 1e-12);
    }
}

void TestAwkwardStarts::whatRestsStays_data()
{
    QTest::addColumn<Preset>("preset");
    for (const AwkwardScene &scene : awkwardScenes()) {
        const auto &circles = scene.preset.circles;
        const bool still = std::all_of(circles.begin(), circles.end(), [](const PresetCircle &c) {
            return c.body.velocity == Vec2{};
        });
        if (!still || scene.mostHits > 0)
            continue;
        for (const Timing timing : {Timing::Exact, Timing::Continuous})
            QTest::addRow("%s, %s", scene.name, shortName(timing)) << timed(scene.preset, timing);
    }
}

void TestAwkwardStarts::whatRestsStays()
{
    QFETCH(Preset, preset);
    Run run(preset);
    run.steps(300);
    QVERIFY(run.hits.empty());
    const bool stacked = QByteArray(QTest::currentDataTag()) == "resting on each other, exact";
    for (std::size_t i = 0; i < preset.circles.size(); ++i) {
        const double hop = stacked ? lying * preset.circles[i].body.radius : 0.0;
        const double place = length(run[i].position - preset.circles[i].body.position);
        COMPARE_NEAR(place, 0.0, 1e-12 + (1.0 + 1e-9) * hop);
        COMPARE_NEAR(length(run[i].velocity), 0.0, 1e-12 + 1.001 * std::sqrt(2.0 * g * hop));
    }
}

void TestAwkwardStarts::collapseEndsInOneMotion_data()
{
    addTimings();
}

void TestAwkwardStarts::collapseEndsInOneMotion()
{
    // Three equal ones in line with e < 7 − √48 = 0.072 hit without end in finite time, after which
    // they go on as one at (1 + 0 − 2)/3 m/s.
    // Source: McNamara, Young: Inelastic collapse in a one-dimensional gas, 1992.
    QFETCH(Timing, timing);
    Run run(timed(threeInLine(0.05), timing));
    run.steps(90);
    for (std::size_t i = 0; i < 3; ++i)
        COMPARE_NEAR(run[i].velocity.x, -1.0 / 3.0, 1e-3);
    COMPARE_NEAR(run[0].velocity.x + run[1].velocity.x + run[2].velocity.x, -1.0, 1e-12);
}

void TestAwkwardStarts::hitsCountTheDigitsOfPi_data()
{
    QTest::addColumn<double>("ratio");
    QTest::addColumn<int>("hits");
    QTest::addColumn<Timing>("timing");
    const std::pair<double, int> digits[] = {{1.0, 3}, {1e2, 31}, {1e4, 314}, {1e6, 3141}};
    for (const Timing timing : {Timing::Exact, Timing::Continuous}) {
        for (const auto &[ratio, hits] : digits)
            QTest::addRow("%d, %s", hits, shortName(timing)) << ratio << hits << timing;
    }
}

void TestAwkwardStarts::hitsCountTheDigitsOfPi()
{
    // A heavy circle drives a light one into a wall: with a mass ratio of 100^k they and the wall
    // hit each other as often as the first k + 1 digits of π say.
    // Source: Galperin: Playing pool with π, 2003.
    QFETCH(double, ratio);
    QFETCH(int, hits);
    QFETCH(Timing, timing);
    Run run(timed(boxed({circle({0, 0}, {-1, 0}, 0.25, Integrator::Verlet, ratio),
                         circle({-3, 0}, {}, 0.25, Integrator::Verlet, 1.0)}),
                  timing));
    while (run[0].position.x < 3.0 && run.world.time < 20.0)
        run.steps(1);
    QCOMPARE(run.hits.size(), static_cast<std::size_t>(hits));
    COMPARE_NEAR(run[0].velocity.x * run[0].velocity.x
                     + run[1].velocity.x * run[1].velocity.x / ratio,
                 1.0, 1e-12);
}

QTEST_APPLESS_MAIN(TestAwkwardStarts)
#include "test_awkward_starts.moc"
