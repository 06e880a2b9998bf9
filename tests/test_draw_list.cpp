// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/simulation.h"
#include "tests/scene_lists.h"
#include "views/circle_edits.h"
#include "views/scene/handles.h"
#include "views/theme.h"

#include <QTest>

using namespace cradle;
using namespace cradle::scenes;

class TestDrawList : public QObject
{
    Q_OBJECT
private slots:
    void startShowsCirclesAndVelocity();
    void optionsLeaveThingsOut();
    void trailFollowsTheRecording();
    void labelsNeverCoverEachOther();
    void discsAtOnePlaceShowBothNumbers();
    void crowdHasNoLabels();
    void sameMomentGivesTheSameList();
    void cameraMapsThereAndBack_data();
    void cameraMapsThereAndBack();
    void zoomKeepsThePlaceUnderThePointer();
    void dragSnapsUnlessFreed();
    void arrowsOfWhatFallsFitTheSquare();
    void circleOutOfSightIsPointedTo();
    void newCircleIsFreeAndNamed();
    void duplicateLiesOnTheOriginalWhereCirclesPass();
};

void TestDrawList::startShowsCirclesAndVelocity()
{
    const Simulation simulation(twoCircles());
    const DrawList list = buildScene(SceneMoment(simulation), {}, lookAt(twoCircles()));
    QCOMPARE(list.background, theme().scene);
    QCOMPARE(list.discs.size(), std::size_t{2});
    QCOMPARE(list.discs[0].centre, (Vec2{-2.0, 2.3}));
    QCOMPARE(list.discs[0].radius, 0.2);
    QCOMPARE(list.discs[1].fill, circleColour(QStringLiteral("#e03131")));
    // 0.75 m per m/s; the one at rest has none.
    QCOMPARE(list.arrows.size(), std::size_t{1});
    QVERIFY(near(list.arrows[0].from, {-2.0, 2.3}));
    QVERIFY(near(list.arrows[0].to, {-0.5, 2.3}));
    QCOMPARE(texts(list), (QStringList{QStringLiteral("1"), QStringLiteral("2")}));
    // 10 m are seen both ways, the outermost at the edge: 11 + 11 grid lines, 4 walls, no trail.
    QCOMPARE(list.lines.size(), std::size_t{26});
}

void TestDrawList::optionsLeaveThingsOut()
{
    Simulation simulation(twoCircles());
    simulation.seekNextHit();
    const SceneOptions none{false, false, false, false, false, false, false, false};
    const DrawList list = buildScene(SceneMoment(simulation), none, lookAt(twoCircles()));
    QCOMPARE(list.lines.size(), std::size_t{4});
    QCOMPARE(list.discs.size(), std::size_t{2});
    QVERIFY(list.arrows.empty());
    QVERIFY(list.labels.empty());
}

void TestDrawList::trailFollowsTheRecording()
{
    Simulation simulation(twoCircles());
    for (int i = 0; i < 30; ++i)
        simulation.stepForward();
    SceneOptions options;
    options.grid = false;
    const DrawList list = buildScene(SceneMoment(simulation), options, lookAt(twoCircles()));
    QCOMPARE(list.lines.size(), std::size_t{4 + 30});
    QVERIFY(near(list.lines[4].from, {-2.0, 2.3}));
    QVERIFY(near(list.lines.back().to, {-1.0, 2.3}));
    QVERIFY(list.lines[4].colour.alphaF() < list.lines.back().colour.alphaF());
}

void TestDrawList::labelsNeverCoverEachOther()
{
    Preset preset = twoCircles();
    preset.laws.circles = CircleLaw::None;
    for (int i = 0; i < 20; ++i) {
        PresetCircle circle = preset.circles[0];
        circle.name = QStringLiteral("a long name %1").arg(i);
        circle.body.position = {0.1 * (i % 5), 0.1 * (i % 3)};
        preset.circles.push_back(circle);
    }
    const Simulation simulation(preset);
    SceneLook look = lookAt(preset, {400.0, 300.0});
    look.selected = 0;
    const DrawList list = buildScene(SceneMoment(simulation), {}, look);
    QVERIFY(list.labels.size() > 5);
    QVERIFY(!textOverText(list, look.camera, look.font));
}

