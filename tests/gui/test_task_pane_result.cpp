// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/calm.h"
#include "tests/gui/legible.h"
#include "tests/gui/open_task_pane.h"
#include "views/task_pane/check_row.h"
#include "views/task_pane/message_text.h"
#include "views/task_pane/result_pane.h"
#include "views/task_pane/step_delegate.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSplitter>
#include <QToolButton>

#include <memory>

using namespace cradle;

class TestTaskPaneResult final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(ThemeChoice::Light); }
    void init();
    void cleanup() { m_open.reset(); }
    void emptyResultSaysWhatToDo();
    void failedCheckIsExplained();
    void headingOfAFailureSaysSo();
    void messagesKeepUnitsTogether_data();
    void messagesKeepUnitsTogether();
    void rowOpensByAClickAndLeadsToItsMoment();
    void wrongStartHasNoMoment();
    void stepPassedBeforeSaysWhen();
    void sceneWithoutAStepHasNothingToCheck();
    void lastStepNamesWhatIsOpen();
    void resultLeavesRoomForInstructions_data();
    void resultLeavesRoomForInstructions();
    void passedCheckOffersCommitAndNextStep();
    void progressOfACheckIsShown();
    void staleResultIsMarked();
    void staleResultIsAsReadable_data();
    void staleResultIsAsReadable();
    void staleResultStaysWhereItIs();

private:
    std::unique_ptr<OpenTaskPane> m_open;
};

void TestTaskPaneResult::init()
{
    m_open = std::make_unique<OpenTaskPane>();
    QVERIFY(m_open->show());
}

void TestTaskPaneResult::emptyResultSaysWhatToDo()
{
    QVERIFY(m_open->says(QStringLiteral("Press Check")));
    m_open->pane.setReport(report(false));
    QVERIFY(!m_open->says(QStringLiteral("Press Check")));
    m_open->pane.setReport(std::nullopt);
    QVERIFY(m_open->says(QStringLiteral("Press Check")));
}

void TestTaskPaneResult::failedCheckIsExplained()
{
    m_open->pane.setReport(report(false));
    QSignalSpy moments(&m_open->pane, &TaskPane::showMoment);
    QVERIFY(m_open->says(QStringLiteral("It moves")));
    QVERIFY(m_open->says(QStringLiteral("It left the square.")));
    m_open->button(QStringLiteral("Show the moment"))->click();
    QCOMPARE(moments.size(), 1);
    QCOMPARE(moments.front().front().value<CheckOutcome>().step, 42);
    const auto visible = [this] {
        int count = 0;
        for (const auto *label : m_open->pane.findChildren<QLabel *>())
            count += label->isVisible() && label->text() == QStringLiteral("It left the square.");
        return count;
    };
    QCOMPARE(visible(), 1);
    m_open->button(QStringLiteral("Show what was observed"))->click();
    QCOMPARE(visible(), 2);
}

void TestTaskPaneResult::headingOfAFailureSaysSo()
{
    CheckReport failed = report(false);
    failed.checks[1].message = QStringLiteral("At step 3 it has -2 m/s");
    m_open->pane.setReport(failed);
    QVERIFY(m_open->says(QStringLiteral("Not yet: It bounces")));
    QVERIFY(m_open->says(QStringLiteral("At step 3 it has −2\u00a0m\u2060/\u2060s.")));
}

void TestTaskPaneResult::messagesKeepUnitsTogether_data()
{
    QTest::addColumn<QString>("plain");
    QTest::addColumn<QString>("shown");
    const auto row = [](const char *name, const QString &plain, const QString &shown) {
        QTest::newRow(name) << plain << shown;
    };
    row("vector", QStringLiteral("at (2, -0.5) m/s it"),
        QStringLiteral("at (2,\u00a0−0.5)\u00a0m\u2060/\u2060s it"));
    row("momentum", QStringLiteral("522.7 kg m/s."),
        QStringLiteral("522.7\u00a0kg\u00a0m\u2060/\u2060s."));
    row("acceleration", QStringLiteral("9.81 m/s²"), QStringLiteral("9.81\u00a0m\u2060/\u2060s²"));
    row("short ones", QStringLiteral("1 m, 2 s, 3 J, 4 ms, 5 kg"),
        QStringLiteral("1\u00a0m, 2\u00a0s, 3\u00a0J, 4\u00a0ms, 5\u00a0kg"));
    row("words", QStringLiteral("step 1 stops, 2 more, well-known, 1-2"),
        QStringLiteral("step 1 stops, 2 more, well-known, 1-2"));
}

