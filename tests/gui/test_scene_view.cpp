// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/simulation.h"
#include "views/preset_document.h"
#include "views/scene/gl_canvas.h"
#include "views/scene/gl_painter.h"
#include "views/scene/raster_canvas.h"
#include "views/scene/raster_painter.h"
#include "views/scene/scene_view.h"

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalSpy>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace cradle;

namespace {

Preset twoCircles()
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

/// A scene of two circles in a window of its own.
struct Scene {
    Simulation simulation{twoCircles()};
    PresetDocument document{simulation};
    SceneView view{document};

    Scene()
    {
        view.resize(700, 700);
        view.show();
        (void)QTest::qWaitForWindowExposed(&view);
        view.activateWindow();
        view.setFocus();
    }

    [[nodiscard]] const Circle &circle(int index) const
    {
        return document.preset().circles[static_cast<std::size_t>(index)].body;
    }
    [[nodiscard]] QPoint pixel(Vec2 place) const { return view.camera().toPixels(place).toPoint(); }

    /// QTest::mouseMove() tells no buttons.
    void moveTo(QPointF at, Qt::KeyboardModifiers keys = {})
    {
        QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                         keys);
        QCoreApplication::sendEvent(&view, &move);
    }
    void moveTo(Vec2 place, Qt::KeyboardModifiers keys = {})
    {
        moveTo(view.camera().toPixels(place), keys);
    }
    void press(Vec2 place) { QTest::mousePress(&view, Qt::LeftButton, {}, pixel(place)); }
    void release(Vec2 place) { QTest::mouseRelease(&view, Qt::LeftButton, {}, pixel(place)); }
    void drag(Vec2 from, Vec2 to)
    {
        press(from);
        moveTo(from + 0.5 * (to - from));
        moveTo(to);
        release(to);
    }
    [[nodiscard]] QStringList chips()
    {
        QStringList texts;
        for (const Chip &chip : view.picture().chips)
            texts << chip.text;
        return texts;
    }
};

/// Mean absolute difference of the channels, of 255.
double difference(const QImage &a, const QImage &b)
{
    qint64 sum = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            sum += std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q))
                   + std::abs(qBlue(p) - qBlue(q));
        }
    }
    return static_cast<double>(sum) / (3.0 * a.width() * a.height());
}

/// How many pixels differ so much that they do not just have another shade at an edge.
int differentPixels(const QImage &a, const QImage &b)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            count += std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                               std::abs(qBlue(p) - qBlue(q))})
                     > 64;
        }
    }
    return count;
}

/// Whether \p image shows something: its pixels are not all the same.
bool showsSomething(const QImage &image)
{
    const QRgb first = image.pixel(0, 0);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (image.pixel(x, y) != first)
                return true;
        }
    }
    return false;
}

} // namespace

class TestSceneView : public QObject
{
    Q_OBJECT
private slots:
    void paintersLookAlike();
    void shapesLookAlikeToThePixel();
    void brokenShadersFallBackToRaster();
    void rendererCanBeChanged();
    void dragMovesACircleInOneUndoStep();
    void altFreesADragFromTheGrid();
    void dragOfTheTipChangesTheVelocity();
    void circleAtRestHasAGrip();
    void refusedPlaceLeavesThePresetAlone();
    void laterDragOnlyTellsWhatToDo();
    void clickSelects();
    void doubleClickActivates();
    void tabGoesFromCircleToCircle();
    void controlArrowsNudge();
    void deleteAndDuplicateByKey();
    void editsForgetTheFill();
    void wheelAndDragMoveTheCamera();
    void menuAddsACircle();
    void emptySceneTellsWhatToDo();
    void pictureHasTheSizeAskedFor();
    void descriptionTellsPositions();
};

