// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "tests/gui/calm.h"
#include "tests/gui/drawn_texts.h"
#include "tests/gui/open_window.h"
#include "views/action_button.h"
#include "views/charts/chart_plot.h"
#include "views/code/lua_area.h"
#include "views/menu.h"
#include "views/task_pane/step_dots.h"
#include "views/timeline.h"
#include "views/transport_bar.h"
#include "views/values/values_table.h"

#include <QMenuBar>

using namespace cradle;
using namespace cradle::windows;

/// Where one reads from the right the room is mirrored, but not physics, charts, values and code.
class TestMirroredRoom final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }
    void cleanup();
    void panesAreMirrored_data();
    void panesAreMirrored();
    void physicsAndCodeAreNot();
    void timeGoesToTheRight_data() { panesAreMirrored_data(); }
    void timeGoesToTheRight();
    void dotsBeginAtTheRight();
    void languageTurnsTheWindow();
    void keysStandAsTheyAre();

private:
    void open(Mode mode);
    static void speak(const QString &language);
    [[nodiscard]] int middle(const char *dock) const
    {
        const auto *pane = m_open->window.findChild<QDockWidget *>(QLatin1String(dock));
        return pane->geometry().center().x();
    }
    [[nodiscard]] int sceneMiddle() const
    {
        const QWidget &scene = m_open->window.scene();
        return scene.mapTo(&m_open->window, scene.rect().center()).x();
    }

    QTemporaryDir m_folder;
    std::unique_ptr<OpenWindow> m_open;
};

void TestMirroredRoom::cleanup()
{
    m_open.reset();
    speak(QStringLiteral("en"));
}

/// Also where Qt's own translations are missing, which tell it the direction.
void TestMirroredRoom::speak(const QString &language)
{
    setLanguage(language);
    QCoreApplication::processEvents();
    QGuiApplication::setLayoutDirection(QLocale(language).textDirection());
    QCoreApplication::processEvents();
}

void TestMirroredRoom::open(Mode mode)
{
    m_open = std::make_unique<OpenWindow>(m_folder);
    m_open->bench.openTask(QStringLiteral("L42T11"));
    m_open->bench.setMode(mode);
    m_open->window.resize(1440, 900);
    calm(m_open->window);
    m_open->window.room().resetLayout();
    calm(m_open->window);
}

void TestMirroredRoom::panesAreMirrored_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << QStringLiteral("en");
    QTest::newRow("Arabic") << QStringLiteral("ar");
}

void TestMirroredRoom::panesAreMirrored()
{
    QFETCH(QString, language);
    speak(language);
    const int side = language == QLatin1String("ar") ? -1 : 1; // of what one reads first
    open(Mode::Explore);
    QVERIFY(side * middle("task") < side * sceneMiddle());
    QVERIFY(side * sceneMiddle() < side * middle("inspector"));
    QVERIFY(side * sceneMiddle() < side * middle("momentum"));
    m_open.reset();
    open(Mode::Code);
    QVERIFY(side * middle("task") < side * middle("code"));
    QVERIFY(side * middle("code") < side * sceneMiddle());
    QVERIFY(side * middle("code") < side * middle("momentum"));
}

void TestMirroredRoom::physicsAndCodeAreNot()
{
    speak(QStringLiteral("ar"));
    open(Mode::Code);
    MainWindow &window = m_open->window;
    QCOMPARE(window.layoutDirection(), Qt::RightToLeft);
    QCOMPARE(window.scene().layoutDirection(), Qt::LeftToRight);
    for (const LuaArea *area : window.findChildren<LuaArea *>())
        QCOMPARE(area->layoutDirection(), Qt::LeftToRight);
    QCOMPARE(window.findChild<Timeline *>()->layoutDirection(), Qt::LeftToRight);
    for (const ChartPlot *plot : window.findChildren<ChartPlot *>())
        QCOMPARE(plot->layoutDirection(), Qt::LeftToRight);
    for (const NumberField *field : window.findChildren<NumberField *>())
        QCOMPARE(field->layoutDirection(), Qt::LeftToRight);
    for (const QTableView *table : window.findChild<ValuesPane *>()->findChildren<QTableView *>())
        QCOMPARE(table->layoutDirection(), Qt::LeftToRight);
}

/// As on the timeline: the buttons that go back stand left of those that go on.
void TestMirroredRoom::timeGoesToTheRight()
{
    QFETCH(QString, language);
    open(Mode::Explore);
    speak(language);
    calm(m_open->window);
    const auto *bar = m_open->window.findChild<TransportBar *>();
    const QList<ActionButton *> buttons = bar->findChildren<ActionButton *>();
    QCOMPARE(buttons.size(), 7); // Restart, Step back, Run, Step, Previous hit, Next hit; Check
    for (qsizetype i = 1; i < 6; ++i)
        QVERIFY(buttons[i - 1]->geometry().right() < buttons[i]->geometry().left());
}

void TestMirroredRoom::dotsBeginAtTheRight()
{
    StepDots dots;
    dots.setLayoutDirection(Qt::RightToLeft);
    dots.setSteps({QStringLiteral("one"), QStringLiteral("two")}, {false, false}, 0);
    dots.resize(dots.sizeHint());
    int chosen = -1;
    connect(&dots, &StepDots::stepChosen, this, [&chosen](int step) { chosen = step; });
    QTest::mouseClick(&dots, Qt::LeftButton, {}, QPoint(dots.width() - 18, dots.height() / 2));
    QCOMPARE(chosen, 0);
    QTest::keyClick(&dots, Qt::Key_Left);
    QTest::keyClick(&dots, Qt::Key_Return);
    QCOMPARE(chosen, 1);
}

void TestMirroredRoom::languageTurnsTheWindow()
{
    open(Mode::Explore);
    QVERIFY(middle("task") < sceneMiddle());
    speak(QStringLiteral("ar"));
    calm(m_open->window);
    QVERIFY(middle("task") > sceneMiddle());
}

/// Not "++Ctrl"; and the menus of the language before are gone.
void TestMirroredRoom::keysStandAsTheyAre()
{
    speak(QStringLiteral("ar"));
    open(Mode::Explore);
    const auto menus =
        m_open->window.menuBar()->findChildren<Menu *>(QString(), Qt::FindDirectChildrenOnly);
    QCOMPARE(menus.size(), m_open->window.menuBar()->actions().size());
    QStringList drawn;
    for (Menu *menu : menus) {
        menu->popup(QPoint());
        for (const DrawnText &each : drawnTexts(*menu))
            drawn << each.text;
        menu->hide();
    }
    QVERIFY2(drawn.contains(QStringLiteral("Ctrl++")), qPrintable(drawn.join(u' ')));
    QVERIFY(drawn.contains(QStringLiteral("Ctrl+-")));
    QVERIFY(drawn.contains(QStringLiteral("Ctrl+/")));
}

QTEST_MAIN(TestMirroredRoom)

#include "test_mirrored_room.moc"
