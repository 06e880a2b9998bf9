// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "model/files/preset_json.h"
#include "tests/gui/open_window.h"
#include "tests/gui/scene_fixture.h"
#include "views/code/code_editor.h"
#include "views/code/code_pane.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <QMenuBar>
#include <QTest>

using namespace cradle::scenes;
using namespace cradle::windows;
using namespace cradle;

namespace {

QString clipboard()
{
    return QApplication::clipboard()->text();
}

void press(Scene &scene, Qt::Key key)
{
    QTest::keyClick(&scene.view, key, Qt::ControlModifier);
}

} // namespace

class TestSceneClipboard : public QObject
{
    Q_OBJECT
private slots:
    void init() { QApplication::clipboard()->clear(); }
    void copiesAreAPresetFile();
    void pastesBesideTheOriginal();
    void pastesIntoAnotherWindow();
    void cutCanBeUndoneAndPastedBack();
    void pastedCirclesKeepTheirArrangement();
    void refusesOtherTextWithAReason_data();
    void refusesOtherTextWithAReason();
    void refusesWhatDoesNotFit();
    void contextMenuHasItAll();
    void keysStayWithThePaneThatHasTheFocus();
};

void TestSceneClipboard::copiesAreAPresetFile()
{
    Scene scene;
    press(scene, Qt::Key_C); // nothing is selected
    QCOMPARE(clipboard(), QString());
    scene.view.select(1);
    press(scene, Qt::Key_C);
    const Result<Preset> read = parsePreset(clipboard().toUtf8());
    QVERIFY(read);
    QCOMPARE(read->circles.size(), std::size_t{1});
    QCOMPARE(read->circles.front(), twoCircles().circles[1]);
    QCOMPARE(scene.document.preset(), twoCircles());
}

void TestSceneClipboard::pastesBesideTheOriginal()
{
    Scene scene;
    scene.view.select(0);
    press(scene, Qt::Key_C);
    press(scene, Qt::Key_V);
    press(scene, Qt::Key_V);
    const Preset &preset = scene.document.preset();
    QCOMPARE(preset.circles.size(), std::size_t{4});
    QVERIFY(!findFault(preset));
    QCOMPARE(scene.view.selected(), 3);
    for (const std::size_t copy : {std::size_t{2}, std::size_t{3}}) {
        const Circle &body = preset.circles[copy].body;
        QCOMPARE(body.velocity, (Vec2{2.0, 0.0}));
        QVERIFY(length(body.position - Vec2{-2.0, 2.3}) < 1.0);
    }
    QCOMPARE(preset.circles[2].name, QStringLiteral("circle 3"));
    QVERIFY(preset.circles[2].colour != preset.circles[0].colour);
    QCOMPARE(scene.document.undoStack().undoText(), QStringLiteral("Paste a circle"));
    scene.document.undoStack().undo();
    scene.document.undoStack().undo();
    QCOMPARE(scene.document.preset(), twoCircles());
}

void TestSceneClipboard::pastesIntoAnotherWindow()
{
    Scene from;
    press(from, Qt::Key_A);
    press(from, Qt::Key_C);
    Scene to;
    Preset empty = twoCircles();
    empty.circles.clear();
    to.document.open(empty);
    press(to, Qt::Key_V);
    QCOMPARE(to.document.preset().circles, twoCircles().circles); // names, colours and places
    QCOMPARE(to.view.selection(), (std::vector<int>{0, 1}));
    QCOMPARE(to.document.undoStack().undoText(), QStringLiteral("Paste 2 circles"));
}

void TestSceneClipboard::cutCanBeUndoneAndPastedBack()
{
    Scene scene;
    scene.view.select(0);
    press(scene, Qt::Key_X);
    QCOMPARE(scene.document.preset().circles.size(), std::size_t{1});
    press(scene, Qt::Key_V);
    QCOMPARE(scene.document.preset().circles.back(), twoCircles().circles[0]);
    scene.document.undoStack().undo();
    scene.document.undoStack().undo();
    QCOMPARE(scene.document.preset(), twoCircles());
}

void TestSceneClipboard::pastedCirclesKeepTheirArrangement()
{
    Scene scene;
    press(scene, Qt::Key_A);
    press(scene, Qt::Key_C);
    press(scene, Qt::Key_V);
    QCOMPARE(scene.document.preset().circles.size(), std::size_t{4});
    QVERIFY(!findFault(scene.document.preset()));
    const Vec2 first = scene.circle(2).position - scene.circle(0).position;
    const Vec2 second = scene.circle(3).position - scene.circle(1).position;
    QVERIFY(length(first) > 0.3 && length(first - second) < 1e-5);
}

