// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/scene_fixture.h"
#include "views/scene/scene_view.h"

#include <QAction>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>

using namespace cradle::scenes;
using namespace cradle;

namespace {

/// The two circles, and a third at the left.
Preset threeCircles()
{
    Preset preset = twoCircles();
    PresetCircle third = preset.circles[1];
    third.name = QStringLiteral("circle 3");
    third.colour = QStringLiteral("#e69f00");
    third.body.position = {-3.0, -1.0};
    preset.circles.push_back(third);
    return preset;
}

struct ThreeCircles : Scene {
    ThreeCircles() { document.open(threeCircles()); }

    void click(Vec2 place, Qt::KeyboardModifiers keys = {})
    {
        QTest::mouseClick(&view, Qt::LeftButton, keys, pixel(place));
    }
    void band(Vec2 from, Vec2 to, Qt::KeyboardModifiers keys = Qt::ShiftModifier)
    {
        QTest::mousePress(&view, Qt::LeftButton, keys, pixel(from));
        moveTo(from + 0.5 * (to - from), keys);
        moveTo(to, keys);
    }
    /// How many circles have the ring of the selected.
    [[nodiscard]] std::ptrdiff_t rings()
    {
        const auto &discs = view.picture().list.discs;
        return std::count_if(discs.begin(), discs.end(),
                             [](const DrawList::Disc &disc) { return !disc.fill.isValid(); });
    }
};

using Indices = std::vector<int>;

} // namespace

class TestSceneSelection : public QObject
{
    Q_OBJECT
private slots:
    void controlClickAddsAndTakesAway();
    void shiftDragSelectsWithinABand();
    void escapeTakesTheBandAway();
    void plainDragStillPans();
    void keysSelectAllAndTheNext();
    void allSelectedMoveTogether();
    void velocitiesOfAllChangeTogether();
    void theFirstAtAWallStopsAll();
    void aClickSinglesOut();
    void escapeUndoesTheDrag();
    void refusedPlacesOfAllAreShown();
    void nudgesMoveAll();
    void allAreDuplicatedStoppedAndRemoved();
};

void TestSceneSelection::controlClickAddsAndTakesAway()
{
    ThreeCircles scene;
    QSignalSpy changed(&scene.view, &SceneView::selectionChanged);
    scene.click({-2.0, 2.3});
    scene.click({2.0, 2.0}, Qt::ControlModifier);
    QCOMPARE(scene.view.selection(), (Indices{0, 1}));
    QCOMPARE(scene.view.selected(), 1); // the last one, for the inspector
    QCOMPARE(scene.rings(), 2);
    scene.click({-3.0, -1.0}, Qt::ShiftModifier);
    QCOMPARE(scene.view.selection(), (Indices{0, 1, 2}));
    scene.click({-3.0, -1.0}, Qt::ControlModifier);
    QCOMPARE(scene.view.selection(), (Indices{0, 1}));
    QCOMPARE(scene.view.selected(), 1);
    scene.click({0.0, -3.0}, Qt::ControlModifier); // a near miss costs nothing
    QCOMPARE(scene.view.selection(), (Indices{0, 1}));
    scene.click({0.0, -3.0});
    QVERIFY(scene.view.selection().empty());
    QCOMPARE(changed.count(), 5);
    QCOMPARE(scene.document.undoStack().count(), 0);
}

void TestSceneSelection::shiftDragSelectsWithinABand()
{
    ThreeCircles scene;
    const Camera camera = scene.view.camera();
    scene.band({-3.5, -1.5}, {-1.0, 3.0});
    QCOMPARE(scene.view.picture().band.toAlignedRect().topLeft(),
             QRectF(scene.pixel({-3.5, 3.0}), QSizeF(1, 1)).toAlignedRect().topLeft());
    QVERIFY(scene.view.selection().empty());
    scene.release({-1.0, 3.0});
    QCOMPARE(scene.view.selection(), (Indices{0, 2}));
    QVERIFY(scene.view.picture().band.isNull());
    scene.band({3.0, 3.0}, {1.0, 1.0}, Qt::ControlModifier); // backwards, as well as the others
    scene.release({1.0, 1.0});
    QCOMPARE(scene.view.selection(), (Indices{0, 1, 2}));
    QCOMPARE(scene.view.camera(), camera);
}