void TestTaskPaneResult::messagesKeepUnitsTogether()
{
    QFETCH(QString, plain);
    QFETCH(QString, shown);
    QCOMPARE(withUnits(plain), shown);
}

void TestTaskPaneResult::rowOpensByAClickAndLeadsToItsMoment()
{
    CheckReport failed = report(false);
    failed.checks.push_back(failed.checks[1]);
    failed.checks[2].title = QStringLiteral("It stops");
    failed.checks[2].step = 77;
    m_open->pane.setReport(failed);
    m_open->pane.resize(320, 1600);
    QCoreApplication::processEvents();
    QSignalSpy moments(&m_open->pane, &TaskPane::showMoment);
    CheckRow *row = m_open->pane.findChildren<CheckRow *>().back();
    const auto link = [row] {
        for (auto *each : row->findChildren<QPushButton *>()) {
            if (each->isVisible())
                return each;
        }
        return static_cast<QPushButton *>(nullptr);
    };
    QVERIFY(!link());
    QTest::mouseClick(row, Qt::LeftButton, {}, QPoint(40, 8));
    QVERIFY(link());
    QCOMPARE(moments.size(), 1);
    link()->click();
    QCOMPARE(moments.size(), 2);
    QCOMPARE(moments.front().front().value<CheckOutcome>().step, 77);
    QTest::mouseClick(row, Qt::LeftButton, {}, QPoint(4, 8));
    QVERIFY(!link());
}

void TestTaskPaneResult::wrongStartHasNoMoment()
{
    CheckReport failed = report(false);
    failed.checks[1].step = 0;
    m_open->pane.setReport(failed);
    m_open->pane.findChildren<CheckRow *>().back()->findChild<QToolButton *>()->click();
    QVERIFY(!m_open->button(QStringLiteral("Show the moment")));
}

void TestTaskPaneResult::stepPassedBeforeSaysWhen()
{
    const Pass pass{.when = QDateTime({2026, 11, 20}, {9, 5}),
                    .commit = QStringLiteral("T2: Mine")};
    m_open->pane.setProgress({true, true, false}, 1, pass);
    QVERIFY(m_open->says(QStringLiteral("You have passed this step")));
    QVERIFY(m_open->says(QStringLiteral("on 2026-11-20 at 09:05")));
    QVERIFY(m_open->says(QStringLiteral("T2: Mine")));
    m_open->button(QStringLiteral("Copy"))->click();
    QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("T2: Mine"));
    QCoreApplication::processEvents();
    QAbstractButton *next = m_open->button(QStringLiteral("Next step"));
    QVERIFY(next);
    QCOMPARE(next->visibleRegion().boundingRect(), next->rect());
    // The file of an earlier version did not say when.
    m_open->pane.setProgress({true, true, false}, 1, {});
    QVERIFY(m_open->says(QStringLiteral("You have passed this step")));
    QVERIFY(!m_open->says(QStringLiteral("on 2026")));
    QVERIFY(!m_open->says(QStringLiteral("Commit message")));
    m_open->pane.setProgress({true, true, false}, 2, {});
    QVERIFY(m_open->says(QStringLiteral("Press Check")));
}

void TestTaskPaneResult::sceneWithoutAStepHasNothingToCheck()
{
    m_open->pane.setProgress({true, true, false}, -1);
    QVERIFY(!m_open->says(QStringLiteral("Press Check")));
    QVERIFY(m_open->says(QStringLiteral("this scene belongs to no step")));
    m_open->pane.setProgress({true, true, false}, 2);
    QVERIFY(m_open->says(QStringLiteral("Press Check")));
}

void TestTaskPaneResult::lastStepNamesWhatIsOpen()
{
    m_open->pane.setProgress({true, false, true}, 2);
    m_open->pane.setReport(report(true));
    QVERIFY(!m_open->button(QStringLiteral("Next step")));
    QVERIFY(m_open->says(QStringLiteral("That was the last step.")));
    QVERIFY(m_open->says(QStringLiteral("Still open: 2")));
    m_open->pane.setProgress({true, true, true}, 2);
    QVERIFY(m_open->says(QStringLiteral("That was the last step.")));
    QVERIFY(!m_open->says(QStringLiteral("Still open")));
    m_open->pane.setProgress({true, true, true}, 1);
    QVERIFY(m_open->button(QStringLiteral("Next step")));
}

void TestTaskPaneResult::resultLeavesRoomForInstructions_data()
{
    QTest::addColumn<int>("height");
    QTest::newRow("low") << 590;
    QTest::newRow("high") << 800;
}

