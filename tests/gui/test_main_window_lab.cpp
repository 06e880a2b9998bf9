// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include "tests/gui/window_test.h"
#include "tests/patience.h"

#include <cmath>

using namespace cradle;
using namespace cradle::windows;

/// A student's way through the lab, by the real window.
class TestMainWindowLab final : public WindowTest
{
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup() { m_open.reset(); }
    void firstStartShowsStepOnePaused();
    void firstStepIsSolvedByTyping();
    void passCountsWhenItsRunIsShown();
    void passOfWorkThatWasSeenCountsAtOnce();
    void seenRunOfOtherWorkDoesNotCount();
    void allStepsAreSolved();
    void progressSurvivesClosingAndReopening();
    void progressSurvivesOpeningALab();
    void brokenProgressGivesANoticeAndIsKept();
    void stepsAreChosenFromTheListAndByKeys();
};

void TestMainWindowLab::initTestCase()
{
    setLanguage(QStringLiteral("en"));
    applyTheme(ThemeChoice::Light);
}

void TestMainWindowLab::init()
{
    takeNewFolder();
}

void TestMainWindowLab::firstStartShowsStepOnePaused()
{
    QCOMPARE(m_open->bench.current(), 0);
    QCOMPARE(m_open->bench.task()->id, QStringLiteral("L42T1"));
    QVERIFY(!m_open->simulation().isRunning());
    QVERIFY(m_open->simulation().atStart());
    QCOMPARE(m_open->steps()->count(), 17);
    QVERIFY(m_open->window.notice().isVisible());
    QVERIFY(m_open->says(QStringLiteral("Read the step on the left, set the values")));
    m_open->bench.setMode(Mode::Code); // where there are none to set
    QVERIFY(m_open->says(QStringLiteral("Read the step on the left, write your program")));
    m_open->bench.setMode(Mode::Explore);
    QVERIFY(m_open->says(QStringLiteral("set the values")));
    m_open->click(QStringLiteral("Got it"));
    QVERIFY(m_open->window.notice().isHidden());
    m_open->bench.setMode(Mode::Code);
    QVERIFY(m_open->window.notice().isHidden());
    m_open->bench.setMode(Mode::Explore);
    QVERIFY(m_open->says(QStringLiteral("Press Check")));
    for (int step = 0; step < 17; ++step)
        QVERIFY(!m_open->isTicked(step));
}

void TestMainWindowLab::firstStepIsSolvedByTyping()
{
    m_open->check();
    QVERIFY(!m_open->bench.check().report()->passed);
    QVERIFY(!m_open->isTicked(0));
    m_open->typeCell(0, CircleTableModel::VelocityX, QStringLiteral("2"));
    QVERIFY(m_open->says(QStringLiteral("Changed since this check")));
    m_open->check();
    QVERIFY(m_open->bench.check().report()->passed);
    QVERIFY(m_open->says(QStringLiteral("Passed: all 3 checks")));
    QVERIFY(m_open->says(QStringLiteral("L42T1 Set my circle moving off to the right")));
    QVERIFY(m_open->isTicked(0));
    m_open->click(QStringLiteral("Next step"));
    QCOMPARE(m_open->bench.current(), 1);
    QCOMPARE(m_open->steps()->currentRow(), 1);
    QVERIFY(m_open->says(QStringLiteral("Press Check")));
    QVERIFY(m_open->window.notice().isHidden());
    QVERIFY(m_open->isTicked(0) && !m_open->isTicked(1));
}

void TestMainWindowLab::passCountsWhenItsRunIsShown()
{
    QVERIFY(m_open->bench.document().edit(QStringLiteral("solve"), m_open->solution()));
    std::vector<bool> atVerdict;
    connect(&m_open->bench.check(), &WorkCheck::reported, this, [&] {
        atVerdict = m_open->bench.progress().passed();
        QVERIFY(m_open->simulation().atStart());
    });
    m_open->check();
    QVERIFY(m_open->bench.check().report()->passed);
    QVERIFY(!atVerdict.empty() && !atVerdict.front());
    // Check itself plays what it passed; with that the step counts.
    QVERIFY(m_open->simulation().isRunning());
    QVERIFY(!m_open->simulation().atStart());
    QVERIFY(m_open->isTicked(0));
    QVERIFY(!m_open->says(QStringLiteral("as soon as the run")));
}

void TestMainWindowLab::passOfWorkThatWasSeenCountsAtOnce()
{
    QVERIFY(m_open->bench.document().edit(QStringLiteral("solve"), m_open->solution()));
    m_open->simulation().stepForward();
    m_open->simulation().restart();
    bool atVerdict = false;
    connect(&m_open->bench.check(), &WorkCheck::reported, this,
            [&] { atVerdict = m_open->bench.progress().passed().front(); });
    m_open->check();
    QVERIFY(atVerdict);
    QVERIFY(!m_open->simulation().isRunning());
    QVERIFY(m_open->simulation().atStart());
}

