// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/simulation.h"
#include "views/circle_edits.h"
#include "views/scene/handles.h"
#include "views/scene/scene_builder.h"
#include "views/scene/scene_labels.h"
#include "views/theme.h"

#include <QtTest>

#include <algorithm>

using namespace cradle;

namespace {

/// Two steel circles of 0.2 m; the first comes with 2 m/s, the second rests 0.3 m lower.
Preset glancing()
{
    Preset preset;
    preset.laws = {WallLaw::Reflect, CircleLaw::SwapNormal, Timing::Discrete};
    preset.circles = {
        {.name = QStringLiteral("circle 1"),
         .body = {.position = {-2.0, 2.3}, .velocity = {2.0, 0.0}}},
        {.name = QStringLiteral("circle 2"),
         .body = {.position = {2.0, 2.0}},
         .colour = QStringLiteral("#e03131")},
    };
    return preset;
}

SceneLook lookAt(const Preset &preset, QSizeF viewport = {700.0, 700.0})
{
    SceneLook look;
    look.camera.fit(preset.halfWidth);
    look.camera.resize(viewport);
    return look;
}

QStringList texts(const DrawList &list)
{
    QStringList found;
    for (const DrawList::Label &label : list.labels)
        found << label.text;
    return found;
}

/// The arrow of \p colour; there must be one.
DrawList::Arrow arrowOf(const DrawList &list, const QColor &colour)
{
    const auto found = std::find_if(list.arrows.begin(), list.arrows.end(),
                                    [&](const auto &arrow) { return arrow.colour == colour; });
    return found == list.arrows.end() ? DrawList::Arrow{} : *found;
}

bool near(Vec2 a, Vec2 b, double tolerance = 1e-9)
{
    return length(a - b) <= tolerance;
}

/// Whether labels cover each other.
bool textOverText(const DrawList &list, const Camera &camera, const QFont &font)
{
    std::vector<QRectF> rects;
    for (const DrawList::Label &label : list.labels)
        rects.push_back(labelRect(label, camera, QFontMetricsF(labelFont(font, label.strong))));
    for (std::size_t i = 0; i < rects.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (rects[i].intersects(rects[j]))
                return true;
        }
    }
    return false;
}

} // namespace

class TestDrawList : public QObject
{
    Q_OBJECT
private slots:
    void startShowsCirclesAndVelocity();
    void optionsLeaveThingsOut();
    void trailFollowsTheRecording();
    void hitIsSplitAlongAndAcross();
    void wallHitIsSplitAlongTheWallsNormal();
    void hitFadesWhileRunning();
    void labelsNeverCoverEachOther();
    void crowdHasNoLabels();
    void sameMomentGivesTheSameList();
    void cameraMapsThereAndBack_data();
    void cameraMapsThereAndBack();
    void zoomKeepsThePlaceUnderThePointer();
    void dragSnapsUnlessFreed();
    void newCircleIsFreeAndNamed();
    void duplicateLiesOnTheOriginalWhereCirclesPass();
};

void TestDrawList::startShowsCirclesAndVelocity()
{
    const Simulation simulation(glancing());
    const DrawList list = buildScene(SceneMoment(simulation), {}, lookAt(glancing()));
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
    Simulation simulation(glancing());
    simulation.seekNextHit();
    const SceneOptions none{false, false, false, false, false};
    const DrawList list = buildScene(SceneMoment(simulation), none, lookAt(glancing()));
    QCOMPARE(list.lines.size(), std::size_t{4});
    QCOMPARE(list.discs.size(), std::size_t{2});
    QVERIFY(list.arrows.empty());
    QVERIFY(list.labels.empty());
}

void TestDrawList::trailFollowsTheRecording()
{
    Simulation simulation(glancing());
    for (int i = 0; i < 30; ++i)
        simulation.stepForward();
    SceneOptions options;
    options.grid = false;
    const DrawList list = buildScene(SceneMoment(simulation), options, lookAt(glancing()));
    QCOMPARE(list.lines.size(), std::size_t{4 + 30});
    QVERIFY(near(list.lines[4].from, {-2.0, 2.3}));
    QVERIFY(near(list.lines.back().to, {-1.0, 2.3}));
    QVERIFY(list.lines[4].colour.alphaF() < list.lines.back().colour.alphaF());
}

