// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include "tests/gui/window_test.h"
#include "tests/patience.h"

#include <QAction>
#include <QApplication>
#include <QMenuBar>

using namespace cradle;
using namespace cradle::windows;

/// The window itself: keys, languages, colours, panes.
class TestMainWindow final : public WindowTest
{
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void keysDriveTheSimulation();
    void keyGoesToTheNextHit();
    void typingInAFieldIsNoShortcut();
    void editsAreUndoneAndRedoneByKeys();
    void languageIsSwitchedWhileItRuns();
    void languageSwitchKeepsTheVisit();
    void coloursAreSwitched();
    void panesAreUnlockedAndLocked();
    void layoutIsKept();
    void layoutIsReset();
    void everyShortcutIsUsedOnce();
};

void TestMainWindow::initTestCase()
{
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    applyTheme(ThemeChoice::Light);
}

void TestMainWindow::init()
{
    setLanguage(QStringLiteral("en"));
    takeNewFolder();
}

void TestMainWindow::cleanup()
{
    m_open.reset();
    applyTheme(ThemeChoice::Light);
}

void TestMainWindow::keysDriveTheSimulation()
{
    Simulation &simulation = m_open->simulation();
    m_open->press(Qt::Key_Right);
    m_open->press(Qt::Key_Right);
    QCOMPARE(simulation.current(), qint64{2});
    m_open->press(Qt::Key_Left);
    QCOMPARE(simulation.current(), qint64{1});
    m_open->press(Qt::Key_Space);
    QVERIFY(simulation.isRunning());
    QTRY_VERIFY(simulation.current() > 3);
    m_open->press(Qt::Key_Space);
    QVERIFY(!simulation.isRunning());
    m_open->press(Qt::Key_R);
    QVERIFY(simulation.atStart());
}

void TestMainWindow::keyGoesToTheNextHit()
{
    QVERIFY(m_open->bench.openTask(QStringLiteral("L42T11")));
    m_open->press(Qt::Key_N);
    // The circles of the start meet head-on: 3.6 m at 2 m/s are 1.8 s, 108 steps.
    QVERIFY(std::abs(m_open->simulation().time() - 1.8) < 0.04);
    QCOMPARE(m_open->simulation().recording().hits().size(), std::size_t{1});
}

void TestMainWindow::typingInAFieldIsNoShortcut()
{
    m_open->press(Qt::Key_Right);
    auto *field = m_open->window.inspector().findChild<NumberField *>();
    field->setFocus();
    for (const Qt::Key key : {Qt::Key_Left, Qt::Key_N, Qt::Key_Space, Qt::Key_R})
        QTest::keyClick(field, key);
    QCOMPARE(m_open->simulation().current(), qint64{1});
    QVERIFY(!m_open->simulation().isRunning());
    QTest::keyClick(field, Qt::Key_Escape);
}

