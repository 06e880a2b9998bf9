// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/contacts/collision_detection.h"
#include "model/contacts/collision_response.h"
#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::scenes;

namespace {

/// A step as the lab has it, all pairs in the order of the list and nothing else. \return hits
std::size_t plainStep(const Preset &preset, World &world)
{
    std::size_t hits = 0;
    std::vector<Vec2> old;
    for (Circle &c : world.circles) {
        old.push_back(c.position);
        const Motion m =
            advance(Integrator::Verlet, {c.position, c.velocity}, preset.gravity, preset.timestep);
        c.position = m.position;
        c.velocity = m.velocity;
    }
    for (std::size_t i = 0; i < world.circles.size(); ++i) {
        Circle &c = world.circles[i];
        const Vec2 moved = c.position;
        for (const Wall wall : allWalls) {
            const Vec2 n = outwardNormal(wall);
            if (dot(moved, n) + c.radius > preset.halfWidth
                && reflect(c.velocity, n, preset.restitution)) {
                c.position = old[i];
                ++hits;
            }
        }
    }
    for (std::size_t i = 0; i < world.circles.size(); ++i) {
        for (std::size_t j = i + 1; j < world.circles.size(); ++j) {
            Circle &a = world.circles[i];
            Circle &b = world.circles[j];
            const Vec2 n = normalized(old[j] - old[i]);
            if (!overlap(a, b) || !respond(CircleLaw::Impulse, a, b, n, preset.restitution))
                continue;
            a.position = old[i];
            b.position = old[j];
            ++hits;
        }
    }
    return hits;
}

} // namespace

/// The grid of discrete timing finds what all pairs would, bit for bit.
class TestDiscreteCrowd : public QObject
{
    Q_OBJECT
private slots:
    void theGridMissesNothing_data();
    void theGridMissesNothing();
};

void TestDiscreteCrowd::theGridMissesNothing_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("gravity");
    for (const int count : {17, 100, 500}) {
        QTest::addRow("%d circles", count) << count << 0.0;
        QTest::addRow("%d circles, falling", count) << count << g;
    }
}

void TestDiscreteCrowd::theGridMissesNothing()
{
    QFETCH(int, count);
    QFETCH(double, gravity);
    Preset preset = scene({}, {WallLaw::Reflect, CircleLaw::Impulse, Timing::Discrete});
    preset.gravity = {0, -gravity};
    preset.restitution = 0.9;
    preset.fill =
        CircleFill{.count = count, .radius = std::sqrt(0.4 * 64.0 / (pi * count)), .rmsSpeed = 3.0};
    preset.circles = *makeCircles(*preset.fill, halfWidth);
    for (PresetCircle &c : preset.circles)
        c.integrator = Integrator::Verlet;

    Run run(preset);
    World plain = initialWorld(preset);
    std::size_t hits = 0;
    for (int step = 0; step < 120; ++step) {
        run.steps(1);
        hits += plainStep(preset, plain);
        QVERIFY(run.world.circles == plain.circles);
        QCOMPARE(run.hits.size(), hits);
    }
    QVERIFY(hits > static_cast<std::size_t>(count));
}

QTEST_APPLESS_MAIN(TestDiscreteCrowd)
#include "test_discrete_crowd.moc"
