// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "tests/gui/calm.h"
#include "tests/gui/open_window.h"
#include "views/code/code_editor.h"
#include "views/code/code_pane.h"
#include "views/markdown_view.h"
#include "views/task_pane/instructions_pane.h"
#include "views/task_pane/result_pane.h"
#include "views/task_pane/step_dots.h"
#include "views/values/values_model.h"
#include "views/values/values_table.h"

#include <QAbstractAnimation>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextLayout>

using namespace cradle;
using namespace cradle::windows;

namespace {

/// Of a line of the instructions, px: from one to the next in a paragraph of several.
double lineHeight(const MarkdownView &view)
{
    for (QTextBlock block = view.document()->begin(); block.isValid(); block = block.next()) {
        if (block.layout()->lineCount() > 1)
            return block.layout()->lineAt(1).y() - block.layout()->lineAt(0).y();
    }
    return 0.0;
}

} // namespace

/// How much room each mode gives to what is worked with, at three sizes of the window.
class TestRoom final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }
    void cleanup() { m_open.reset(); }
    void codeHasRoom_data() { addSizes(); }
    void codeHasRoom();
    void sceneHasRoom_data() { addSizes(); }
    void sceneHasRoom();
    void instructionsHaveRoomAfterTheCheck_data() { addSizes(); }
    void instructionsHaveRoomAfterTheCheck();
    void valuesNeedNoScrolling_data() { addSizes(); }
    void valuesNeedNoScrolling();
    void untouchedPanesFollowTheWindow();
    void nothingOfAPassIsCutOff();
    void eachModeKeepsItsArrangement();
    void dotsOpenStepsAndTheList();
    void nothingMovesByItself();

private:
    static void addSizes();
    void open(Mode mode);
    [[nodiscard]] double side()
    {
        const SceneView &scene = m_open->window.scene();
        return 2.0 * m_open->preset().halfWidth * scene.camera().pixelsPerMetre();
    }
    [[nodiscard]] QDockWidget *dock(const char *name)
    {
        return m_open->window.findChild<QDockWidget *>(QLatin1String(name));
    }

    QTemporaryDir m_folder;
    std::unique_ptr<OpenWindow> m_open;
};

void TestRoom::addSizes()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<int>("codeLines");
    QTest::addColumn<int>("codeSide");
    QTest::addColumn<int>("exploreSide");
    QTest::addColumn<int>("textLines");
    QTest::newRow("1280x720") << QSize(1280, 720) << 24 << 300 << 430 << 12;
    QTest::newRow("1440x900") << QSize(1440, 900) << 30 << 350 << 560 << 18;
    QTest::newRow("1920x1080") << QSize(1920, 1080) << 40 << 480 << 700 << 24;
}

void TestRoom::open(Mode mode)
{
    QFETCH(QSize, size);
    m_open = std::make_unique<OpenWindow>(m_folder);
    m_open->bench.openTask(QStringLiteral("L42T11"));
    m_open->bench.setMode(mode);
    m_open->window.notice().clearNotice();
    m_open->window.resize(size);
    calm(m_open->window);
    m_open->window.room().resetLayout();
    calm(m_open->window);
    QCOMPARE(m_open->window.size(), size);
}

void TestRoom::codeHasRoom()
{
    QFETCH(int, codeLines);
    QFETCH(int, codeSide);
    open(Mode::Code);
    const int lines = m_open->window.codePane().editor().linesInSight();
    qInfo("%d lines of code, square of %.0f px", lines, side());
    QVERIFY(lines >= codeLines);
    QVERIFY(side() >= codeSide);
}

void TestRoom::sceneHasRoom()
{
    QFETCH(int, exploreSide);
    open(Mode::Explore);
    qInfo("square of %.0f px", side());
    QVERIFY(side() >= exploreSide);
}

void TestRoom::instructionsHaveRoomAfterTheCheck()
{
    QFETCH(int, textLines);
    open(Mode::Code);
    m_open->check();
    calm(m_open->window);
    const auto *pane = m_open->window.findChild<InstructionsPane *>();
    const double line = lineHeight(*pane->findChild<MarkdownView *>());
    QVERIFY(line > 10.0);
    const auto *scroll = pane->findChild<QScrollArea *>();
    const double lines = scroll->viewport()->height() / line;
    qInfo("%.1f lines of instructions", lines);
    QVERIFY(lines >= textLines);
}

/// Speed, momentum and kinetic energy of two circles and of both.
void TestRoom::valuesNeedNoScrolling()
{
    for (const Mode mode : {Mode::Code, Mode::Explore}) {
        open(mode);
        dock("values")->raise();
        calm(m_open->window);
        const auto *table = m_open->window.findChild<ValuesPane *>()->findChild<QTableView *>();
        const QHeaderView &header = *table->horizontalHeader();
        for (int column = 0; column <= ValuesModel::Kinetic; ++column)
            QVERIFY2(header.sectionViewportPosition(column) + header.sectionSize(column)
                         <= table->viewport()->width(),
                     qPrintable(QString::number(column)));
        QCOMPARE(table->verticalScrollBar()->maximum(), 0);
    }
}

