// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/simulation.h"
#include "model/world/measurements.h"
#include "tests/scene_lists.h"
#include "views/theme.h"

#include <QTest>

#include <cmath>

using namespace cradle;
using namespace cradle::scenes;

namespace {

DrawList listOf(const Simulation &simulation, bool shown)
{
    SceneOptions options;
    options.grid = options.trails = options.hitParts = options.names = false;
    options.centreOfMass = shown;
    return buildScene(SceneMoment(simulation), options, lookAt(simulation.preset()));
}

} // namespace

class TestCentreOfMass : public QObject
{
    Q_OBJECT
private slots:
    void isMarkedWhereItIs();
    void itsWayIsStraightThroughAHit();
    void isNotShownUnlessAsked();
    void crowdsAndEmptyScenesAreFine();
};

void TestCentreOfMass::isMarkedWhereItIs()
{
    Preset preset = twoCircles();
    preset.circles[1].body.density *= 3.0; // at three quarters of the way to circle 2
    const Simulation simulation(preset);
    const DrawList list = listOf(simulation, true);
    const DrawList::Disc mark = list.discs.back();
    QVERIFY(near(mark.centre, {1.0, 2.075}));
    QCOMPARE(mark.outline, theme().text);
    QVERIFY(texts(list).contains(QStringLiteral("centre of mass")));
    QCOMPARE(list.lines.size(), std::size_t{4}); // the square; it has no way so far
}

void TestCentreOfMass::itsWayIsStraightThroughAHit()
{
    Simulation simulation(twoCircles());
    simulation.goTo(150); // 2.5 s; they meet at 1.88 s
    QCOMPARE(simulation.recording().hits().size(), std::size_t{1});
    const DrawList list = listOf(simulation, true);
    QVERIFY(list.lines.size() > 50);
    // Masses are equal: from (0, 2.15) with 1 m/s to the right, whatever the hit does. The step of
    // the hit goes back to the old positions, which takes a sixtieth of a metre from it.
    QVERIFY(near(list.lines[4].from, {0.0, 2.15}));
    for (std::size_t i = 4; i < list.lines.size(); ++i) {
        QVERIFY(std::abs(list.lines[i].to.y - 2.15) < 1e-9);
        QVERIFY(list.lines[i].to.x > list.lines[i].from.x);
    }
    QVERIFY(near(list.lines.back().to, {149.0 / 60.0, 2.15}));
    QVERIFY(list.lines[4].colour.alphaF() < list.lines.back().colour.alphaF());
}

void TestCentreOfMass::isNotShownUnlessAsked()
{
    const Simulation simulation(twoCircles());
    const DrawList list = listOf(simulation, false);
    QCOMPARE(list.discs.size(), std::size_t{2});
    QVERIFY(!texts(list).contains(QStringLiteral("centre of mass")));
    QVERIFY(!SceneOptions().centreOfMass);
}

void TestCentreOfMass::crowdsAndEmptyScenesAreFine()
{
    Preset empty;
    QVERIFY(listOf(Simulation(empty), true).discs.empty());
    Preset crowd;
    crowd.circles = *makeCircles({.count = 2000, .radius = 0.04, .rmsSpeed = 2.0}, crowd.halfWidth);
    Simulation simulation(crowd);
    simulation.goTo(200);
    const DrawList list = listOf(simulation, true);
    QCOMPARE(list.discs.size(), std::size_t{2001});
    QVERIFY(near(list.discs.back().centre, centreOfMass(simulation.recording().circles(200))));
    QVERIFY(list.lines.size() <= 4 + 91);
}

QTEST_MAIN(TestCentreOfMass)
#include "test_centre_of_mass.moc"