void TestDrawList::discsAtOnePlaceShowBothNumbers()
{
    Preset preset = twoCircles();
    const auto texts = [&] {
        const Simulation simulation(preset);
        QStringList all;
        for (const DrawList::Label &label :
             buildScene(SceneMoment(simulation), {}, lookAt(preset)).labels)
            all.append(label.text);
        return all;
    };
    QVERIFY(texts().contains(QStringLiteral("1")) && texts().contains(QStringLiteral("2")));
    preset.circles[1].body.position = preset.circles[0].body.position;
    QVERIFY(texts().contains(QStringLiteral("1, 2")));
    QVERIFY(!texts().contains(QStringLiteral("1"))); // which could be that of the topmost
}

void TestDrawList::crowdHasNoLabels()
{
    Preset preset;
    preset.circles =
        *makeCircles({.count = 1000, .radius = 0.05, .rmsSpeed = 2.0}, preset.halfWidth);
    const Simulation simulation(preset);
    SceneLook look = lookAt(preset);
    const DrawList plain = buildScene(SceneMoment(simulation), {}, look);
    QCOMPARE(plain.discs.size(), std::size_t{1000});
    QVERIFY(plain.labels.empty());
    QVERIFY(plain.arrows.empty());
    look.selected = 7;
    const DrawList marked = buildScene(SceneMoment(simulation), {}, look);
    QCOMPARE(marked.arrows.size(), std::size_t{1});
    QCOMPARE(marked.labels.size(), std::size_t{2}); // its number and its speed
}

void TestDrawList::sameMomentGivesTheSameList()
{
    Simulation simulation(twoCircles());
    simulation.seekNextHit();
    const SceneLook look = lookAt(twoCircles());
    const DrawList first = buildScene(SceneMoment(simulation), {}, look);
    QVERIFY(first == buildScene(SceneMoment(simulation), {}, look));
    simulation.stepForward();
    QVERIFY(first != buildScene(SceneMoment(simulation), {}, look));
}

void TestDrawList::cameraMapsThereAndBack_data()
{
    QTest::addColumn<QSizeF>("viewport");
    QTest::addColumn<double>("pixelsPerMetre");
    QTest::newRow("square") << QSizeF(700.0, 700.0) << 70.0;
    QTest::newRow("wide") << QSizeF(1200.0, 500.0) << 50.0;
    QTest::newRow("high") << QSizeF(300.0, 900.0) << 30.0;
}

void TestDrawList::cameraMapsThereAndBack()
{
    QFETCH(QSizeF, viewport);
    Camera camera;
    camera.fit(4.0); // 10 m on the shorter side
    camera.resize(viewport);
    QTEST(camera.pixelsPerMetre(), "pixelsPerMetre");
    QCOMPARE(camera.toPixels({}), camera.middle());
    QVERIFY(camera.toPixels({0.0, 1.0}).y() < camera.middle().y()); // y up
    camera.panBy({31.0, -17.0});
    camera.zoomAbout({20.0, 40.0}, 1.7);
    for (const Vec2 place : {Vec2{}, Vec2{-3.7, 1.2}, Vec2{100.0, -50.0}})
        QVERIFY(near(camera.toMetres(camera.toPixels(place)), place));
}

void TestDrawList::zoomKeepsThePlaceUnderThePointer()
{
    Camera camera;
    camera.resize({640.0, 480.0});
    const QPointF pointer(100.0, 400.0);
    const Vec2 held = camera.toMetres(pointer);
    const double before = camera.pixelsPerMetre();
    camera.zoomAbout(pointer, 2.0);
    QCOMPARE(camera.pixelsPerMetre(), 2.0 * before);
    QVERIFY(near(camera.toMetres(pointer), held));
}

void TestDrawList::dragSnapsUnlessFreed()
{
    const HandleDrag move({Handle::Kind::Circle, 0}, twoCircles(), {-2.0, 2.3}, {},
                          arrowScale(twoCircles()));
    const Preset snapped = move.candidate({-1.234, 1.066}, true);
    QCOMPARE(snapped.circles[0].body.position, (Vec2{-1.2, 1.1}));
    QCOMPARE(move.valueText(snapped), QStringLiteral("(−1.20, 1.10) m"));
    const Preset freed = move.candidate({-1.234, 1.066}, false);
    QVERIFY(near(freed.circles[0].body.position, {-1.234, 1.066}));
    // 0.75 m of arrow are 1 m/s.
    const HandleDrag pull({Handle::Kind::Velocity, 1}, twoCircles(), {2.0, 2.0}, {},
                          arrowScale(twoCircles()));
    const Preset pulled = pull.candidate({2.75, 2.0}, true);
    QCOMPARE(pulled.circles[1].body.velocity, (Vec2{1.0, 0.0}));
    QCOMPARE(pull.valueText(pulled), QStringLiteral("(1.00, 0.00) m/s, speed 1.00 m/s"));
    QVERIFY(move.mergeKey() != pull.mergeKey());
}

