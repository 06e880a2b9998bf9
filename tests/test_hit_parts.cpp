// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/simulation.h"
#include "tests/scene_lists.h"
#include "views/scene/hit_parts.h"
#include "views/theme.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace cradle::scenes;
using namespace cradle;

class TestHitParts : public QObject
{
    Q_OBJECT
private slots:
    void hitIsSplitAlongAndAcross();
    void wallHitIsSplitAlongTheWallsNormal();
    void hitFadesWhileRunning();
};

void TestHitParts::hitIsSplitAlongAndAcross()
{
    Simulation simulation(twoCircles());
    simulation.seekNextHit();
    // The first step that would overlap is where 4 − t·2 < √(0.4² − 0.3²) = 0.26458: step 113;
    // both go back to step 112, where circle 1 is at x = −2 + 112/30 = 1.73333.
    QCOMPARE(simulation.current(), qint64{113});
    const Vec2 at{-2.0 + 112.0 / 30.0, 2.3};
    const Vec2 n = normalized(Vec2{2.0, 2.0} - at);
    const Vec2 along = 2.0 * n.x * n;
    const Vec2 across = Vec2{2.0, 0.0} - along;
    const DrawList list = buildScene(SceneMoment(simulation), {}, lookAt(twoCircles()));
    const DrawList::Arrow alongArrow = arrowOf(list, theme().along);
    QVERIFY(near(alongArrow.from, at));
    QVERIFY(near(alongArrow.to, at + 0.75 * along));
    QVERIFY(near(arrowOf(list, theme().across).to, at + 0.75 * across));
    QCOMPARE(list.arrows.size(), std::size_t{3}); // and the velocity before
    QVERIFY(near(list.arrows[0].to, at + Vec2{1.5, 0.0}));
    // |along| = 2 · 0.26667/0.40139 = 1.3287, |across| = 2 · 0.3/0.40139 = 1.4948
    const QStringList found = texts(list);
    QVERIFY(found.contains(QStringLiteral("along 1.33")));
    QVERIFY(found.contains(QStringLiteral("across 1.49")));
    QVERIFY(found.contains(QStringLiteral("before 2.00")));
    const auto normal = std::find_if(list.lines.begin(), list.lines.end(), [](const auto &line) {
        return line.dash != DrawList::Dash{};
    });
    QVERIFY(normal != list.lines.end());
    QVERIFY(std::abs(cross(normal->to - normal->from, n)) < 1e-9);
    // A step later nothing of it is shown.
    simulation.stepForward();
    const DrawList later = buildScene(SceneMoment(simulation), {}, lookAt(twoCircles()));
    QCOMPARE(arrowOf(later, theme().along), DrawList::Arrow{});
}

void TestHitParts::wallHitIsSplitAlongTheWallsNormal()
{
    Preset preset = twoCircles();
    preset.circles.pop_back();
    preset.circles[0].body = {.position = {3.0, 0.0}, .velocity = {3.0, 1.0}};
    Simulation simulation(preset);
    simulation.seekNextHit();
    const DrawList list = buildScene(SceneMoment(simulation), {}, lookAt(preset));
    const DrawList::Arrow along = arrowOf(list, theme().along);
    const DrawList::Arrow across = arrowOf(list, theme().across);
    QVERIFY(near(along.to - along.from, {0.75 * 3.0, 0.0}));
    QVERIFY(near(across.to - across.from, {0.0, 0.75 * 1.0}));
    QVERIFY(texts(list).contains(QStringLiteral("along 3.00")));
}

void TestHitParts::hitFadesWhileRunning()
{
    Simulation simulation(twoCircles());
    simulation.seekNextHit();
    for (int i = 0; i < 12; ++i)
        simulation.stepForward(); // 0.2 s later: half of 0.4 s
    const SceneMoment moment(simulation.preset(), simulation.recording(), simulation.current(),
                             true);
    const DrawList list = buildScene(moment, {}, lookAt(twoCircles()));
    const auto half = std::find_if(list.arrows.begin(), list.arrows.end(), [](const auto &arrow) {
        return arrow.colour.rgb() == theme().along.rgb();
    });
    QVERIFY(half != list.arrows.end());
    QVERIFY(std::abs(half->colour.alphaF() - 0.5f) < 0.01f);
}

QTEST_MAIN(TestHitParts)
#include "test_hit_parts.moc"
