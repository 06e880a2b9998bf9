// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "tests/gui/open_window.h"
#include "tests/patience.h"
#include "views/code/code_editor.h"
#include "views/code/code_pane.h"
#include "views/sound/hit_sounds.h"

#include <QAction>
#include <QApplication>
#include <QMenuBar>
#include <QPlainTextEdit>

using namespace cradle;
using namespace cradle::windows;

namespace {

/// The action of the menus whose text begins with \p text.
QAction *actionOf(const QWidget &parent, const QString &text)
{
    for (auto *menu : parent.findChildren<QMenu *>()) {
        for (QAction *action : menu->actions()) {
            if (action->text().remove(QLatin1Char('&')).startsWith(text))
                return action;
        }
    }
    return nullptr;
}

} // namespace

/// What the menus do with the keyboard where it is, and what they keep.
class TestMainWindowChoices final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void choicesAreKeptBetweenSessions();
    void undoIsOfTheProgramInItsEditor();
    void undoIsOfTheFieldThatIsTypedInto();
    void undoIsOfTheSceneElsewhere();
    void undoInAFieldIsOfTheSceneOnceItIsTaken();

private:
    [[nodiscard]] QAction *action(const char *text)
    {
        return actionOf(m_open->window, QLatin1String(text));
    }
    [[nodiscard]] CodeEditor &editor() { return m_open->window.codePane().editor(); }
    [[nodiscard]] QWidget *editorArea() { return editor().focusProxy(); }
    void moveCircle()
    {
        Preset preset = m_open->preset();
        preset.circles[0].body.position.x += 0.5;
        QVERIFY(m_open->bench.document().edit(QStringLiteral("Move circle 1"), preset));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<OpenWindow> m_open;
};

void TestMainWindowChoices::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_open = std::make_unique<OpenWindow>(*m_folder);
}

void TestMainWindowChoices::cleanup()
{
    m_open.reset();
    m_folder.reset();
}

void TestMainWindowChoices::choicesAreKeptBetweenSessions()
{
    QVERIFY(!m_open->simulation().pausesAtHits());
    QVERIFY(!m_open->window.scene().followsCentreOfMass());
    for (const char *text : {"Pause at hits", "Slow motion", "Sounds of hits", "Follow the centre",
                             "Exact motion", "Trails", "Centre of mass"}) {
        QVERIFY2(action(text), text);
        action(text)->trigger();
    }
    m_open.reset();
    m_open = std::make_unique<OpenWindow>(*m_folder);
    QVERIFY(m_open->simulation().pausesAtHits());
    QVERIFY(m_open->simulation().slowsAtHits());
    QVERIFY(m_open->window.sounds().hits().isOn());
    QVERIFY(m_open->simulation().shadow());
    QVERIFY(m_open->window.scene().followsCentreOfMass());
    SceneOptions options;
    options.trails = false;
    options.centreOfMass = true;
    QCOMPARE(m_open->window.scene().options(), options);
    for (const char *text : {"Pause at hits", "Follow the centre", "Centre of mass"})
        QVERIFY2(action(text)->isChecked(), text);
    QVERIFY(!action("Trails")->isChecked());
}