void TestMainWindow::editsAreUndoneAndRedoneByKeys()
{
    const Preset before = m_open->preset();
    m_open->typeCell(0, CircleTableModel::VelocityX, QStringLiteral("2"));
    m_open->typeCell(0, CircleTableModel::Y, QStringLiteral("1.5"));
    const Preset after = m_open->preset();
    QCOMPARE(after.circles[0].body.velocity.x, 2.0);
    m_open->press(Qt::Key_Z, Qt::ControlModifier);
    m_open->press(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(m_open->preset() == before);
    QTest::keySequence(&m_open->window.scene(), QKeySequence(QKeySequence::Redo));
    QTest::keySequence(&m_open->window.scene(), QKeySequence(QKeySequence::Redo));
    QVERIFY(m_open->preset() == after);
}

void TestMainWindow::languageIsSwitchedWhileItRuns()
{
    const auto shown = [this] {
        return QStringList{pane("task")->windowTitle(),
                           pane("values")->windowTitle(),
                           m_open->window.menuBar()->actions().constFirst()->text(),
                           m_open->window.menuBar()->actions().at(1)->text(),
                           m_open->window.transportBar().checkAction()->text(),
                           m_open->steps()->item(0)->text()};
    };
    m_open->press(Qt::Key_Right);
    const QStringList english = shown();
    m_open->window.choices().chooseLanguage(QStringLiteral("de"));
    QTRY_COMPARE(shown()[4], QStringLiteral("Prüfen"));
    const QStringList german = shown();
    // "Lab" is the same word in both.
    for (const int i : {0, 1, 3, 4, 5})
        QVERIFY2(german[i] != english[i], qPrintable(german[i]));
    QCOMPARE(german[5], QStringLiteral("1 · In Bewegung setzen"));
    QCOMPARE(m_open->settings.value(QStringLiteral("language")).toString(), QStringLiteral("de"));
    QCOMPARE(m_open->simulation().current(), qint64{1});
    m_open->window.choices().chooseLanguage(QStringLiteral("en"));
    QTRY_COMPARE(shown(), english);
}

void TestMainWindow::languageSwitchKeepsTheVisit()
{
    Preset other = m_open->preset();
    other.gravity = {0.0, -1.0};
    m_open->bench.document().visit(other);
    QVERIFY(m_open->button(QStringLiteral("Back to my scene")));
    m_open->window.choices().chooseLanguage(QStringLiteral("de"));
    QVERIFY(m_open->bench.document().isVisiting());
    QVERIFY2(m_open->window.notice().isVisible(), "no way back is shown");
    QTRY_VERIFY(!m_open->says(QStringLiteral("This is a scene of the check")));
}

void TestMainWindow::coloursAreSwitched()
{
    m_open->window.choices().chooseTheme(ThemeChoice::Dark);
    QVERIFY(theme().dark);
    QCOMPARE(m_open->window.palette().color(QPalette::Window), Theme::darkTheme().window);
    const QImage dark = m_open->window.grab().toImage();
    m_open->window.choices().chooseTheme(ThemeChoice::Light);
    QVERIFY(!theme().dark && m_open->window.grab().toImage() != dark);
    QCOMPARE(m_open->settings.value(QStringLiteral("theme")).toInt(),
             static_cast<int>(ThemeChoice::Light));
}

void TestMainWindow::panesAreUnlockedAndLocked()
{
    // A bar of no height hides the style's; without it the pane can be moved.
    QVERIFY(pane("task")->titleBarWidget());
    for (const bool unlocked : {true, false}) {
        m_open->window.room().unlockPanes(unlocked);
        for (const QDockWidget *dock : m_open->window.panes().docks)
            QCOMPARE(dock->titleBarWidget() == nullptr, unlocked);
    }
}

void TestMainWindow::layoutIsKept()
{
    pane("energy")->hide();
    m_open->window.addDockWidget(Qt::RightDockWidgetArea, pane("task"));
    reopen();
    QVERIFY(pane("energy")->isHidden());
    QVERIFY(!pane("values")->isHidden());
    QCOMPARE(m_open->window.dockWidgetArea(pane("task")), Qt::RightDockWidgetArea);
}

void TestMainWindow::layoutIsReset()
{
    m_open->window.room().unlockPanes(true);
    pane("energy")->hide();
    pane("values")->setFloating(true);
    m_open->window.addDockWidget(Qt::RightDockWidgetArea, pane("task"));
    m_open->window.room().resetLayout();
    QVERIFY(pane("energy")->isVisible() && !pane("values")->isFloating());
    QCOMPARE(m_open->window.dockWidgetArea(pane("task")), Qt::LeftDockWidgetArea);
    QCOMPARE(m_open->window.dockWidgetArea(pane("inspector")), Qt::RightDockWidgetArea);
}

/// Two actions with one key would make Qt do neither.
void TestMainWindow::everyShortcutIsUsedOnce()
{
    QMultiMap<QString, QAction *> actions;
    for (const QAction *menu : m_open->window.menuBar()->actions()) {
        for (QAction *action : menu->menu()->actions()) {
            for (const QKeySequence &key : action->shortcuts())
                actions.insert(key.toString(), action);
        }
    }
    QVERIFY(actions.size() > 15);
    for (const QString &key : actions.uniqueKeys())
        QVERIFY2(actions.count(key) == 1, qPrintable(key));
}

QTEST_MAIN(TestMainWindow)
#include "test_main_window.moc"