void TestSceneView::paintersLookAlike()
{
    Scene scene;
    scene.simulation.seekNextHit(); // lines, dashes, arrows, discs, labels
    scene.view.select(1);           // and a ring
    scene.view.setRenderer(Renderer::OpenGl);
    if (!glSupport().usable) {
        QCOMPARE(scene.view.activeRenderer(), Renderer::Raster);
        QVERIFY(!scene.view.fallbackReason().isEmpty());
        QVERIFY(showsSomething(scene.view.grab().toImage()));
        return;
    }
    auto *gl = scene.view.findChild<GlCanvas *>();
    QVERIFY(gl);
    const QImage byGl = gl->grabFramebuffer().convertToFormat(QImage::Format_RGB32);
    QCOMPARE(scene.view.activeRenderer(), Renderer::OpenGl);
    scene.view.setRenderer(Renderer::Raster);
    const QImage byRaster = scene.view.grab().toImage().convertToFormat(QImage::Format_RGB32);
    QCOMPARE(byGl.size(), byRaster.size());
    QVERIFY(showsSomething(byGl));
    const double mean = difference(byGl, byRaster);
    QVERIFY2(mean < 0.15, qPrintable(QString::number(mean)));
}

void TestSceneView::shapesLookAlikeToThePixel()
{
    Scene scene;
    scene.simulation.seekNextHit();
    scene.view.select(1);
    ScenePicture picture = scene.view.picture();
    picture.list.labels.clear(); // their glyphs are smoothed in two ways
    picture.focusFrame = false;
    QImage byRaster(700, 700, QImage::Format_RGB32);
    {
        QPainter painter(&byRaster);
        paintShapes(painter, picture.list, picture.camera);
    }
    QVERIFY(showsSomething(byRaster));
    if (!glSupport().usable) {
        QVERIFY(!glSupport().reason.isEmpty());
        return;
    }
    GlCanvas canvas([&]() -> const ScenePicture & { return picture; }, QStringLiteral(":/shaders"));
    canvas.resize(700, 700);
    canvas.show();
    QVERIFY(QTest::qWaitForWindowExposed(&canvas));
    const QImage byGl = canvas.grabFramebuffer().convertToFormat(QImage::Format_RGB32);
    const int different = differentPixels(byGl, byRaster);
    const double mean = difference(byGl, byRaster);
    QVERIFY2(different <= 10, qPrintable(QString::number(different)));
    QVERIFY2(mean < 0.03, qPrintable(QString::number(mean)));
}

void TestSceneView::brokenShadersFallBackToRaster()
{
    Scene scene;
    scene.view.setShaderFolder(QStringLiteral(":/no such folder"));
    scene.view.setRenderer(Renderer::OpenGl);
    QTRY_COMPARE(scene.view.activeRenderer(), Renderer::Raster);
    QVERIFY(!scene.view.fallbackReason().isEmpty());
    QCOMPARE(scene.view.renderer(), Renderer::OpenGl);
    QVERIFY(scene.view.findChild<RasterCanvas *>());
    QVERIFY(showsSomething(scene.view.grab().toImage()));
}

void TestSceneView::rendererCanBeChanged()
{
    Scene scene;
    for (const Renderer renderer : {Renderer::Raster, Renderer::OpenGl, Renderer::Automatic}) {
        scene.view.setRenderer(renderer);
        QTest::qWait(20);
        QVERIFY(scene.view.activeRenderer() != Renderer::Automatic);
        QVERIFY(showsSomething(scene.view.grab().toImage()));
    }
}

void TestSceneView::dragMovesACircleInOneUndoStep()
{
    Scene scene;
    const Preset before = scene.document.preset();
    scene.drag({-2.0, 2.3}, {-1.0, 1.3});
    QCOMPARE(scene.circle(0).position, (Vec2{-1.0, 1.3}));
    QCOMPARE(scene.circle(0).velocity, (Vec2{2.0, 0.0}));
    QCOMPARE(scene.document.undoStack().count(), 1);
    QCOMPARE(scene.document.undoStack().undoText(), QStringLiteral("Move circle 1"));
    scene.drag({-1.0, 1.3}, {0.0, 0.0});
    QCOMPARE(scene.document.undoStack().count(), 2); // the next drag is the next step
    scene.document.undoStack().undo();
    scene.document.undoStack().undo();
    QCOMPARE(scene.document.preset(), before);
}

