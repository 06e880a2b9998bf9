// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/scene_fixture.h"
#include "tests/scenes.h"
#include "views/scene/gl_canvas.h"
#include "views/scene/loupe.h"
#include "views/theme.h"

#include <QPainter>
#include <QTest>

using namespace cradle::scenes;
using namespace cradle;

class TestSceneView : public QObject
{
    Q_OBJECT
private slots:
    void wheelAndDragMoveTheCamera();
    void cameraFollowsTheCentreOfMass();
    void momentaStandInAnInset();
    void hitIsEnlargedInACorner();
    void magnificationIsReadOverAll();
    void loupeIsOnlyWhereItShowsMore();
    void hitIsZoomedTo();
    void emptySceneTellsWhatToDo();
    void pictureHasTheSizeAskedFor();
    void descriptionTellsPositions();
    void mergedContactsAreSaid();
};

void TestSceneView::wheelAndDragMoveTheCamera()
{
    Scene scene;
    const Camera fitted = scene.view.camera();
    scene.press({0.0, 0.0}); // on empty space
    scene.moveTo(QPointF(385.0, 350.0));
    scene.moveTo(QPointF(420.0, 315.0));
    scene.release({0.0, 0.0});
    // 70 px right and 35 px up, at 70 px/m
    QVERIFY(length(scene.view.camera().centre() - Vec2{-1.0, -0.5}) < 1e-9);
    const QPointF at(200.0, 100.0);
    const Vec2 held = scene.view.camera().toMetres(at);
    QWheelEvent wheel(at, scene.view.mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&scene.view, &wheel);
    QVERIFY(scene.view.camera().pixelsPerMetre() > fitted.pixelsPerMetre());
    QVERIFY(length(scene.view.camera().toMetres(at) - held) < 1e-9);
    scene.view.fit();
    QCOMPARE(scene.view.camera(), fitted);
    QCOMPARE(scene.document.preset(), twoCircles());
}

void TestSceneView::cameraFollowsTheCentreOfMass()
{
    Scene scene;
    const Camera fitted = scene.view.camera();
    scene.view.followCentreOfMass(true);
    QVERIFY(near(scene.view.camera().centre(), {0.0, 2.15})); // of equal masses
    scene.simulation.goTo(60);
    QVERIFY(near(scene.view.camera().centre(), {1.0, 2.15}));
    // Moved aside by hand it stays as far aside.
    scene.drag({1.0, 0.0}, {2.0, 0.0});
    const Vec2 aside = scene.view.camera().centre() - Vec2{1.0, 2.15};
    QVERIFY(aside.x < -0.4);
    scene.simulation.goTo(90);
    QVERIFY(near(scene.view.camera().centre(), Vec2{1.5, 2.15} + aside));
    scene.view.fit();
    QVERIFY(near(scene.view.camera().centre(), {1.5, 2.15}));
    QCOMPARE(scene.view.camera().extent(), fitted.extent());
    scene.view.followCentreOfMass(false);
    scene.simulation.goTo(100);
    QVERIFY(near(scene.view.camera().centre(), {1.5, 2.15}));
    // What is dragged stays under the pointer.
    scene.simulation.restart();
    scene.view.fit();
    scene.view.followCentreOfMass(true);
    const Vec2 centre = scene.view.camera().centre();
    scene.press({-2.0, 2.3});
    scene.moveTo(Vec2{-1.5, 2.0});
    scene.moveTo(Vec2{-1.0, 1.3});
    QCOMPARE(scene.circle(0).position, (Vec2{-1.0, 1.3}));
    QCOMPARE(scene.view.camera().centre(), centre);
    scene.release({-1.0, 1.3});
    QVERIFY(near(scene.view.camera().centre(), {0.5, 1.65}));
}

void TestSceneView::momentaStandInAnInset()
{
    Scene scene;
    scene.simulation.seekNextHit();
    const ScenePicture &shown = scene.view.picture();
    QVERIFY(shown.inset);
    for (const DrawList::Label &label : shown.list.labels)
        QVERIFY(!labelRect(label, shown.camera, QFontMetricsF(labelFont(shown.font)))
                     .intersects(shown.inset->frame));
    const QImage with = scene.view.renderToImage({700, 700});
    SceneOptions options = scene.view.options();
    options.momenta = false;
    scene.view.setOptions(options);
    QVERIFY(!scene.view.picture().inset);
    QVERIFY(with != scene.view.renderToImage({700, 700}));
}

void TestSceneView::hitIsEnlargedInACorner()
{
    Scene scene;
    QVERIFY(!scene.view.picture().loupe); // nothing hits anything
    scene.simulation.seekNextHit();
    const ScenePicture &shown = scene.view.picture();
    QVERIFY(shown.loupe);
    const Loupe &loupe = *shown.loupe;
    const Hit &hit = scene.simulation.recording().hits().back();
    const Circle &circle = scene.simulation.recording().circles(
        scene.simulation.current())[static_cast<std::size_t>(hit.a)];
    // The middle of the loupe is where the circle touched: on its edge, along the normal, before
    // it moved on with its new velocity.
    const double since = scene.simulation.time() - hit.time;
    const Vec2 contact = circle.position - since * hit.afterA + circle.radius * hit.normal;
    QVERIFY(length(loupe.camera.centre() - contact) < 1e-12);
    QCOMPARE(loupe.magnification, loupe.camera.pixelsPerMetre() / shown.camera.pixelsPerMetre());
    QVERIFY(loupe.magnification > 1.5);
    // It hides no circle, no other inset and no label, and not the hit itself.
    QVERIFY(!loupe.frame.contains(shown.camera.toPixels(contact)));
    QVERIFY(!shown.inset || !loupe.frame.intersects(shown.inset->frame));
    for (const Circle &each : scene.simulation.recording().circles(scene.simulation.current()))
        QVERIFY(!loupe.frame.contains(shown.camera.toPixels(each.position)));
    for (const DrawList::Label &label : shown.list.labels)
        QVERIFY(!labelRect(label, shown.camera, QFontMetricsF(labelFont(shown.font)))
                     .intersects(loupe.frame));
    const QImage with = scene.view.renderToImage({700, 700});
    SceneOptions options = scene.view.options();
    options.loupe = false;
    scene.view.setOptions(options);
    QVERIFY(!scene.view.picture().loupe);
    QVERIFY(with != scene.view.renderToImage({700, 700}));
}