void TestSceneSelection::escapeTakesTheBandAway()
{
    ThreeCircles scene;
    scene.band({-3.5, -1.5}, {-1.0, 3.0});
    QTest::keyClick(&scene.view, Qt::Key_Escape);
    QVERIFY(scene.view.picture().band.isNull());
    scene.release({-1.0, 3.0});
    QVERIFY(scene.view.selection().empty());
}

void TestSceneSelection::plainDragStillPans()
{
    ThreeCircles scene;
    scene.view.select(1);
    const Vec2 before = scene.view.camera().centre();
    scene.drag({0.0, 0.0}, {1.0, 0.0});
    QVERIFY(scene.view.camera().centre().x < before.x - 0.5);
    QCOMPARE(scene.view.selection(), (Indices{1}));
}

void TestSceneSelection::keysSelectAllAndTheNext()
{
    ThreeCircles scene;
    QTest::keyClick(&scene.view, Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(scene.view.selection(), (Indices{0, 1, 2}));
    QVERIFY(scene.view.accessibleDescription().contains(QStringLiteral("3 selected")));
    QTest::keyClick(&scene.view, Qt::Key_Escape);
    QVERIFY(scene.view.selection().empty());
    QTest::keyClick(&scene.view, Qt::Key_Tab);
    QTest::keyClick(&scene.view, Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(scene.view.selection(), (Indices{0, 1}));
    QTest::keyClick(&scene.view, Qt::Key_Tab);
    QCOMPARE(scene.view.selection(), (Indices{2}));
    QVERIFY(scene.simulation.atStart());
}

void TestSceneSelection::allSelectedMoveTogether()
{
    ThreeCircles scene;
    scene.click({-2.0, 2.3});
    scene.click({-3.0, -1.0}, Qt::ControlModifier);
    scene.press({-2.0, 2.3}); // the one that is held leads
    scene.moveTo(Vec2{-1.6, 1.8});
    scene.moveTo(Vec2{-1.0, 1.3});
    QCOMPARE(scene.chips(), QStringList{QStringLiteral("moved by (1.00, −1.00) m")});
    scene.release({-1.0, 1.3});
    QCOMPARE(scene.circle(0).position, (Vec2{-1.0, 1.3}));
    QCOMPARE(scene.circle(2).position, (Vec2{-2.0, -2.0}));
    QCOMPARE(scene.circle(1).position, (Vec2{2.0, 2.0}));
    QCOMPARE(scene.view.selection(), (Indices{0, 2}));
    QCOMPARE(scene.view.selected(), 0);
    QCOMPARE(scene.document.undoStack().count(), 1);
    QCOMPARE(scene.document.undoStack().undoText(), QStringLiteral("Move 2 circles"));
    scene.document.undoStack().undo();
    QCOMPARE(scene.document.preset(), threeCircles());
}

void TestSceneSelection::velocitiesOfAllChangeTogether()
{
    ThreeCircles scene;
    scene.click({-2.0, 2.3});
    scene.click({2.0, 2.0}, Qt::ControlModifier);
    const Vec2 before = scene.circle(1).velocity;
    const double scale = arrowScale(scene.document.preset());
    const Vec2 tip = scene.circle(0).position + scale * scene.circle(0).velocity;
    scene.press(tip);
    scene.moveTo(tip + scale * Vec2{0.5, 1.0});
    QVERIFY2(scene.chips().contains(QStringLiteral("changed by (0.50, 1.00) m/s")),
             qPrintable(scene.chips().join(u'|')));
    scene.release(tip + scale * Vec2{0.5, 1.0});
    QCOMPARE(scene.circle(0).velocity, (Vec2{2.5, 1.0}));
    QCOMPARE(scene.circle(1).velocity, before + (Vec2{0.5, 1.0}));
    QCOMPARE(scene.document.undoStack().undoText(),
             QStringLiteral("Change velocities of 2 circles"));
    scene.document.undoStack().undo();
    QCOMPARE(scene.document.preset(), threeCircles());
}

void TestSceneSelection::theFirstAtAWallStopsAll()
{
    ThreeCircles scene;
    scene.click({-2.0, 2.3});
    scene.click({-3.0, -1.0}, Qt::ControlModifier);
    scene.drag({-2.0, 2.3}, {-4.5, 2.3}); // circle 3 has 0.8 m left
    QCOMPARE(scene.circle(2).position, (Vec2{-3.8, -1.0}));
    QCOMPARE(scene.circle(0).position, (Vec2{-2.8, 2.3}));
}

void TestSceneSelection::aClickSinglesOut()
{
    ThreeCircles scene;
    QTest::keyClick(&scene.view, Qt::Key_A, Qt::ControlModifier);
    scene.click({2.0, 2.0});
    QCOMPARE(scene.view.selection(), (Indices{1}));
    QCOMPARE(scene.document.undoStack().count(), 0);
}

void TestSceneSelection::escapeUndoesTheDrag()
{
    ThreeCircles scene;
    scene.press({-2.0, 2.3});
    scene.moveTo(Vec2{-1.6, 1.8});
    scene.moveTo(Vec2{-1.0, 1.3});
    QCOMPARE(scene.circle(0).position, (Vec2{-1.0, 1.3}));
    QTest::keyClick(&scene.view, Qt::Key_Escape);
    QCOMPARE(scene.document.preset(), threeCircles());
    scene.moveTo(Vec2{0.0, 0.0});
    scene.release({0.0, 0.0});
    QCOMPARE(scene.document.preset(), threeCircles());
    QCOMPARE(scene.view.selection(), (Indices{0}));
}

void TestSceneSelection::refusedPlacesOfAllAreShown()
{
    ThreeCircles scene;
    scene.click({-2.0, 2.3});
    scene.click({-3.0, -1.0}, Qt::ControlModifier);
    const std::size_t discs = scene.view.picture().list.discs.size();
    scene.press({-2.0, 2.3});
    scene.moveTo(Vec2{0.0, 2.3});
    scene.moveTo(Vec2{1.9, 2.0}); // over circle 2
    QCOMPARE(scene.circle(0).position, (Vec2{0.0, 2.3}));
    QCOMPARE(scene.view.picture().list.discs.size(), discs + 2);
    const Chip chip = scene.view.picture().chips.back();
    QVERIFY(chip.warning && chip.place == Chip::Place::Pointer);
    QVERIFY(chip.detail.contains(QStringLiteral("overlap"))); // beside the pointer
    scene.release({1.9, 2.0});
    QVERIFY(scene.chips().isEmpty());
}

void TestSceneSelection::nudgesMoveAll()
{
    ThreeCircles scene;
    QTest::keyClick(&scene.view, Qt::Key_A, Qt::ControlModifier);
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(&scene.view, Qt::Key_Down, Qt::ControlModifier);
    QCOMPARE(scene.circle(0).position, (Vec2{-2.0, 2.0}));
    QCOMPARE(scene.circle(1).position, (Vec2{2.0, 1.7}));
    QCOMPARE(scene.circle(2).position, (Vec2{-3.0, -1.3}));
    QCOMPARE(scene.document.undoStack().count(), 1);
    for (int i = 0; i < 40; ++i)
        QTest::keyClick(&scene.view, Qt::Key_Left, Qt::ControlModifier);
    QCOMPARE(scene.circle(2).position, (Vec2{-3.8, -1.3}));
    QCOMPARE(scene.circle(1).position, (Vec2{1.2, 1.7}));
}

void TestSceneSelection::allAreDuplicatedStoppedAndRemoved()
{
    ThreeCircles scene;
    scene.click({-2.0, 2.3});
    scene.click({2.0, 2.0}, Qt::ControlModifier);
    QTest::keyClick(&scene.view, Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(scene.view.selection(), (Indices{3, 4}));
    // The copies lie to each other as the originals do.
    const Vec2 apart = scene.circle(4).position - scene.circle(3).position;
    QVERIFY(length(apart - Vec2{4.0, -0.3}) < 1e-5);
    QCOMPARE(scene.document.undoStack().undoText(), QStringLiteral("Duplicate 2 circles"));
    QCOMPARE(scene.circle(3).velocity, (Vec2{2.0, 0.0}));
    const QList<QAction *> &actions = scene.view.circleActions();
    const auto stop = std::find_if(actions.begin(), actions.end(), [](const QAction *action) {
        return action->text().contains(QStringLiteral("zero"));
    });
    QVERIFY(stop != actions.end());
    (*stop)->trigger();
    QCOMPARE(scene.circle(3).velocity, Vec2{});
    QTest::keyClick(&scene.view, Qt::Key_Delete);
    QCOMPARE(scene.document.preset(), threeCircles());
    QVERIFY(scene.view.selection().empty());
    QVERIFY(!(*stop)->isEnabled());
}

QTEST_MAIN(TestSceneSelection)
#include "test_scene_selection.moc"