void TestMainWindowLab::seenRunOfOtherWorkDoesNotCount()
{
    m_open->simulation().stepForward();
    QVERIFY(m_open->bench.document().edit(QStringLiteral("solve"), m_open->solution()));
    QVERIFY(m_open->simulation().atStart());
    m_open->bench.check().start();
    // The work is changed before the verdict comes: what is shown later is not what was judged.
    Preset other = m_open->solution();
    other.circles.front().body.velocity.x *= 1.5;
    QVERIFY(m_open->bench.document().edit(QStringLiteral("other"), other));
    QTRY_VERIFY(m_open->bench.check().report());
    QVERIFY(m_open->bench.check().report()->passed && m_open->bench.check().awaitsRun());
    QVERIFY(m_open->says(QStringLiteral("as soon as the run")));
    m_open->simulation().stepForward();
    QVERIFY(!m_open->bench.progress().passed().front());
    m_open->bench.document().undoStack().undo();
    m_open->simulation().stepForward();
    QVERIFY(m_open->bench.progress().passed().front());
    QVERIFY(!m_open->says(QStringLiteral("as soon as the run")));
}

void TestMainWindowLab::allStepsAreSolved()
{
    for (int step = 0; step < 17; ++step) {
        QCOMPARE(m_open->bench.current(), step);
        QVERIFY(m_open->bench.document().edit(QStringLiteral("solve"), m_open->solution()));
        m_open->check();
        QVERIFY2(m_open->bench.check().report()->passed, qPrintable(m_open->bench.task()->id));
        QVERIFY(m_open->isTicked(step));
        if (step < 16)
            m_open->click(QStringLiteral("Next step"));
    }
    QVERIFY(m_open->button(QStringLiteral("All steps, Steps · 17 of 17")));
    // After the last step there is no next one to open.
    if (QAbstractButton *next = m_open->button(QStringLiteral("Next step")))
        next->click();
    QCOMPARE(m_open->bench.current(), 16);
}

void TestMainWindowLab::progressSurvivesClosingAndReopening()
{
    m_open->typeCell(0, CircleTableModel::VelocityX, QStringLiteral("2"));
    m_open->check();
    m_open->click(QStringLiteral("Next step"));
    m_open->click(QStringLiteral("Hint 1"));
    m_open->typeCell(0, CircleTableModel::VelocityY, QStringLiteral("0.5"));
    const Preset edited = m_open->preset();
    reopen();
    QCOMPARE(m_open->bench.current(), 1);
    QVERIFY(m_open->preset() == edited);
    QVERIFY(m_open->isTicked(0) && !m_open->isTicked(1));
    QCOMPARE(m_open->bench.progress().hintsOpened(), 1);
    QVERIFY(m_open->button(QStringLiteral("Hint 2")));
    QVERIFY2(m_open->window.notice().isHidden(), "this is not the first start");
    m_open->bench.openTaskAt(0);
    QCOMPARE(m_open->preset().circles[0].body.velocity.x, 2.0);
    // The verdict is kept with its time and the commit message.
    QVERIFY(m_open->says(QStringLiteral("You have passed this step")));
    const QDateTime when = m_open->bench.progress().pass().when;
    QVERIFY(std::abs(when.secsTo(QDateTime::currentDateTimeUtc())) < 300);
    QVERIFY(
        m_open->says(when.toLocalTime().toString(QStringLiteral("'on 'yyyy-MM-dd' at 'HH:mm"))));
    QVERIFY(m_open->says(QStringLiteral("L42T1 Set my circle moving off to the right")));
}

/// Also what was done in the moment before.
void TestMainWindowLab::progressSurvivesOpeningALab()
{
    m_open->typeCell(0, CircleTableModel::VelocityX, QStringLiteral("2"));
    QVERIFY(!m_open->bench.openLab(QLatin1String(shippedLab), QStringLiteral("en")));
    QCOMPARE(m_open->preset().circles[0].body.velocity.x, 2.0);
}

void TestMainWindowLab::brokenProgressGivesANoticeAndIsKept()
{
    m_open->window.close();
    m_open.reset();
    const QByteArray broken = "{ this was a semester's work";
    QFile file(m_folder->filePath(QStringLiteral("progress.json")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(broken);
    file.close();
    reopen();
    QCOMPARE(m_open->bench.current(), 0);
    QVERIFY(m_open->window.notice().isVisible());
    QVERIFY2(m_open->window.notice().text().contains(QStringLiteral("progress")),
             qPrintable(m_open->window.notice().text()));
    QVERIFY(!m_open->window.notice().text().contains(QStringLiteral("Read the step")));
    QFile kept(m_folder->filePath(QStringLiteral("progress.json.unreadable")));
    QVERIFY(kept.open(QIODevice::ReadOnly));
    QCOMPARE(kept.readAll(), broken);
}

void TestMainWindowLab::stepsAreChosenFromTheListAndByKeys()
{
    QListWidget *list = m_open->steps();
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(2)).center());
    QCOMPARE(m_open->bench.current(), 2);
    m_open->press(Qt::Key_PageDown, Qt::ControlModifier);
    QCOMPARE(m_open->bench.current(), 3);
    m_open->press(Qt::Key_PageUp, Qt::ControlModifier);
    m_open->press(Qt::Key_PageUp, Qt::ControlModifier);
    QCOMPARE(m_open->bench.current(), 1);
    QVERIFY(!m_open->simulation().isRunning());
}

QTEST_MAIN(TestMainWindowLab)
#include "test_main_window_lab.moc"
