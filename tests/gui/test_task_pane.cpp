// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/calm.h"
#include "tests/gui/open_task_pane.h"
#include "tests/patience.h"
#include "views/markdown_view.h"

#include <QListWidget>
#include <QSignalSpy>

#include <memory>

using namespace cradle;

class TestTaskPane final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(ThemeChoice::Light); }
    void init();
    void cleanup() { m_open.reset(); }
    void listsStepsWithTheirState();
    void choosesAStepByMouseAndKey();
    void scrollsToTheCurrentStep();
    void opensHintsOneAtATime();
    void hintLinkIsInSightBesideALongText();
    void linkToAStepChoosesIt();
    void unreadFilesAreListed();
    void fitsTheNarrowestPane();

private:
    std::unique_ptr<OpenTaskPane> m_open;
};

void TestTaskPane::init()
{
    m_open = std::make_unique<OpenTaskPane>();
    QVERIFY(m_open->show());
}

void TestTaskPane::listsStepsWithTheirState()
{
    const auto *list = m_open->pane.findChild<QListWidget *>();
    QCOMPARE(list->count(), 3);
    QCOMPARE(list->item(1)->text(), QStringLiteral("2 · Title 2"));
    const auto said = [list](int row) {
        return list->item(row)->data(Qt::AccessibleTextRole).toString();
    };
    QVERIFY(said(0).endsWith(QStringLiteral("passed")));
    QVERIFY(said(1).endsWith(QStringLiteral("current")));
    QVERIFY(said(2).endsWith(QStringLiteral("open")));
    QVERIFY(m_open->says(QStringLiteral("2 · Title 2")));
    QVERIFY(m_open->button(QStringLiteral("All steps, Steps · 1 of 3")));
}

void TestTaskPane::choosesAStepByMouseAndKey()
{
    QSignalSpy chosen(&m_open->pane, &TaskPane::stepChosen);
    auto *list = m_open->pane.findChild<QListWidget *>();
    m_open->button(QStringLiteral("All steps"))->click();
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(2)).center());
    QCOMPARE(chosen.size(), 1);
    QCOMPARE(chosen.back().front().toInt(), 2);
    m_open->pane.setProgress({true, false, false}, 2);
    QVERIFY(!list->isVisible()); // a step was chosen
    m_open->button(QStringLiteral("All steps"))->click();
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
        m_open->lab.tasks.push_back(m_open->lab.tasks[0]);
    m_open->pane.setLab(m_open->lab);
    m_open->pane.setProgress({}, 25);
    m_open->button(QStringLiteral("All steps"))->click();
    calm(m_open->pane);
    const auto *list = m_open->pane.findChild<QListWidget *>();
    const QRect row = list->visualItemRect(list->item(25));
    QVERIFY(list->viewport()->rect().contains(row));
    QVERIFY(list->viewport()->height() >= 4 * row.height());
}

void TestTaskPane::opensHintsOneAtATime()
{
    QSignalSpy opened(&m_open->pane, &TaskPane::hintOpened);
    const auto hints = [this] {
        for (const auto *view : m_open->pane.findChildren<MarkdownView *>()) {
            if (view->accessibleName() == QLatin1String("Hints"))
                return view->toPlainText();
        }
        return QString();
    };
    QAbstractButton *link = m_open->button(QStringLiteral("Hint 1 of 3"));
    QVERIFY(link);
    link->click();
    QVERIFY(hints().contains(QStringLiteral("a nudge")));
    QVERIFY(!hints().contains(QStringLiteral("more")));
    QVERIFY(m_open->button(QStringLiteral("Hint 2 of 3")));
    link->click();
    link->click();
    QVERIFY(hints().contains(QStringLiteral("a nudge")));
    QVERIFY(hints().contains(QStringLiteral("nearly")));
    QVERIFY(!link->isVisible());
    QCOMPARE(opened.size(), 3);
    QCOMPARE(opened.back().front().toInt(), 3);
    m_open->pane.showTask(m_open->lab.tasks[0], 1);
    QVERIFY(!hints().contains(QStringLiteral("more")));
    QVERIFY(m_open->button(QStringLiteral("Hint 2 of 3")));
}

void TestTaskPane::hintLinkIsInSightBesideALongText()
{
    m_open->lab.tasks[1].instructions += QStringLiteral("\n\nText.\n").repeated(100);
    m_open->pane.resize(300, 500);
    m_open->pane.showTask(m_open->lab.tasks[1], 0);
    QCoreApplication::processEvents();
    QAbstractButton *link = m_open->button(QStringLiteral("Hint 1 of 3"));
    QVERIFY(link);
    QCOMPARE(link->visibleRegion().boundingRect(), link->rect());
    link->click();
    QTRY_COMPARE(link->visibleRegion().boundingRect(), link->rect());
}

void TestTaskPane::linkToAStepChoosesIt()
{
    QSignalSpy chosen(&m_open->pane, &TaskPane::stepChosen);
    auto *view = m_open->pane.findChild<MarkdownView *>();
    QVERIFY(view->toPlainText().contains(QStringLiteral("Text of step 2")));
    emit view->stepRequested(QStringLiteral("T3"));
    QCOMPARE(chosen.size(), 1);
    QCOMPARE(chosen.back().front().toInt(), 2);
    emit view->stepRequested(QStringLiteral("unknown"));
    QCOMPARE(chosen.size(), 1);
}

void TestTaskPane::unreadFilesAreListed()
{
    QVERIFY(!m_open->button(QStringLiteral("1 file")));
    m_open->lab.findings = {{.message = QStringLiteral("a title is right"),
                             .file = QStringLiteral("T4/task.json"),
                             .pointer = QStringLiteral("/title")},
                            {.message = QStringLiteral("not there")}};
    m_open->pane.setLab(m_open->lab);
    QAbstractButton *notice = m_open->button(QStringLiteral("2 files of this lab"));
    QVERIFY(notice);
    QVERIFY(!m_open->says(QStringLiteral("T4/task.json")));
    notice->click();
    QVERIFY(m_open->says(QStringLiteral("T4/task.json: /title: a title is right")));
}

void TestTaskPane::fitsTheNarrowestPane()
{
    m_open->pane.setReport(report(false));
    m_open->pane.resize(260, 600);
    QCoreApplication::processEvents();
    QCOMPARE(m_open->pane.width(), 260);
    for (const auto *label : m_open->pane.findChildren<QLabel *>()) {
        if (label->isVisible())
            QVERIFY2(label->mapTo(&m_open->pane, QPoint(label->width(), 0)).x() <= 260,
                     qPrintable(label->text()));
    }
}

QTEST_MAIN(TestTaskPane)
#include "test_task_pane.moc"
