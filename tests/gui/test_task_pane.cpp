// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/markdown_view.h"
#include "views/task_pane/task_pane.h"
#include "views/theme.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include <memory>

using namespace cradle;

namespace {

Lab threeSteps()
{
    Lab lab;
    lab.id = QStringLiteral("lab");
    for (int i = 1; i <= 3; ++i) {
        Task task;
        task.id = QStringLiteral("T%1").arg(i);
        task.title = QStringLiteral("Title %1").arg(i);
        task.instructions = QStringLiteral("# Head\nText of step %1, see [two](step:T2).").arg(i);
        task.hints = {QStringLiteral("a nudge"), QStringLiteral("more"), QStringLiteral("nearly")};
        lab.tasks.push_back(task);
    }
    lab.tasks[2].extra = true;
    return lab;
}

CheckReport report(bool passed)
{
    CheckReport made;
    made.passed = passed;
    made.commit = QStringLiteral("T1: Set it moving");
    made.checks = {{.id = QStringLiteral("a"), .title = QStringLiteral("It moves"), .passed = true},
                   {.id = QStringLiteral("b"),
                    .title = QStringLiteral("It bounces"),
                    .passed = passed,
                    .message = passed ? QString() : QStringLiteral("It left the square."),
                    .step = passed ? -1 : 42}};
    return made;
}

} // namespace

class TestTaskPane final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(ThemeChoice::Light); }
    void init();
    void cleanup() { m_pane.reset(); }
    void listsStepsWithTheirState();
    void choosesAStepByMouseAndKey();
    void scrollsToTheCurrentStep();
    void opensHintsOneAtATime();
    void linkToAStepChoosesIt();
    void emptyResultSaysWhatToDo();
    void failedCheckIsExplained();
    void passedCheckOffersCommitAndNextStep();
    void progressOfACheckIsShown();
    void staleResultIsMarked();
    void unreadFilesAreListed();
    void fitsTheNarrowestPane();

private:
    bool says(const QString &part) const;
    QAbstractButton *button(const QString &name) const;

    std::unique_ptr<TaskPane> m_pane;
    Lab m_lab = threeSteps();
};

void TestTaskPane::init()
{
    m_lab = threeSteps();
    m_pane = std::make_unique<TaskPane>();
    m_pane->resize(320, 800);
    m_pane->setLab(m_lab);
    m_pane->setProgress({true, false, false}, 1);
    m_pane->showTask(m_lab.tasks[1], 0);
    m_pane->show();
    m_pane->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_pane.get()));
}

bool TestTaskPane::says(const QString &part) const
{
    for (const auto *label : m_pane->findChildren<QLabel *>()) {
        if (label->isVisible() && label->text().contains(part))
            return true;
    }
    return false;
}

QAbstractButton *TestTaskPane::button(const QString &name) const
{
    for (auto *each : m_pane->findChildren<QAbstractButton *>()) {
        if (each->isVisible()
            && (each->accessibleName().startsWith(name) || each->text().startsWith(name)))
            return each;
    }
    return nullptr;
}

void TestTaskPane::listsStepsWithTheirState()
{
    const auto *list = m_pane->findChild<QListWidget *>();
    QCOMPARE(list->count(), 3);
    QCOMPARE(list->item(1)->text(), QStringLiteral("2 · Title 2"));
    const auto said = [list](int row) {
        return list->item(row)->data(Qt::AccessibleTextRole).toString();
    };
    QVERIFY(said(0).endsWith(QStringLiteral("passed")));
    QVERIFY(said(1).endsWith(QStringLiteral("current")));
    QVERIFY(said(2).endsWith(QStringLiteral("open")));
    QVERIFY(says(QStringLiteral("Steps · 1 of 3")));
}

void TestTaskPane::choosesAStepByMouseAndKey()
{
    QSignalSpy chosen(m_pane.get(), &TaskPane::stepChosen);
    auto *list = m_pane->findChild<QListWidget *>();
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(2)).center());
    QCOMPARE(chosen.size(), 1);
    QCOMPARE(chosen.back().front().toInt(), 2);
    m_pane->setProgress({true, false, false}, 2);
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Up);
    QTest::keyClick(list, Qt::Key_Up);
    QCOMPARE(chosen.size(), 1);
    QTest::keyClick(list, Qt::Key_Return);
    QCOMPARE(chosen.size(), 2);
    QCOMPARE(chosen.back().front().toInt(), 0);
}

void TestTaskPane::scrollsToTheCurrentStep()
{
    for (int i = 4; i <= 30; ++i)
        m_lab.tasks.push_back(m_lab.tasks[0]);
    m_pane->setLab(m_lab);
    m_pane->setProgress({}, 25);
    const auto *list = m_pane->findChild<QListWidget *>();
    const QRect row = list->visualItemRect(list->item(25));
    QVERIFY(list->viewport()->rect().contains(row));
    QVERIFY(list->viewport()->height() >= 4 * row.height());
}