void TestSceneView::magnificationIsReadOverAll()
{
    Loupe loupe{.frame = QRectF(0.0, 0.0, 120.0, 120.0), .magnification = 3.0};
    loupe.camera.resize(loupe.frame.size());
    loupe.list.background = theme().scene;
    loupe.list.discs.push_back({.centre = {}, .radius = 1e3, .fill = Qt::red});
    QImage image(120, 120, QImage::Format_RGB32);
    QPainter painter(&image);
    paintLoupe(painter, loupe, QFont());
    painter.end();
    QCOMPARE(image.pixelColor(20, 100), QColor(Qt::red));
    QCOMPARE(image.pixelColor(114, 6), theme().scene); // beside the last letter
}

void TestSceneView::loupeIsOnlyWhereItShowsMore()
{
    Scene scene;
    scene.simulation.seekNextHit();
    QVERIFY(scene.view.picture().loupe);
    scene.simulation.start(); // a run would flicker, and pay for it
    QVERIFY(!scene.view.picture().loupe);
    scene.simulation.pause();
    scene.simulation.restart();
    scene.simulation.seekNextHit();
    scene.view.resize(260, 220); // no room
    QVERIFY(!scene.view.picture().loupe);
    scene.view.resize(700, 700);
    QVERIFY(scene.view.picture().loupe);
    scene.view.zoomToHit(); // as near already
    QVERIFY(!scene.view.picture().loupe);
}

void TestSceneView::hitIsZoomedTo()
{
    Scene scene;
    const Camera before = scene.view.camera();
    scene.view.zoomToHit();
    QCOMPARE(scene.view.camera(), before);
    QVERIFY(scene.chips().filter(QStringLiteral("No hit")).size() == 1);
    scene.simulation.seekNextHit();
    scene.view.followCentreOfMass(true);
    scene.view.zoomToHit();
    const std::optional<Camera> near =
        cameraAtHit(SceneMoment(scene.simulation), -1, scene.view.size());
    QVERIFY(near);
    QVERIFY(length(scene.view.camera().centre() - near->centre()) < 1e-12);
    QVERIFY(scene.view.camera().pixelsPerMetre() > 1.5 * before.pixelsPerMetre());
    scene.view.followCentreOfMass(false);
    scene.view.fit();
    QCOMPARE(scene.view.camera(), before);
}

void TestSceneView::emptySceneTellsWhatToDo()
{
    Scene scene;
    QVERIFY(scene.chips().isEmpty());
    Preset empty = twoCircles();
    empty.circles.clear();
    scene.document.open(empty);
    QCOMPARE(scene.chips().size(), 1);
    QVERIFY(scene.chips().first().contains(QStringLiteral("Ctrl+Shift+N")));
    scene.view.addCircle();
    QVERIFY(scene.chips().isEmpty());
    QCOMPARE(scene.document.preset().circles.front().name, QStringLiteral("circle 1"));
}

void TestSceneView::pictureHasTheSizeAskedFor()
{
    Scene scene;
    const QImage image = scene.view.renderToImage({300, 200}, 2.0);
    QCOMPARE(image.size(), QSize(600, 400));
    QCOMPARE(image.devicePixelRatio(), 2.0);
    const QImage plain = scene.view.renderToImage({300, 200}, 1.0);
    scene.view.select(0);
    QCOMPARE(scene.view.renderToImage({300, 200}, 1.0), plain); // no ring
}

void TestSceneView::descriptionTellsPositions()
{
    Scene scene;
    QCOMPARE(scene.view.accessibleName(), QStringLiteral("Scene"));
    QVERIFY(
        scene.view.accessibleDescription().contains(QStringLiteral("circle 1 at (−2.00, 2.30) m")));
    for (int i = 0; i < 3; ++i)
        scene.simulation.stepForward();
    QVERIFY(
        scene.view.accessibleDescription().contains(QStringLiteral("circle 1 at (−1.90, 2.30) m")));
}

void TestSceneView::mergedContactsAreSaid()
{
    Scene scene;
    scene.document.open(scenes::fallingHeap(200, 0.5));
    scene.simulation.goTo(10);
    QVERIFY(scene.chips().isEmpty());
    while (!scene.simulation.mergedFrom() && scene.simulation.time() < 3.0)
        scene.simulation.stepForward();
    const auto from = scene.simulation.mergedFrom();
    QVERIFY(from.has_value());
    const QString said =
        QStringLiteral("contacts merged from %1 s on").arg(QString::number(*from, 'f', 2));
    QCOMPARE(scene.chips(), QStringList{said});
    QVERIFY(scene.view.accessibleDescription().contains(said));
    scene.simulation.stepBack(); // up to there every hit is exact
    QVERIFY(scene.chips().isEmpty());
}

QTEST_MAIN(TestSceneView)
#include "test_scene_view.moc"
