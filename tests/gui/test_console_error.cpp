// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/calm.h"
#include "tests/gui/console_fixture.h"
#include "tests/patience.h"
#include "views/error_line.h"
#include "views/values/values_table.h"

#include <QSignalSpy>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>

using namespace cradle;

class TestConsoleError final : public QObject
{
    Q_OBJECT
private slots:
    void errorTellsItsPlace_data();
    void errorTellsItsPlace();
    void errorIsShownAndActivated();
    void errorGoesWithItsRun();
    void tabIsMarkedUntilItIsShown();
    void tabsFit();
    void titleFollowsTheWidget();
};

void TestConsoleError::errorTellsItsPlace_data()
{
    QTest::addColumn<int>("line");
    QTest::addColumn<qint64>("step");
    QTest::addColumn<QString>("told");
    QTest::newRow("in a step") << 12 << qint64{40} << QStringLiteral("line 12, step 40: wrong");
    QTest::newRow("while loading") << 12 << qint64{0} << QStringLiteral("line 12: wrong");
    QTest::newRow("no line") << 0 << qint64{40} << QStringLiteral("step 40: wrong");
    QTest::newRow("nowhere") << 0 << qint64{0} << QStringLiteral("wrong");
}

void TestConsoleError::errorTellsItsPlace()
{
    QFETCH(int, line);
    QFETCH(qint64, step);
    const ProgramError error{.message = QStringLiteral("wrong"), .line = line, .step = step};
    QTEST(ErrorLine::describe(error), "told");
}

void TestConsoleError::errorIsShownAndActivated()
{
    Console console;
    auto *line = console.view.findChild<ErrorLine *>();
    QVERIFY(!line->isVisible());
    console.program.failsAt = 3;
    run(console.simulation, 3);
    QTRY_VERIFY(line->isVisible());
    QCOMPARE(line->text(), QStringLiteral("line 12, step 3: attempt to index a nil value"));
    QCOMPARE(console.view.errorText(), line->text());
    QSignalSpy activated(&console.view, &ConsoleView::lineActivated);
    QTest::mouseClick(line, Qt::LeftButton);
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(activated.count(), 2);
    QCOMPARE(activated.takeFirst().at(0).toInt(), 12);
}

void TestConsoleError::errorGoesWithItsRun()
{
    Console console;
    QSignalSpy shown(&console.view, &ConsoleView::errorShown);
    console.program.loadError = ProgramError{.message = QStringLiteral("'=' expected"), .line = 2};
    console.simulation.restart();
    QCOMPARE(console.view.errorText(), QStringLiteral("line 2: '=' expected"));
    QVERIFY(!shown.isEmpty() && shown.takeLast().at(0).toBool());
    console.program.loadError.reset();
    console.simulation.restart();
    QVERIFY(console.view.errorText().isEmpty());
    QVERIFY(!console.view.findChild<ErrorLine *>()->isVisible());
    QCOMPARE(shown.takeLast().at(0).toBool(), false);
}

void TestConsoleError::tabIsMarkedUntilItIsShown()
{
    ShowingProgram program;
    program.failsAt = 2;
    Simulation simulation(glancing());
    simulation.setProgram(&program);
    ValuesPane pane(simulation);
    auto *console = new ConsoleView(simulation);
    pane.addTab(console, QStringLiteral("Console"));
    connect(console, &ConsoleView::errorShown, &pane,
            [&](bool shown) { pane.markTab(console, shown); });
    pane.show();
    run(simulation, 2);
    QCOMPARE(pane.tabs().tabText(2), QStringLiteral("Console •"));
    pane.tabs().setCurrentIndex(2);
    QCOMPARE(pane.tabs().tabText(2), QStringLiteral("Console"));
    simulation.restart();
    run(simulation, 2);
    QCOMPARE(pane.tabs().tabText(2), QStringLiteral("Console"));
    pane.tabs().setCurrentIndex(0);
    simulation.restart();
    run(simulation, 2);
    QCOMPARE(pane.tabs().tabText(2), QStringLiteral("Console •"));
    simulation.restart();
    QCOMPARE(pane.tabs().tabText(2), QStringLiteral("Console"));
}

void TestConsoleError::tabsFit()
{
    Simulation simulation(glancing());
    ValuesPane pane(simulation);
    auto *console = new ConsoleView(simulation);
    auto *last = new QWidget;
    pane.addTab(console, QStringLiteral("Console"));
    pane.addTab(last, QStringLiteral("Plots"));
    pane.markTab(console, true);
    pane.resize(344, 276);
    pane.show();
    calm(pane);
    pane.tabs().setTabText(1, QStringLiteral("Hits 12345"));
    const QTabBar *bar = pane.tabs().tabBar();
    QVERIFY2(bar->tabRect(3).right() <= 344, qPrintable(QString::number(bar->tabRect(3).right())));
}

void TestConsoleError::titleFollowsTheWidget()
{
    Simulation simulation(glancing());
    ValuesPane pane(simulation);
    auto *widget = new QWidget;
    pane.addTab(widget, QStringLiteral("Console"));
    pane.markTab(widget, true);
    widget->setWindowTitle(QStringLiteral("Konsole"));
    QCOMPARE(pane.tabs().tabText(2), QStringLiteral("Konsole •"));
    pane.setTabTitle(widget, QStringLiteral("Ausgabe"));
    QCOMPARE(pane.tabs().tabText(2), QStringLiteral("Ausgabe •"));
}

QTEST_MAIN(TestConsoleError)

#include "test_console_error.moc"