void TestDrawList::arrowsOfWhatFallsFitTheSquare()
{
    Preset preset = twoCircles();
    preset.gravity = {};
    QCOMPARE(arrowTip({1.0, 0.0}, {2.0, 0.0}, preset), (Vec2{2.5, 0.0}));
    // Through 8 m at 9.81 m/s²: v = √(2 g h) = 12.53 m/s, drawn 6 m long, and less in proportion.
    preset.gravity = {0.0, -9.81};
    const double fallen = std::sqrt(2.0 * 9.81 * 8.0);
    QVERIFY(near(arrowTip({}, {0.0, -fallen}, preset), {0.0, -6.0}));
    QVERIFY(near(arrowTip({}, {0.5 * fallen, 0.0}, preset), {3.0, 0.0}));
    // Where little can be gained by falling, arrows are as long as ever.
    preset.gravity = {0.0, -0.5};
    QCOMPARE(arrowTip({}, {2.0, 0.0}, preset), (Vec2{1.5, 0.0}));
}

/// 700 px show 10 m: the edge is 5 m from the centre.
void TestDrawList::circleOutOfSightIsPointedTo()
{
    Preset preset = twoCircles();
    preset.laws.walls = WallLaw::None;
    preset.circles[0].body = {.position = {-12.0, 3.0}, .velocity = {-1.0, 0.0}};
    const Simulation simulation(preset);
    const SceneLook look = lookAt(preset);
    const DrawList list = buildScene(SceneMoment(simulation), {}, look);
    QCOMPARE(list.discs.size(), std::size_t{2});
    QCOMPARE(list.arrows.size(), std::size_t{1}); // no velocity besides
    const DrawList::Arrow &pointer = list.arrows[0];
    QCOMPARE(pointer.colour, circleColour(preset.circles[0].colour));
    QVERIFY(near(pointer.to, {-5.0 + 6.0 / 70.0, 3.0}));
    QVERIFY(near(normalized(pointer.to - pointer.from), {-1.0, 0.0}));
    const auto name = std::find_if(list.labels.begin(), list.labels.end(), [](const auto &label) {
        return label.text == QStringLiteral("1");
    });
    QVERIFY(name != list.labels.end());
    const QFontMetricsF metrics(labelFont(look.font));
    QVERIFY(QRectF({}, look.camera.viewport()).contains(labelRect(*name, look.camera, metrics)));
    // With its rim at the edge it is seen.
    preset.circles[0].body.position = {-5.1, 3.0};
    const Simulation nearer(preset);
    const DrawList seen = buildScene(SceneMoment(nearer), {}, look);
    QVERIFY(near(seen.arrows[0].from, {-5.1, 3.0}));
}

void TestDrawList::newCircleIsFreeAndNamed()
{
    Preset preset = twoCircles();
    preset.fill = CircleFill{.count = 2};
    for (int i = 0; i < 12; ++i) {
        preset = withAddedCircle(preset, Vec2{2.0, 2.0});
        QVERIFY(!findFault(preset));
    }
    QVERIFY(!preset.fill);
    QCOMPARE(preset.circles[2].name, QStringLiteral("circle 3"));
    QCOMPARE(preset.circles[2].colour, QStringLiteral("#e69f00"));
    QCOMPARE(preset.circles[2].body.velocity, Vec2{});
    const Preset corner = withAddedCircle(twoCircles(), Vec2{50.0, -50.0});
    QVERIFY(near(corner.circles.back().body.position, {3.8, -3.8}));
}

void TestDrawList::duplicateLiesOnTheOriginalWhereCirclesPass()
{
    Preset preset = twoCircles();
    const Preset beside = withDuplicate(preset, 0);
    QVERIFY(!findFault(beside));
    QVERIFY(beside.circles[2].body.position != beside.circles[0].body.position);
    QCOMPARE(beside.circles[2].body.velocity, (Vec2{2.0, 0.0}));
    preset.laws.circles = CircleLaw::None;
    const Preset upon = withDuplicate(preset, 0);
    QCOMPARE(upon.circles[2].body, upon.circles[0].body);
    QCOMPARE(upon.circles[2].name, QStringLiteral("circle 3"));
    QCOMPARE(withoutCircle(upon, 0).circles.size(), std::size_t{2});
}

QTEST_MAIN(TestDrawList)
#include "test_draw_list.moc"