void TestTaskPaneResult::resultLeavesRoomForInstructions()
{
    QFETCH(int, height);
    m_open->pane.resize(300, height);
    m_open->pane.setReport(report(false));
    QCoreApplication::processEvents();
    const QList<int> sizes = m_open->pane.findChild<QSplitter *>()->sizes();
    QVERIFY(sizes[1] <= 0.43 * height);
    QVERIFY(sizes[0] >= 0.45 * height);
    m_open->pane.setReport(std::nullopt);
    QVERIFY(m_open->pane.findChild<QSplitter *>()->sizes()[0] > sizes[0]);
}

void TestTaskPaneResult::passedCheckOffersCommitAndNextStep()
{
    m_open->pane.setReport(report(true));
    QVERIFY(m_open->says(QStringLiteral("Passed: all 2 checks")));
    QVERIFY(m_open->says(QStringLiteral("T1: Set it moving")));
    QVERIFY(m_open->says(QStringLiteral("Commit message")));
    m_open->button(QStringLiteral("Copy"))->click();
    QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("T1: Set it moving"));
    QSignalSpy next(&m_open->pane, &TaskPane::nextStepRequested);
    QAbstractButton *go = m_open->button(QStringLiteral("Next step"));
    go->setFocus();
    QTest::keyClick(go, Qt::Key_Return);
    QCOMPARE(next.size(), 1);
}

void TestTaskPaneResult::progressOfACheckIsShown()
{
    m_open->pane.setReport(report(false));
    m_open->pane.setChecking(true);
    QVERIFY(m_open->says(QStringLiteral("Checking…")));
    QVERIFY(!m_open->says(QStringLiteral("It bounces")));
    m_open->pane.setChecking(true, 3, 14);
    QVERIFY(m_open->says(QStringLiteral("Checking… 3 of 14")));
    m_open->pane.setReport(report(true));
    QVERIFY(!m_open->says(QStringLiteral("Checking")));
    QVERIFY(m_open->says(QStringLiteral("Passed")));
}

void TestTaskPaneResult::staleResultIsMarked()
{
    m_open->pane.setReport(report(true));
    m_open->pane.setStale(true);
    QVERIFY(m_open->says(QStringLiteral("Changed since this check")));
    m_open->pane.setStale(false);
    QVERIFY(!m_open->says(QStringLiteral("Changed since this check")));
    m_open->pane.setStale(true);
    m_open->pane.setReport(report(false));
    QVERIFY(!m_open->says(QStringLiteral("Changed since this check")));
}

void TestTaskPaneResult::staleResultIsAsReadable_data()
{
    QTest::addColumn<ThemeChoice>("theme");
    QTest::newRow("light") << ThemeChoice::Light;
    QTest::newRow("dark") << ThemeChoice::Dark;
    QTest::newRow("contrast") << ThemeChoice::HighContrast;
}

/// By what is seen: an effect may take the colours that a text is written with.
void TestTaskPaneResult::staleResultIsAsReadable()
{
    QFETCH(ThemeChoice, theme);
    applyTheme(theme);
    m_open->pane.setReport(report(false));
    m_open->pane.setStale(true);
    calm(m_open->pane);
    const auto *result = m_open->pane.findChild<ResultPane *>();
    const QImage picture = m_open->pane.grab().toImage();
    int read = 0;
    for (const auto *label : result->findChildren<QLabel *>()) {
        if (!label->isVisible() || label->text().isEmpty())
            continue;
        const QRect place(label->mapTo(&m_open->pane, QPoint()), label->size());
        const QColor ground = groundOf(picture, place);
        double best = 1.0;
        for (int y = place.top(); y <= place.bottom(); ++y) {
            for (int x = place.left(); x <= place.right(); ++x)
                best = std::max(best, contrast(picture.pixelColor(x, y), ground));
        }
        QVERIFY2(best >= leastContrast, qPrintable(label->text()));
        ++read;
    }
    QVERIFY(read > 3);
    applyTheme(ThemeChoice::Light);
}

void TestTaskPaneResult::staleResultStaysWhereItIs()
{
    m_open->pane.setReport(report(false));
    m_open->pane.resize(320, 420);
    calm(m_open->pane);
    auto *result = m_open->pane.findChild<ResultPane *>();
    QScrollBar *bar = result->findChild<QScrollArea *>()->verticalScrollBar();
    QVERIFY(bar->maximum() > 10);
    bar->setValue(10);
    m_open->pane.setStale(true);
    calm(m_open->pane);
    QCOMPARE(bar->value(), 10);
    m_open->pane.setStale(false);
    calm(m_open->pane);
    QCOMPARE(bar->value(), 10);
}

QTEST_MAIN(TestTaskPaneResult)
#include "test_task_pane_result.moc"