void TestSceneView::altFreesADragFromTheGrid()
{
    Scene scene;
    scene.press({-2.0, 2.3});
    const QPointF start = scene.pixel({-2.0, 2.3});
    scene.moveTo(start + QPointF(40.0, 0.0), Qt::AltModifier);
    scene.moveTo(start + QPointF(73.0, 0.0), Qt::AltModifier);
    QVERIFY(std::abs(scene.circle(0).position.x - (-2.0 + 73.0 / 70.0)) < 1e-9);
    scene.moveTo(start + QPointF(73.0, 0.0));
    QCOMPARE(scene.circle(0).position, (Vec2{-1.0, 2.3}));
    scene.release({-1.0, 2.3});
}

void TestSceneView::dragOfTheTipChangesTheVelocity()
{
    Scene scene;
    scene.drag({-0.5, 2.3}, {-0.5, 3.05}); // 0.75 m up: 1 m/s
    QCOMPARE(scene.circle(0).velocity, (Vec2{2.0, 1.0}));
    QCOMPARE(scene.circle(0).position, (Vec2{-2.0, 2.3}));
    QCOMPARE(scene.document.undoStack().undoText(), QStringLiteral("Change velocity of circle 1"));
    scene.document.undoStack().undo();
    QCOMPARE(scene.document.preset(), twoCircles());
}

void TestSceneView::circleAtRestHasAGrip()
{
    Scene scene;
    const Vec2 grip = gripPosition(scene.circle(1), 4.0, scene.view.camera().pixelsPerMetre());
    QVERIFY(length(grip - scene.circle(1).position) > 0.2);
    scene.drag(grip, grip + Vec2{-0.75, 0.0});
    QCOMPARE(scene.circle(1).velocity, (Vec2{-1.0, 0.0}));
}

void TestSceneView::refusedPlaceLeavesThePresetAlone()
{
    Scene scene;
    scene.press({-2.0, 2.3});
    scene.moveTo(Vec2{1.9, 1.8}); // over circle 2
    QCOMPARE(scene.document.preset(), twoCircles());
    QVERIFY(scene.chips().join(QLatin1Char(' ')).contains(QStringLiteral("overlap")));
    QVERIFY(scene.chips().contains(QStringLiteral("(1.90, 1.80) m")));
    scene.release({1.9, 1.8});
    QCOMPARE(scene.document.preset(), twoCircles());
    QCOMPARE(scene.document.undoStack().count(), 0);
    QVERIFY(scene.chips().isEmpty());
}

void TestSceneView::laterDragOnlyTellsWhatToDo()
{
    Scene scene;
    for (int i = 0; i < 3; ++i)
        scene.simulation.stepForward();
    const Vec2 at = scene.simulation.recording().circles(3)[0].position;
    scene.drag(at, at + Vec2{0.5, -1.0});
    QCOMPARE(scene.document.preset(), twoCircles());
    QCOMPARE(scene.simulation.current(), qint64{3});
    QCOMPARE(scene.chips(), QStringList{QStringLiteral("Press Restart (R) to change the start")});
    QTRY_VERIFY_WITH_TIMEOUT(scene.chips().isEmpty(), 3000);
}

void TestSceneView::clickSelects()
{
    Scene scene;
    QSignalSpy changed(&scene.view, &SceneView::selectionChanged);
    QTest::mouseClick(&scene.view, Qt::LeftButton, {}, scene.pixel({2.0, 2.0}));
    QCOMPARE(scene.view.selected(), 1);
    QTest::mouseClick(&scene.view, Qt::LeftButton, {}, scene.pixel({0.0, -3.0}));
    QCOMPARE(scene.view.selected(), -1);
    QCOMPARE(changed.count(), 2);
    scene.view.select(17);
    QCOMPARE(scene.view.selected(), -1);
    QCOMPARE(scene.document.undoStack().count(), 0);
}

