// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include "tests/gui/open_window.h"
#include "tests/test_paths.h"

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTimer>

using namespace cradle;
using namespace cradle::windows;

/// The window itself: keys, languages, colours, panes, files.
class TestMainWindow final : public QObject
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
    void sceneFileIsOpened();
    void brokenSceneFileGivesANotice_data();
    void brokenSceneFileGivesANotice();
    void brokenSettingsDoNoHarm();
    void everyShortcutIsUsedOnce();

private:
    void reopen();
    void openFile(const QString &path);
    QDockWidget *pane(const char *name) const;

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<OpenWindow> m_open;
};

void TestMainWindow::initTestCase()
{
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    applyTheme(ThemeChoice::Light);
}

void TestMainWindow::init()
{
    setLanguage(QStringLiteral("en"));
    m_folder = std::make_unique<QTemporaryDir>();
    reopen();
}

void TestMainWindow::cleanup()
{
    m_open.reset();
    applyTheme(ThemeChoice::Light);
}

void TestMainWindow::reopen()
{
    if (m_open)
        m_open->window.close();
    m_open.reset();
    m_open = std::make_unique<OpenWindow>(*m_folder);
    QVERIFY(QTest::qWaitForWindowActive(&m_open->window));
}

/// Opens a file by the dialog of the menu.
void TestMainWindow::openFile(const QString &path)
{
    bool accepted = false;
    QTimer watch;
    connect(&watch, &QTimer::timeout, this, [&] {
        auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
        if (!dialog || accepted)
            return;
        accepted = true;
        dialog->findChild<QLineEdit *>()->setText(path);
        QMetaObject::invokeMethod(dialog, "accept");
    });
    watch.start(10);
    m_open->window.openPresetFile();
    QVERIFY(accepted);
}

QDockWidget *TestMainWindow::pane(const char *name) const
{
    return m_open->window.findChild<QDockWidget *>(QLatin1String(name));
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
    m_open->window.chooseLanguage(QStringLiteral("de"));
    QTRY_COMPARE(shown()[4], QStringLiteral("Prüfen"));
    const QStringList german = shown();
    // "Lab" is the same word in both.
    for (const int i : {0, 1, 3, 4, 5})
        QVERIFY2(german[i] != english[i], qPrintable(german[i]));
    QCOMPARE(german[5], QStringLiteral("1 · In Bewegung setzen"));
    QCOMPARE(m_open->settings.value(QStringLiteral("language")).toString(), QStringLiteral("de"));
    QCOMPARE(m_open->simulation().current(), qint64{1});
    m_open->window.chooseLanguage(QStringLiteral("en"));
    QTRY_COMPARE(shown(), english);
}

void TestMainWindow::languageSwitchKeepsTheVisit()
{
    Preset other = m_open->preset();
    other.gravity = {0.0, -1.0};
    m_open->bench.document().visit(other);
    QVERIFY(m_open->button(QStringLiteral("Back to my scene")));
    m_open->window.chooseLanguage(QStringLiteral("de"));
    QVERIFY(m_open->bench.document().isVisiting());
    QVERIFY2(m_open->window.notice().isVisible(), "no way back is shown");
    QTRY_VERIFY(!m_open->says(QStringLiteral("This is a scene of the check")));
}

void TestMainWindow::coloursAreSwitched()
{
    m_open->window.chooseTheme(ThemeChoice::Dark);
    QVERIFY(theme().dark);
    QCOMPARE(m_open->window.palette().color(QPalette::Window), Theme::darkTheme().window);
    const QImage dark = m_open->window.grab().toImage();
    m_open->window.chooseTheme(ThemeChoice::Light);
    QVERIFY(!theme().dark && m_open->window.grab().toImage() != dark);
    QCOMPARE(m_open->settings.value(QStringLiteral("theme")).toInt(),
             static_cast<int>(ThemeChoice::Light));
}

void TestMainWindow::panesAreUnlockedAndLocked()
{
    // A bar of no height hides the style's; without it the pane can be moved.
    QVERIFY(pane("task")->titleBarWidget());
    for (const bool unlocked : {true, false}) {
        m_open->window.unlockPanes(unlocked);
        for (const QDockWidget *dock : m_open->window.panes())
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
    m_open->window.unlockPanes(true);
    pane("energy")->hide();
    pane("values")->setFloating(true);
    m_open->window.addDockWidget(Qt::RightDockWidgetArea, pane("task"));
    m_open->window.resetLayout();
    QVERIFY(pane("energy")->isVisible() && !pane("values")->isFloating());
    QCOMPARE(m_open->window.dockWidgetArea(pane("task")), Qt::LeftDockWidgetArea);
    QCOMPARE(m_open->window.dockWidgetArea(pane("inspector")), Qt::RightDockWidgetArea);
}

void TestMainWindow::sceneFileIsOpened()
{
    openFile(sourcePath("tasks/lab-4.2/L42T14/preset.json"));
    QVERIFY(m_open->preset() == *readPreset(QStringLiteral(":/labs/lab-4.2/L42T14/preset.json")));
    // The lab is still there.
    QVERIFY(m_open->bench.openTask(QStringLiteral("L42T2")));
    QVERIFY(m_open->window.transportBar().checkAction()->isEnabled());
}

void TestMainWindow::brokenSceneFileGivesANotice_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"radius_negative.json", "binary.json", "overlapping.json"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void TestMainWindow::brokenSceneFileGivesANotice()
{
    QFETCH(QString, name);
    m_open->typeCell(0, CircleTableModel::VelocityX, QStringLiteral("2"));
    const Preset before = m_open->preset();
    openFile(fixturePath("presets/bad/") + name);
    QVERIFY(m_open->window.notice().isVisible());
    QVERIFY2(m_open->window.notice().text().contains(name),
             qPrintable(m_open->window.notice().text()));
    QVERIFY(m_open->preset() == before);
    QCOMPARE(m_open->bench.current(), 0);
    m_open->click(QStringLiteral("Got it"));
    QVERIFY(m_open->window.notice().isHidden());
}

void TestMainWindow::brokenSettingsDoNoHarm()
{
    m_open.reset();
    {
        QSettings settings(m_folder->filePath(QStringLiteral("settings.ini")),
                           QSettings::IniFormat);
        settings.setValue(QStringLiteral("geometry"), QByteArray("nonsense"));
        settings.setValue(QStringLiteral("layout/explore"), QByteArray(1000, '\xff'));
        settings.setValue(QStringLiteral("renderer"), QStringLiteral("crayon"));
    }
    reopen();
    QVERIFY(pane("task")->isVisible());
    m_open->press(Qt::Key_Right);
    QCOMPARE(m_open->simulation().current(), qint64{1});
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