void TestSceneClipboard::refusesOtherTextWithAReason_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("reason");
    QTest::newRow("nothing") << QString() << QStringLiteral("empty");
    QTest::newRow("prose") << QStringLiteral("Hello") << QStringLiteral("holds no circles");
    QTest::newRow("other JSON") << QStringLiteral("{\"a\": 1}")
                                << QStringLiteral("holds no circles");
    QTest::newRow("broken preset")
        << QString::fromUtf8(writePreset(twoCircles())).replace(QLatin1String("7.8"), QString())
        << QStringLiteral("holds no circles");
    QTest::newRow("negative radius")
        << QString::fromUtf8(writePreset(twoCircles()))
               .replace(QLatin1String("\"radius\": 0.2"), QLatin1String("\"radius\": -1"))
        << QStringLiteral("radius");
    Preset empty = twoCircles();
    empty.circles.clear();
    QTest::newRow("no circles") << QString::fromUtf8(writePreset(empty))
                                << QStringLiteral("has no circles");
}

void TestSceneClipboard::refusesOtherTextWithAReason()
{
    QFETCH(QString, text);
    QFETCH(QString, reason);
    Scene scene;
    QApplication::clipboard()->setText(text);
    press(scene, Qt::Key_V);
    QCOMPARE(scene.document.preset(), twoCircles());
    QCOMPARE(scene.document.undoStack().count(), 0);
    QCOMPARE(scene.chips().size(), 1);
    QVERIFY2(scene.chips().first().contains(reason), qPrintable(scene.chips().first()));
}

void TestSceneClipboard::refusesWhatDoesNotFit()
{
    Scene scene;
    Preset tight = twoCircles();
    tight.circles.pop_back();
    tight.circles[0].body = {.radius = 3.9};
    scene.document.open(tight);
    scene.view.select(0);
    press(scene, Qt::Key_C);
    press(scene, Qt::Key_V);
    QCOMPARE(scene.document.preset(), tight);
    QVERIFY(scene.chips().join(QLatin1Char(' ')).contains(QStringLiteral("overlap")));
}

void TestSceneClipboard::contextMenuHasItAll()
{
    Scene scene;
    const QPoint place = scene.pixel({2.0, 2.0});
    QStringList entries;
    QTimer::singleShot(0, &scene.view, [&entries] {
        auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
        QVERIFY(menu);
        for (const QAction *action : menu->actions()) {
            if (action->isEnabled())
                entries << action->text().remove(QLatin1Char('&'));
        }
        menu->close();
    });
    QContextMenuEvent event(QContextMenuEvent::Mouse, place, scene.view.mapToGlobal(place));
    QCoreApplication::sendEvent(&scene.view, &event);
    QCOMPARE(scene.view.selected(), 1);
    for (const char *entry : {"Cut circles", "Copy circles", "Paste circles", "Duplicate circles",
                              "Remove circles", "Select all circles", "Fit view"})
        QVERIFY2(entries.contains(QLatin1String(entry)), entry);
}

void TestSceneClipboard::keysStayWithThePaneThatHasTheFocus()
{
    const QTemporaryDir folder;
    OpenWindow open(folder);
    open.bench.setMode(Mode::Code);
    CodeEditor &editor = open.window.codePane().editor();
    open.window.scene().setFocus();
    open.window.scene().select(0);
    open.press(Qt::Key_C, Qt::ControlModifier);
    QVERIFY(parsePreset(clipboard().toUtf8()));
    // In the editor the same keys are about text.
    editor.setFocus();
    editor.selectAll();
    QWidget *area = QApplication::focusWidget();
    QVERIFY(area && editor.isAncestorOf(area));
    QTest::keyClick(area, Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(clipboard(), editor.text());
    const std::size_t circles = open.preset().circles.size();
    QTest::keyClick(area, Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(open.preset().circles.size(), circles);
    // The menu says what the keys are, and follows the focus.
    open.window.scene().setFocus();
    QApplication::clipboard()->setText(QString::fromUtf8(writePreset(twoCircles())));
    const QList<QAction *> edit = open.window.menuBar()->actions().at(1)->menu()->actions();
    const auto paste = std::find_if(edit.begin(), edit.end(), [](const QAction *action) {
        const QString key = QKeySequence(QKeySequence::Paste).toString(QKeySequence::NativeText);
        return action->text() == QStringLiteral("&Paste circles\t") + key;
    });
    QVERIFY(paste != edit.end());
    (*paste)->trigger();
    QCOMPARE(open.preset().circles.size(), circles + 2);
    // The inspector shows one of them, and leaves the others selected.
    QCOMPARE(open.window.scene().selection().size(), std::size_t{2});
    QCOMPARE(open.window.inspector().selected(), open.window.scene().selected());
}

QTEST_MAIN(TestSceneClipboard)
#include "test_scene_clipboard.moc"
