// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/scene_fixture.h"
#include "tests/patience.h"
#include "views/scene/handles.h"

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>

#include <cmath>

using namespace cradle::scenes;
using namespace cradle;

class TestSceneEditing : public QObject
{
    Q_OBJECT
private slots:
    void dragMovesACircleInOneUndoStep();
    void altFreesADragFromTheGrid();
    void dragOfTheTipChangesTheVelocity();
    void circleAtRestHasAGrip();
    void refusedPlaceLeavesThePresetAlone();
    void wallsStopADrag();
    void laterDragOnlyTellsWhatToDo();
    void clickSelects();
    void tabGoesFromCircleToCircle();
    void controlArrowsNudge();
    void deleteAndDuplicateByKey();
    void editsForgetTheFill();
    void menuAddsACircle();
};

void TestSceneEditing::dragMovesACircleInOneUndoStep()
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

void TestSceneEditing::altFreesADragFromTheGrid()
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

void TestSceneEditing::dragOfTheTipChangesTheVelocity()
{
    Scene scene;
    scene.drag({-0.5, 2.3}, {-0.5, 3.05}); // 0.75 m up: 1 m/s
    QCOMPARE(scene.circle(0).velocity, (Vec2{2.0, 1.0}));
    QCOMPARE(scene.circle(0).position, (Vec2{-2.0, 2.3}));
    QCOMPARE(scene.document.undoStack().undoText(), QStringLiteral("Change velocity of circle 1"));
    scene.document.undoStack().undo();
    QCOMPARE(scene.document.preset(), twoCircles());
}

void TestSceneEditing::circleAtRestHasAGrip()
{
    Scene scene;
    const Vec2 grip = gripPosition(scene.circle(1), scene.document.preset(),
                                   scene.view.camera().pixelsPerMetre());
    QVERIFY(length(grip - scene.circle(1).position) > 0.2);
    scene.drag(grip, grip + Vec2{-0.75, 0.0});
    QCOMPARE(scene.circle(1).velocity, (Vec2{-1.0, 0.0}));
}

void TestSceneEditing::refusedPlaceLeavesThePresetAlone()
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

void TestSceneEditing::wallsStopADrag()
{
    Scene scene;
    Preset odd = twoCircles();
    odd.circles[0].body.radius = 0.252; // no multiple of the grid that drags snap to
    scene.document.open(odd);
    scene.press({-2.0, 2.3});
    scene.moveTo(Vec2{-3.0, 2.3});
    scene.moveTo(Vec2{-4.6, 1.0});
    QCOMPARE(scene.circle(0).position, (Vec2{-3.748, 1.0}));
    QCOMPARE(scene.chips().size(), 1); // only its place
    scene.moveTo(Vec2{-4.9, 4.9});
    scene.release({-4.9, 4.9});
    QCOMPARE(scene.circle(0).position, (Vec2{-3.748, 3.748}));
    Preset open = twoCircles();
    open.laws.walls = WallLaw::None;
    scene.document.open(open);
    scene.drag({-2.0, 2.3}, {-4.5, 2.3});
    QCOMPARE(scene.circle(0).position, (Vec2{-4.5, 2.3}));
}

void TestSceneEditing::laterDragOnlyTellsWhatToDo()
{
    Scene scene;
    for (int i = 0; i < 3; ++i)
        scene.simulation.stepForward();
    const Vec2 at = scene.simulation.recording().circles(3)[0].position;
    scene.drag(at, at + Vec2{0.5, -1.0});
    QCOMPARE(scene.document.preset(), twoCircles());
    QCOMPARE(scene.simulation.current(), qint64{3});
    QCOMPARE(scene.chips(),
             QStringList{QStringLiteral("Press Restart (R) to change the start, or "
                                        "start a new run from here (Ctrl+Shift+R)")});
    QTRY_VERIFY(scene.chips().isEmpty());
}

void TestSceneEditing::clickSelects()
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

void TestSceneEditing::tabGoesFromCircleToCircle()
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

void TestSceneEditing::controlArrowsNudge()
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
    // The wall stops it, which needs no words.
    for (int i = 0; i < 40; ++i)
        QTest::keyClick(&scene.view, Qt::Key_Up, Qt::ControlModifier);
    QCOMPARE(scene.circle(0).position, (Vec2{-2.0, 3.8}));
    QVERIFY(scene.chips().isEmpty());
}

void TestSceneEditing::deleteAndDuplicateByKey()
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
    QTest::keyClick(&scene.view, Qt::Key_Backspace, Qt::ControlModifier);
    QCOMPARE(scene.document.preset().circles.size(), std::size_t{1});
    scene.document.undoStack().undo();
    QCOMPARE(scene.document.preset(), twoCircles());
}

void TestSceneEditing::editsForgetTheFill()
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

void TestSceneEditing::menuAddsACircle()
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

QTEST_MAIN(TestSceneEditing)
#include "test_scene_editing.moc"
