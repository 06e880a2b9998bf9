// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cpu_timer.h"
#include "tests/gui/console_fixture.h"
#include "tests/gui/settled.h"
#include "tests/patience.h"
#include "views/console_model.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>

#include <cmath>

using namespace cradle;

class TestConsoleView final : public QObject
{
    Q_OBJECT
private slots:
    void emptyConsoleSaysWhatToDo();
    void linesComeWithTheirSteps();
    void signsWithoutShapeAreShown_data();
    void signsWithoutShapeAreShown();
    void endIsFollowedUnlessScrolledUp();
    void momentShownIsFollowed();
    void clearHidesUntilTheNextRun();
    void linesAreCopied();
    void lineSeeksToItsStep();
    void rowsFollowTheNotesThatAreKept();
    void floodCostsNoMoreThanAFrame();
};

void TestConsoleView::emptyConsoleSaysWhatToDo()
{
    Console console;
    const auto *hint = console.list->viewport()->findChild<QLabel *>();
    QVERIFY(hint->isVisible());
    QCOMPARE(hint->text(), QStringLiteral("print(…) in your program writes here"));
    run(console.simulation, 1);
    QTRY_VERIFY(!hint->isVisible());
    QCOMPARE(console.rows(), 1);
}

void TestConsoleView::linesComeWithTheirSteps()
{
    Console console;
    console.program.atLoad = QStringLiteral("ready\n");
    console.simulation.restart();
    run(console.simulation, 3);
    QTRY_COMPARE(console.rows(), 4);
    QCOMPARE(console.text(0), QStringLiteral("ready"));
    QCOMPARE(console.list->model()->index(0, 0).data(ConsoleModel::stepRole).toLongLong(), 0);
    QCOMPARE(console.text(3), QStringLiteral("line of 3"));
    QCOMPARE(console.list->model()->index(3, 0).data(ConsoleModel::stepRole).toLongLong(), 3);
    const QString told = console.list->model()->index(3, 0).data(Qt::ToolTipRole).toString();
    QVERIFY2(told.contains(QStringLiteral("step 3, at 0.050 s")), qPrintable(told));
}

