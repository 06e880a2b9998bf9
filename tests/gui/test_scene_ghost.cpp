// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/scene_fixture.h"
#include "tests/patience.h"
#include "tests/showing_program.h"
#include "views/scene/ghost.h"
#include "views/scene/gl_canvas.h"
#include "views/scene/gl_painter.h"
#include "views/scene/raster_painter.h"

#include <QPainter>
#include <QTest>

#include <memory>

using namespace cradle::scenes;
using namespace cradle;

namespace {

/// A run in which the circles move straight on, \p offset from where they begin.
std::shared_ptr<Recording> straight(Vec2 offset, int steps, double dt = 1.0 / 60.0)
{
    auto recording = std::make_shared<Recording>();
    World world = initialWorld(twoCircles());
    for (Circle &circle : world.circles)
        circle.position += offset;
    for (int i = 0; i <= steps; ++i) {
        world.step = i;
        world.time = i * dt;
        recording->append(world);
        for (Circle &circle : world.circles)
            circle.position += dt * circle.velocity;
    }
    return recording;
}

/// Arrows without a head: dashes of outlines, and links.
int lines(const DrawList &list)
{
    return static_cast<int>(std::count_if(list.arrows.begin(), list.arrows.end(),
                                          [](const auto &arrow) { return arrow.head == 0.0; }));
}

} // namespace

class TestSceneGhost : public QObject
{
    Q_OBJECT
private slots:
    void circlesAreThoseOfTheTime_data();
    void circlesAreThoseOfTheTime();
    void ghostIsAnOutlineBesideItsCircle();
    void chipTellsTheGreatestDistance();
    void ghostFollowsRunAndSeek();
    void ghostEndsWithItsRecording();
    void sameRunShowsNoOutline();
    void chipsDoNotCoverEachOther();
    void exactOutlineIsFiner();
    void crowdOfGhostsIsBounded();
    void paintersLookAlike();
};

void TestSceneGhost::circlesAreThoseOfTheTime_data()
{
    QTest::addColumn<double>("time");
    QTest::addColumn<double>("x"); // of circle 1; NaN: no circles
    QTest::newRow("first") << 0.0 << -2.0;
    QTest::newRow("a frame") << 0.5 << -1.0;
    QTest::newRow("rounding before a frame") << 0.5 - 1e-15 << -1.0;
    QTest::newRow("between two frames") << 0.525 << -0.95;
    QTest::newRow("last") << 1.0 << 0.0;
    QTest::newRow("rounding after the last") << 1.0 + 1e-12 << 0.0;
    QTest::newRow("after the last") << 1.01 << qQNaN();
    QTest::newRow("before the first") << -0.01 << qQNaN();
}

void TestSceneGhost::circlesAreThoseOfTheTime()
{
    QFETCH(double, time);
    QFETCH(double, x);
    const auto circles = circlesAt(*straight({}, 20, 0.05), time);
    QCOMPARE(circles.empty(), qIsNaN(x));
    if (!circles.empty())
        QVERIFY(near(circles[0].position, {x, 2.3}, 1e-9));
}

void TestSceneGhost::ghostIsAnOutlineBesideItsCircle()
{
    Scene scene;
    const DrawList without = scene.view.picture().list;
    scene.view.setGhost(straight({0.0, -0.5}, 60), QStringLiteral("reference"));
    const DrawList with = scene.view.picture().list;
    QCOMPARE(with.discs, without.discs);
    QVERIFY(lines(with) >= 2 * (8 + 1)); // two broken outlines and two links
    int onOutline = 0;
    int links = 0;
    for (const DrawList::Arrow &arrow : with.arrows) {
        if (arrow.head > 0.0)
            continue;
        for (const Vec2 centre : {Vec2{-2.0, 1.8}, Vec2{2.0, 1.5}}) {
            onOutline += std::abs(length(arrow.from - centre) - 0.2) < 1e-9 ? 1 : 0;
            links += near(arrow.to, centre) ? 1 : 0;
        }
    }
    QCOMPARE(links, 2);
    QCOMPARE(onOutline + links, lines(with));
    scene.view.setGhost(nullptr, {});
    QVERIFY(scene.view.picture().list == without);
    QVERIFY(scene.chips().isEmpty());
}

void TestSceneGhost::chipTellsTheGreatestDistance()
{
    Scene scene;
    auto ghost = std::make_shared<Recording>();
    World world = initialWorld(twoCircles());
    world.circles[0].position += Vec2{0.003, 0.004};
    world.circles[1].position += Vec2{0.0, -0.031};
    ghost->append(world);
    scene.view.setGhost(ghost, QStringLiteral("reference"));
    QCOMPARE(scene.chips(), QStringList{QStringLiteral("ghost: reference · 0.031 m apart")});
    QVERIFY(scene.view.accessibleDescription().contains(QStringLiteral("0.031 m apart")));
}