void TestSceneView::doubleClickActivates()
{
    Scene scene;
    QSignalSpy activated(&scene.view, &SceneView::circleActivated);
    QTest::mouseDClick(&scene.view, Qt::LeftButton, {}, scene.pixel({2.0, 2.0}));
    QCOMPARE(activated.count(), 1);
    QCOMPARE(activated.first().first().toInt(), 1);
    QTest::mouseDClick(&scene.view, Qt::LeftButton, {}, scene.pixel({0.0, 0.0}));
    QCOMPARE(activated.count(), 1);
}

void TestSceneView::tabGoesFromCircleToCircle()
{
    Scene scene;
    QTest::keyClick(&scene.view, Qt::Key_Tab);
    QCOMPARE(scene.view.selected(), 0);
    QTest::keyClick(&scene.view, Qt::Key_Tab);
    QCOMPARE(scene.view.selected(), 1);
    QTest::keyClick(&scene.view, Qt::Key_Backtab, Qt::ShiftModifier);
    QCOMPARE(scene.view.selected(), 0);
    QTest::keyClick(&scene.view, Qt::Key_Escape);
    QCOMPARE(scene.view.selected(), -1);
}

void TestSceneView::controlArrowsNudge()
{
    Scene scene;
    scene.view.select(0);
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(&scene.view, Qt::Key_Right, Qt::ControlModifier);
    QCOMPARE(scene.circle(0).position, (Vec2{-1.7, 2.3}));
    QTest::keyClick(&scene.view, Qt::Key_Down, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(scene.circle(0).position, (Vec2{-1.7, 2.29}));
    QTest::keyClick(&scene.view, Qt::Key_Right); // alone it is the simulation's
    QCOMPARE(scene.circle(0).position, (Vec2{-1.7, 2.29}));
    scene.document.undoStack().undo();
    QCOMPARE(scene.document.preset(), twoCircles());
    // Against the wall the last step is refused and the reason shown.
    for (int i = 0; i < 40; ++i)
        QTest::keyClick(&scene.view, Qt::Key_Up, Qt::ControlModifier);
    QCOMPARE(scene.circle(0).position, (Vec2{-2.0, 3.8}));
    QCOMPARE(scene.chips().size(), 1);
}

void TestSceneView::deleteAndDuplicateByKey()
{
    Scene scene;
    scene.view.select(0);
    QTest::keyClick(&scene.view, Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(scene.document.preset().circles.size(), std::size_t{3});
    QCOMPARE(scene.view.selected(), 2);
    QTest::keyClick(&scene.view, Qt::Key_Delete);
    QCOMPARE(scene.document.preset(), twoCircles());
    QCOMPARE(scene.view.selected(), -1);
    scene.view.select(1);
    scene.view.removeSelected();
    scene.document.undoStack().undo();
    QCOMPARE(scene.document.preset(), twoCircles());
}

void TestSceneView::editsForgetTheFill()
{
    Scene scene;
    Preset filled = twoCircles();
    filled.fill = CircleFill{.count = 2, .radius = 0.2};
    scene.document.open(filled);
    scene.drag({-2.0, 2.3}, {-2.0, 0.0});
    QVERIFY(!scene.document.preset().fill);
    QCOMPARE(scene.document.preset().circles.size(), std::size_t{2});
    scene.document.undoStack().undo();
    QCOMPARE(scene.document.preset(), filled);
}

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

void TestSceneView::menuAddsACircle()
{
    Scene scene;
    const QPoint place = scene.pixel({0.0, -2.0});
    QTimer::singleShot(0, &scene.view, [] {
        auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
        QVERIFY(menu);
        menu->actions().first()->trigger();
        menu->close();
    });
    QContextMenuEvent event(QContextMenuEvent::Mouse, place, scene.view.mapToGlobal(place));
    QCoreApplication::sendEvent(&scene.view, &event);
    QCOMPARE(scene.document.preset().circles.size(), std::size_t{3});
    QVERIFY(length(scene.circle(2).position - Vec2{0.0, -2.0}) < 0.01);
    QCOMPARE(scene.view.selected(), 2);
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

QTEST_MAIN(TestSceneView)
#include "test_scene_view.moc"