/// That the panes came into sight is nothing that the student did.
void TestRoom::untouchedPanesFollowTheWindow()
{
    m_open = std::make_unique<OpenWindow>(m_folder);
    m_open->bench.setMode(Mode::Code);
    m_open->window.resize(1280, 720);
    calm(m_open->window);
    const int narrow = dock("task")->width();
    m_open->window.resize(1920, 1080);
    calm(m_open->window);
    QVERIFY2(dock("task")->width() > narrow + 60, qPrintable(QString::number(narrow)));
    QVERIFY(dock("code")->width() > 700);
    m_open->window.close();
    m_open = std::make_unique<OpenWindow>(m_folder);
    QVERIFY(!m_open->settings.contains(QStringLiteral("layout/code")));
}

void TestRoom::nothingOfAPassIsCutOff()
{
    m_open = std::make_unique<OpenWindow>(m_folder);
    m_open->bench.openTask(QStringLiteral("L42T11"));
    m_open->bench.setMode(Mode::Explore);
    m_open->window.resize(1280, 720);
    QVERIFY(m_open->bench.document().edit(QStringLiteral("solve"), m_open->solution()));
    m_open->check();
    QVERIFY(m_open->bench.check().report()->passed);
    calm(m_open->window);
    const auto *scroll = m_open->window.findChild<ResultPane *>()->findChild<QScrollArea *>();
    QVERIFY(scroll->widget()->width() <= scroll->viewport()->width());
}

void TestRoom::eachModeKeepsItsArrangement()
{
    m_open = std::make_unique<OpenWindow>(m_folder);
    MainWindow &window = m_open->window;
    m_open->bench.openTask(QStringLiteral("L42T11"));
    m_open->bench.setMode(Mode::Code);
    window.room().resetLayout();
    window.addDockWidget(Qt::RightDockWidgetArea, dock("task")); // as by a drag
    m_open->bench.setMode(Mode::Explore);
    QCOMPARE(window.dockWidgetArea(dock("task")), Qt::LeftDockWidgetArea);
    QVERIFY(dock("code")->isHidden());
    m_open->bench.setMode(Mode::Code);
    QCOMPARE(window.dockWidgetArea(dock("task")), Qt::RightDockWidgetArea);
    QVERIFY(!dock("code")->isHidden());
    window.close();
    m_open = std::make_unique<OpenWindow>(m_folder);
    m_open->bench.setMode(Mode::Code);
    QCOMPARE(m_open->window.dockWidgetArea(dock("task")), Qt::RightDockWidgetArea);
    m_open->window.room().resetLayout();
    QCOMPARE(m_open->window.dockWidgetArea(dock("task")), Qt::LeftDockWidgetArea);
}

void TestRoom::dotsOpenStepsAndTheList()
{
    m_open = std::make_unique<OpenWindow>(m_folder);
    m_open->bench.openTask(QStringLiteral("L42T1"));
    auto *dots = m_open->window.findChild<StepDots *>();
    QTest::mouseClick(dots, Qt::LeftButton, {}, dots->dotRect(4).center().toPoint());
    QCOMPARE(m_open->bench.current(), 4);
    QVERIFY(dots->accessibleDescription().startsWith(QStringLiteral("5 · ")));
    dots->setFocus();
    QTest::keyClick(dots, Qt::Key_Right);
    QTest::keyClick(dots, Qt::Key_Return);
    QCOMPARE(m_open->bench.current(), 5);
    QListWidget *list = m_open->steps();
    QVERIFY(!list->isVisible());
    m_open->click(QStringLiteral("All steps"));
    QVERIFY(list->isVisible());
    auto *search = m_open->window.taskPane().findChild<QLineEdit *>();
    QTest::keyClicks(search, QStringLiteral("glancing"));
    QTest::keyClick(search, Qt::Key_Return);
    QCOMPARE(m_open->bench.current(), 10);
    QVERIFY(!list->isVisible());
}

/// Who is made ill by motion on a screen sees none but the run, which is started and stopped.
void TestRoom::nothingMovesByItself()
{
    m_open = std::make_unique<OpenWindow>(m_folder);
    QVERIFY(!m_open->window.isAnimated());
    for (const Qt::UIEffect effect :
         {Qt::UI_AnimateMenu, Qt::UI_AnimateCombo, Qt::UI_AnimateTooltip, Qt::UI_AnimateToolBox,
          Qt::UI_FadeMenu, Qt::UI_FadeTooltip})
        QVERIFY(!QApplication::isEffectEnabled(effect));
    for (const auto *each : m_open->window.findChildren<QAbstractAnimation *>())
        QVERIFY(each->state() == QAbstractAnimation::Stopped);
}

QTEST_MAIN(TestRoom)

#include "test_room.moc"