void TestSceneGhost::ghostFollowsRunAndSeek()
{
    Scene scene;
    ShowingProgram program([](World &world, ProgramOutput &) {
        world.circles[1].position.y += 0.01; // a centimetre a step wrong
    });
    scene.simulation.setProgram(&program);
    scene.view.setGhost(straight({}, 60), QStringLiteral("reference"));
    QCOMPARE(scene.chips(), QStringList{QStringLiteral("ghost: reference · 0.000 m apart")});
    for (int i = 0; i < 20; ++i)
        scene.simulation.stepForward();
    QCOMPARE(scene.chips(), QStringList{QStringLiteral("ghost: reference · 0.200 m apart")});
    scene.simulation.seek(5);
    QCOMPARE(scene.chips(), QStringList{QStringLiteral("ghost: reference · 0.050 m apart")});
    scene.simulation.start();
    QTRY_VERIFY(scene.simulation.current() > 8);
    QVERIFY(scene.chips().at(0) != QStringLiteral("ghost: reference · 0.050 m apart"));
    scene.simulation.pause();
}

void TestSceneGhost::ghostEndsWithItsRecording()
{
    Scene scene;
    scene.view.setGhost(straight({0.0, 0.5}, 10), QStringLiteral("reference"));
    for (int i = 0; i < 10; ++i)
        scene.simulation.stepForward();
    QVERIFY(lines(scene.view.picture().list) > 0);
    scene.simulation.stepForward();
    QCOMPARE(lines(scene.view.picture().list), 0);
    QVERIFY(scene.chips().isEmpty());
}

void TestSceneGhost::sameRunShowsNoOutline()
{
    Scene scene;
    scene.view.setGhost(straight({0.0, 1e-6}, 10), QStringLiteral("reference"));
    QCOMPARE(lines(scene.view.picture().list), 0);
    QCOMPARE(scene.chips().size(), 1);
}

void TestSceneGhost::chipsDoNotCoverEachOther()
{
    const QSizeF viewport(400.0, 300.0);
    const Chip first{.text = QStringLiteral("ghost: reference · 0.031 m apart")};
    const Chip second{.text = QStringLiteral("first 5 s dropped"), .row = 1};
    const QRectF upper = chipRect(first, viewport, {});
    const QRectF lower = chipRect(second, viewport, {});
    QVERIFY(!upper.intersects(lower));
    QCOMPARE(upper.right(), lower.right());
}

void TestSceneGhost::exactOutlineIsFiner()
{
    const std::vector<Circle> circles(1, Circle{});
    const std::vector<Circle> ghost(1, Circle{.position = {0.5, 0.0}});
    const std::vector<QColor> colours(1, QColor(Qt::red));
    DrawList dashed;
    DrawList dotted;
    const Camera camera = lookAt(twoCircles()).camera;
    addGhost(dashed, circles, ghost, colours, camera);
    addGhost(dotted, circles, ghost, colours, camera, Outline::Dotted);
    QVERIFY(2 * dotted.arrows.size() > 3 * dashed.arrows.size());
    const auto dash = [](const DrawList &list) {
        return length(list.arrows[0].to - list.arrows[0].from);
    };
    QVERIFY(dash(dotted) < 0.5 * dash(dashed));
}

void TestSceneGhost::crowdOfGhostsIsBounded()
{
    const std::vector<Circle> circles(1000, Circle{});
    const std::vector<Circle> ghost(1000, Circle{.position = {0.3, 0.0}});
    DrawList list;
    addGhost(list, circles, ghost, std::vector<QColor>(1000, QColor(Qt::red)), Camera{});
    QVERIFY(list.arrows.size() <= 1000);
    QCOMPARE(list.discs.size(), std::size_t{1000});
    QVERIFY(!list.discs[0].fill.isValid());
}

void TestSceneGhost::paintersLookAlike()
{
    Scene scene;
    ShowingProgram program([](World &world, ProgramOutput &output) {
        const Vec2 a = world.circles[0].position;
        output.drawings = {{Drawing::Kind::Arrow, a, {1.0, -1.0}, QStringLiteral("orange"), {}},
                           {Drawing::Kind::Line, {-3.0, -3.0}, {3.0, 2.0}, {}, {}},
                           {Drawing::Kind::Point, {1.0, 1.0}, {}, QStringLiteral("red"), {}}};
    });
    scene.simulation.setProgram(&program);
    scene.view.setGhost(straight({0.1, -0.4}, 60), QStringLiteral("reference"));
    for (int i = 0; i < 5; ++i)
        scene.simulation.stepForward();
    ScenePicture picture = scene.view.picture();
    picture.list.labels.clear(); // their glyphs are smoothed in two ways
    picture.inset.reset();
    picture.chips.clear();
    picture.focusFrame = false;
    QImage byRaster(700, 700, QImage::Format_RGB32);
    {
        QPainter painter(&byRaster);
        paintShapes(painter, picture.list, picture.camera);
    }
    if (!glSupport().usable)
        QSKIP("no OpenGL 3.3 here");
    GlCanvas canvas([&]() -> const ScenePicture & { return picture; }, QStringLiteral(":/shaders"));
    canvas.resize(700, 700);
    canvas.show();
    QVERIFY(QTest::qWaitForWindowExposed(&canvas, patience));
    const QImage byGl = canvas.grabFramebuffer().convertToFormat(QImage::Format_RGB32);
    int different = 0;
    for (int y = 0; y < 700; ++y) {
        for (int x = 0; x < 700; ++x)
            different += std::abs(qGray(byGl.pixel(x, y)) - qGray(byRaster.pixel(x, y))) > 64;
    }
    QVERIFY2(different <= 20, qPrintable(QString::number(different)));
}

QTEST_MAIN(TestSceneGhost)
#include "test_scene_ghost.moc"