void TestDrawList::hitIsSplitAlongAndAcross()
{
    Simulation simulation(glancing());
    simulation.seekNextHit();
    // The first step that would overlap is where 4 − t·2 < √(0.4² − 0.3²) = 0.26458: step 113;
    // both go back to step 112, where circle 1 is at x = −2 + 112/30 = 1.73333.
    QCOMPARE(simulation.current(), qint64{113});
    const Vec2 at{-2.0 + 112.0 / 30.0, 2.3};
    const Vec2 n = normalized(Vec2{2.0, 2.0} - at);
    const Vec2 along = 2.0 * n.x * n;
    const Vec2 across = Vec2{2.0, 0.0} - along;
    const DrawList list = buildScene(SceneMoment(simulation), {}, lookAt(glancing()));
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
    const DrawList later = buildScene(SceneMoment(simulation), {}, lookAt(glancing()));
    QCOMPARE(arrowOf(later, theme().along), DrawList::Arrow{});
}

void TestDrawList::wallHitIsSplitAlongTheWallsNormal()
{
    Preset preset = glancing();
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

void TestDrawList::hitFadesWhileRunning()
{
    Simulation simulation(glancing());
    simulation.seekNextHit();
    for (int i = 0; i < 12; ++i)
        simulation.stepForward(); // 0.2 s later: half of 0.4 s
    const SceneMoment moment(simulation.preset(), simulation.recording(), simulation.current(),
                             true);
    const DrawList list = buildScene(moment, {}, lookAt(glancing()));
    const auto half = std::find_if(list.arrows.begin(), list.arrows.end(), [](const auto &arrow) {
        return arrow.colour.rgb() == theme().along.rgb();
    });
    QVERIFY(half != list.arrows.end());
    QVERIFY(std::abs(half->colour.alphaF() - 0.5f) < 0.01f);
}

void TestDrawList::labelsNeverCoverEachOther()
{
    Preset preset = glancing();
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
    Simulation simulation(glancing());
    simulation.seekNextHit();
    const SceneLook look = lookAt(glancing());
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
    const HandleDrag move({Handle::Kind::Circle, 0}, glancing(), {-2.0, 2.3});
    const Preset snapped = move.candidate({-1.234, 1.066}, true);
    QCOMPARE(snapped.circles[0].body.position, (Vec2{-1.2, 1.1}));
    QCOMPARE(move.valueText(snapped), QStringLiteral("(−1.20, 1.10) m"));
    const Preset freed = move.candidate({-1.234, 1.066}, false);
    QVERIFY(near(freed.circles[0].body.position, {-1.234, 1.066}));
    // 0.75 m of arrow are 1 m/s.
    const HandleDrag pull({Handle::Kind::Velocity, 1}, glancing(), {2.0, 2.0});
    const Preset pulled = pull.candidate({2.75, 2.0}, true);
    QCOMPARE(pulled.circles[1].body.velocity, (Vec2{1.0, 0.0}));
    QCOMPARE(pull.valueText(pulled), QStringLiteral("(1.00, 0.00) m/s"));
    QVERIFY(move.mergeKey() != pull.mergeKey());
}

void TestDrawList::newCircleIsFreeAndNamed()
{
    Preset preset = glancing();
    preset.fill = CircleFill{.count = 2};
    for (int i = 0; i < 12; ++i) {
        preset = withAddedCircle(preset, Vec2{2.0, 2.0});
        QVERIFY(!findFault(preset));
    }
    QVERIFY(!preset.fill);
    QCOMPARE(preset.circles[2].name, QStringLiteral("circle 3"));
    QCOMPARE(preset.circles[2].colour, QStringLiteral("#e69f00"));
    QCOMPARE(preset.circles[2].body.velocity, Vec2{});
    const Preset corner = withAddedCircle(glancing(), Vec2{50.0, -50.0});
    QVERIFY(near(corner.circles.back().body.position, {3.8, -3.8}));
}

void TestDrawList::duplicateLiesOnTheOriginalWhereCirclesPass()
{
    Preset preset = glancing();
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