void TestMainWindowChoices::undoIsOfTheProgramInItsEditor()
{
    m_open->bench.setMode(Mode::Code);
    moveCircle();
    const Preset moved = m_open->preset();
    QCOMPARE(action("Undo")->text(), QStringLiteral("&Undo Move circle 1"));
    editor().setFocus();
    QVERIFY(editor().isAncestorOf(QApplication::focusWidget()));
    QCOMPARE(action("Undo")->text(), QStringLiteral("&Undo"));
    QVERIFY(!action("Undo")->isEnabled()); // the scene's own is not meant
    const QString before = editor().text();
    QTest::keyClicks(editorArea(), QStringLiteral("-- a word"));
    QVERIFY(editor().text() != before);
    QTRY_COMPARE(action("Undo")->text(), QStringLiteral("&Undo typing"));
    action("Undo")->trigger();
    QCOMPARE(editor().text(), before);
    QTRY_COMPARE(action("Redo")->text(), QStringLiteral("&Redo typing"));
    QTest::keyClick(editorArea(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(editor().text() != before);
    QTest::keyClick(editorArea(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(editor().text(), before);
    QCOMPARE(m_open->preset(), moved);
}

void TestMainWindowChoices::undoIsOfTheFieldThatIsTypedInto()
{
    m_open->bench.setMode(Mode::Explore);
    moveCircle();
    const Preset moved = m_open->preset();
    auto *field = m_open->window.inspector().findChild<NumberField *>();
    QVERIFY(field && field->isVisible());
    field->setFocus();
    const QString before = field->text();
    QCOMPARE(action("Undo")->text(), QStringLiteral("&Undo Move circle 1")); // nothing is typed
    QTest::keyClicks(field, QStringLiteral("1"));
    QCOMPARE(action("Undo")->text(), QStringLiteral("&Undo typing"));
    action("Undo")->trigger();
    QCOMPARE(field->text(), before);
    QCOMPARE(m_open->preset(), moved);
    QCOMPARE(action("Undo")->text(), QStringLiteral("&Undo Move circle 1"));

    auto *notes = m_open->window.findChild<QDockWidget *>(QStringLiteral("notes"));
    notes->show();
    notes->raise();
    auto *text = notes->findChild<QPlainTextEdit *>();
    text->setFocus();
    QVERIFY(text->hasFocus());
    QCOMPARE(action("Undo")->text(), QStringLiteral("&Undo"));
    QVERIFY(!action("Undo")->isEnabled());
    QTest::keyClicks(text, QStringLiteral("noted"));
    QCOMPARE(action("Undo")->text(), QStringLiteral("&Undo typing"));
    action("Undo")->trigger();
    QCOMPARE(text->toPlainText(), QString());
    QCOMPARE(action("Redo")->text(), QStringLiteral("&Redo typing"));
    action("Redo")->trigger();
    QCOMPARE(text->toPlainText(), QStringLiteral("noted"));
    QCOMPARE(m_open->preset(), moved);
}

void TestMainWindowChoices::undoIsOfTheSceneElsewhere()
{
    m_open->bench.setMode(Mode::Code);
    const Preset before = m_open->preset();
    editor().setFocus();
    QTest::keyClicks(editorArea(), QStringLiteral("-- a word"));
    const QString typed = editor().text();
    moveCircle();
    m_open->window.scene().setFocus();
    QCOMPARE(action("Undo")->text(), QStringLiteral("&Undo Move circle 1"));
    // The menu bar has the keyboard while a menu is chosen by keys: that is no work.
    m_open->window.menuBar()->setFocus(Qt::MenuBarFocusReason);
    QCOMPARE(action("Undo")->text(), QStringLiteral("&Undo Move circle 1"));
    m_open->window.scene().setFocus();
    m_open->press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(m_open->preset(), before);
    QCOMPARE(editor().text(), typed);
}

void TestMainWindowChoices::undoInAFieldIsOfTheSceneOnceItIsTaken()
{
    m_open->bench.setMode(Mode::Explore);
    const Preset before = m_open->preset();
    auto *field = m_open->window.inspector().findChild<NumberField *>();
    QVERIFY(field);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("1.25"));
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(m_open->preset().gravity.x, 1.25);
    field->end(false);
    QTest::keyClicks(field, QStringLiteral("7"));
    QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier); // what is typed comes first
    QCOMPARE(field->text(), QStringLiteral("1.25"));
    QCOMPARE(m_open->preset().gravity.x, 1.25);
    QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(m_open->preset(), before);
}

QTEST_MAIN(TestMainWindowChoices)

#include "test_main_window_choices.moc"