void TestTaskPane::opensHintsOneAtATime()
{
    QSignalSpy opened(m_pane.get(), &TaskPane::hintOpened);
    const auto hints = [this] { return m_pane->findChildren<MarkdownView *>()[1]->toPlainText(); };
    QAbstractButton *link = button(QStringLiteral("Hint 1 of 3"));
    QVERIFY(link);
    link->click();
    QVERIFY(hints().contains(QStringLiteral("a nudge")));
    QVERIFY(!hints().contains(QStringLiteral("more")));
    QVERIFY(button(QStringLiteral("Hint 2 of 3")));
    link->click();
    link->click();
    QVERIFY(hints().contains(QStringLiteral("a nudge")));
    QVERIFY(hints().contains(QStringLiteral("nearly")));
    QVERIFY(!link->isVisible());
    QCOMPARE(opened.size(), 3);
    QCOMPARE(opened.back().front().toInt(), 3);
    m_pane->showTask(m_lab.tasks[0], 1);
    QVERIFY(!hints().contains(QStringLiteral("more")));
    QVERIFY(button(QStringLiteral("Hint 2 of 3")));
}

void TestTaskPane::linkToAStepChoosesIt()
{
    QSignalSpy chosen(m_pane.get(), &TaskPane::stepChosen);
    auto *view = m_pane->findChild<MarkdownView *>();
    QVERIFY(view->toPlainText().contains(QStringLiteral("Text of step 2")));
    emit view->stepRequested(QStringLiteral("T3"));
    QCOMPARE(chosen.size(), 1);
    QCOMPARE(chosen.back().front().toInt(), 2);
    emit view->stepRequested(QStringLiteral("unknown"));
    QCOMPARE(chosen.size(), 1);
}

void TestTaskPane::emptyResultSaysWhatToDo()
{
    QVERIFY(says(QStringLiteral("Press Check")));
    m_pane->setReport(report(false));
    QVERIFY(!says(QStringLiteral("Press Check")));
    m_pane->setReport(std::nullopt);
    QVERIFY(says(QStringLiteral("Press Check")));
}

void TestTaskPane::failedCheckIsExplained()
{
    m_pane->setReport(report(false));
    QSignalSpy moments(m_pane.get(), &TaskPane::showMoment);
    QVERIFY(says(QStringLiteral("It moves")));
    QVERIFY(says(QStringLiteral("It left the square.")));
    button(QStringLiteral("Show the moment"))->click();
    QCOMPARE(moments.size(), 1);
    QCOMPARE(moments.front().front().value<CheckOutcome>().step, 42);
    const auto visible = [this] {
        int count = 0;
        for (const auto *label : m_pane->findChildren<QLabel *>())
            count += label->isVisible() && label->text() == QStringLiteral("It left the square.");
        return count;
    };
    QCOMPARE(visible(), 1);
    button(QStringLiteral("Show what was observed"))->click();
    QCOMPARE(visible(), 2);
}

void TestTaskPane::passedCheckOffersCommitAndNextStep()
{
    m_pane->setReport(report(true));
    QVERIFY(says(QStringLiteral("Passed: all 2 checks")));
    QVERIFY(says(QStringLiteral("T1: Set it moving")));
    button(QStringLiteral("Copy"))->click();
    QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("T1: Set it moving"));
    QSignalSpy next(m_pane.get(), &TaskPane::nextStepRequested);
    QAbstractButton *go = button(QStringLiteral("Next step"));
    go->setFocus();
    QTest::keyClick(go, Qt::Key_Return);
    QCOMPARE(next.size(), 1);
}

void TestTaskPane::progressOfACheckIsShown()
{
    m_pane->setReport(report(false));
    m_pane->setChecking(true);
    QVERIFY(says(QStringLiteral("Checking…")));
    QVERIFY(!says(QStringLiteral("It bounces")));
    m_pane->setChecking(true, 3, 14);
    QVERIFY(says(QStringLiteral("Checking… 3 of 14")));
    m_pane->setReport(report(true));
    QVERIFY(!says(QStringLiteral("Checking")));
    QVERIFY(says(QStringLiteral("Passed")));
}

void TestTaskPane::staleResultIsMarked()
{
    m_pane->setReport(report(true));
    m_pane->setStale(true);
    QVERIFY(says(QStringLiteral("Changed since this check")));
    m_pane->setStale(false);
    QVERIFY(!says(QStringLiteral("Changed since this check")));
    m_pane->setStale(true);
    m_pane->setReport(report(false));
    QVERIFY(!says(QStringLiteral("Changed since this check")));
}

void TestTaskPane::unreadFilesAreListed()
{
    QVERIFY(!button(QStringLiteral("1 file")));
    m_lab.findings = {{.message = QStringLiteral("a title is right"),
                       .file = QStringLiteral("T4/task.json"),
                       .pointer = QStringLiteral("/title")},
                      {.message = QStringLiteral("not there")}};
    m_pane->setLab(m_lab);
    QAbstractButton *notice = button(QStringLiteral("2 files of this lab"));
    QVERIFY(notice);
    QVERIFY(!says(QStringLiteral("T4/task.json")));
    notice->click();
    QVERIFY(says(QStringLiteral("T4/task.json: /title: a title is right")));
}

void TestTaskPane::fitsTheNarrowestPane()
{
    m_pane->setReport(report(false));
    m_pane->resize(260, 600);
    QCoreApplication::processEvents();
    QCOMPARE(m_pane->width(), 260);
    for (const auto *label : m_pane->findChildren<QLabel *>()) {
        if (label->isVisible())
            QVERIFY2(label->mapTo(m_pane.get(), QPoint(label->width(), 0)).x() <= 260,
                     qPrintable(label->text()));
    }
}

QTEST_MAIN(TestTaskPane)
#include "test_task_pane.moc"