void TestConsoleView::signsWithoutShapeAreShown_data()
{
    QTest::addColumn<QString>("printed");
    QTest::addColumn<QString>("shown");
    QTest::newRow("tab to the next stop")
        << QStringLiteral("a\tbcde\tf") << QStringLiteral("a   bcde    f");
    QTest::newRow("control") << QStringLiteral("a\x01z") << QStringLiteral("a·z");
    QTest::newRow("rich text") << QStringLiteral("<b>a</b>") << QStringLiteral("<b>a</b>");
    QTest::newRow("too long") << QString(70'000, u'x')
                              << QString(ConsoleModel::longestLine, u'x') + u'…';
}

void TestConsoleView::signsWithoutShapeAreShown()
{
    QFETCH(QString, printed);
    Console console([&](World &, ProgramOutput &output) { output.text = printed + u'\n'; });
    run(console.simulation, 1);
    QTRY_COMPARE(console.rows(), 1);
    QTEST(console.text(0), "shown");
    console.view.copyAll();
    QCOMPARE(QGuiApplication::clipboard()->text(), printed + u'\n');
}

void TestConsoleView::endIsFollowedUnlessScrolledUp()
{
    Console console;
    QScrollBar *bar = console.list->verticalScrollBar();
    run(console.simulation, 100);
    QTRY_COMPARE(console.rows(), 100);
    QCOMPARE(bar->value(), bar->maximum());
    bar->setValue(10);
    run(console.simulation, 50);
    QTRY_COMPARE(console.rows(), 150);
    QCOMPARE(bar->value(), 10);
    bar->setValue(bar->maximum());
    run(console.simulation, 50);
    QTRY_COMPARE(console.rows(), 200);
    QCOMPARE(bar->value(), bar->maximum());
    console.view.resize(344, 160);
    QTRY_COMPARE(bar->value(), bar->maximum());
}

void TestConsoleView::momentShownIsFollowed()
{
    Console console;
    run(console.simulation, 200);
    QTRY_COMPARE(console.rows(), 200);
    console.simulation.seek(120);
    QTRY_VERIFY2(std::abs(console.lowest() - 119) <= 1,
                 qPrintable(QString::number(console.lowest())));
    console.simulation.seek(200);
    QTRY_COMPARE(console.list->verticalScrollBar()->value(),
                 console.list->verticalScrollBar()->maximum());
}

void TestConsoleView::clearHidesUntilTheNextRun()
{
    Console console;
    run(console.simulation, 5);
    QTRY_COMPARE(console.rows(), 5);
    console.view.clear();
    QCOMPARE(console.rows(), 0);
    run(console.simulation, 2);
    QTRY_COMPARE(console.rows(), 2);
    QCOMPARE(console.text(0), QStringLiteral("line of 6"));
    console.simulation.restart();
    QCOMPARE(console.rows(), 0);
    run(console.simulation, 3);
    QTRY_COMPARE(console.rows(), 3);
    QCOMPARE(console.text(0), QStringLiteral("line of 1"));
}

void TestConsoleView::linesAreCopied()
{
    Console console;
    console.program.failsAt = 4;
    run(console.simulation, 4);
    QTRY_COMPARE(console.rows(), 4);
    for (const int row : {2, 0})
        console.list->selectionModel()->select(console.list->model()->index(row, 0),
                                               QItemSelectionModel::Select);
    console.view.copySelection();
    QCOMPARE(QGuiApplication::clipboard()->text(), numbered(1) + numbered(3));
    console.view.copyAll();
    QCOMPARE(QGuiApplication::clipboard()->text(),
             numbered(1) + numbered(2) + numbered(3) + numbered(4)
                 + QStringLiteral("line 12, step 4: attempt to index a nil value\n"));
}

void TestConsoleView::lineSeeksToItsStep()
{
    Console console;
    run(console.simulation, 9);
    QTRY_COMPARE(console.rows(), 9);
    QSignalSpy asked(&console.view, &ConsoleView::seekRequested);
    const QPoint seventh = console.list->visualRect(console.list->model()->index(6, 0)).center();
    QTest::mouseClick(console.list->viewport(), Qt::LeftButton, {}, seventh);
    QCOMPARE(asked.count(), 0);
    QTest::mouseDClick(console.list->viewport(), Qt::LeftButton, {}, seventh);
    QCOMPARE(asked.count(), 1);
    const qint64 frame = asked.takeFirst().at(0).toLongLong();
    QCOMPARE(console.simulation.recording().step(frame), 7);
}

void TestConsoleView::rowsFollowTheNotesThatAreKept()
{
    constexpr int perStep = 900;
    QString many;
    for (int i = 0; i < perStep; ++i)
        many += QStringLiteral("%1\n").arg(i);
    Console console([&](World &, ProgramOutput &output) { output.text = many; });
    const ProgramNotes &notes = console.simulation.notes();
    const auto most = static_cast<int>(ProgramNotes::mostLines);
    for (int i = 0; i < 12; ++i) {
        run(console.simulation, 1);
        settle();
        QCOMPARE(console.rows(), std::min(most, (i + 1) * perStep));
        QCOMPARE(console.text(0), notes.lines().front().text);
        QCOMPARE(console.text(console.rows() - 1), notes.lines().back().text);
    }
    // What the student reads stays where it is while the oldest lines go.
    QScrollBar *bar = console.list->verticalScrollBar();
    bar->setValue(3000);
    const QString read = console.text(3000);
    run(console.simulation, 1);
    QTRY_COMPARE(bar->value(), 3000 - perStep);
    QCOMPARE(console.text(bar->value()), read);
    // None of the rows is left.
    run(console.simulation, 20);
    QTRY_COMPARE(console.text(console.rows() - 1), notes.lines().back().text);
    QCOMPARE(console.rows(), most);
}

void TestConsoleView::floodCostsNoMoreThanAFrame()
{
    QString flood;
    while (flood.size() < 60 * 1024)
        flood += QStringLiteral("a\tline\tof\tno\tgreat\tlength\n");
    Console console([&](World &, ProgramOutput &output) { output.text = flood; });
    run(console.simulation, 10);
    QTRY_VERIFY(console.rows() > 0);
    run(console.simulation, 8); // as many as a frame has at eightfold speed
    const CpuTimer time;
    console.view.hide();
    console.view.show(); // brings it up to date
    QTRY_COMPARE(console.rows(), static_cast<int>(ProgramNotes::mostLines));
    QTRY_COMPARE(console.list->verticalScrollBar()->value(),
                 console.list->verticalScrollBar()->maximum());
    console.view.repaint();
    QVERIFY2(time.elapsed() < 500.0, qPrintable(QString::number(time.elapsed())));
}

QTEST_MAIN(TestConsoleView)

#include "test_console_view.moc"
