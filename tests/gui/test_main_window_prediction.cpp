// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include "tasks/authoring/lab_edits.h"
#include "tests/gui/window_test.h"
#include "tests/patience.h"
#include "views/task_pane/prediction_card.h"

#include <QRadioButton>

using namespace cradle;
using namespace cradle::windows;

/// A prediction in the whole application: asked, kept between starts, and compared.
class TestMainWindowPrediction final : public WindowTest
{
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup() { m_open.reset(); }
    void answerIsKeptBetweenStarts();
    void runIsNotBlockedAndTheQuestionStays();
    void anyMovementOfTheSceneCounts_data();
    void anyMovementOfTheSceneCounts();
    void outcomeIsShownOnRequest();
    void passingTheCheckShowsTheOutcome();
    void failingTheCheckDoesNot();
    void bothModesShareTheAnswer();
    void sceneWithoutAStepAsksNothing();

private:
    void open(const char *step) { QVERIFY(m_open->bench.openTask(QLatin1String(step))); }
    [[nodiscard]] PredictionCard *card()
    {
        return m_open->window.taskPane().findChild<PredictionCard *>();
    }
    [[nodiscard]] QRadioButton *answer(const QString &name)
    {
        return qobject_cast<QRadioButton *>(m_open->button(name));
    }
};

void TestMainWindowPrediction::initTestCase()
{
    setLanguage(QStringLiteral("en"));
    applyTheme(ThemeChoice::Light);
}

void TestMainWindowPrediction::init()
{
    takeNewFolder();
}

void TestMainWindowPrediction::answerIsKeptBetweenStarts()
{
    open("L42T5");
    QRadioButton *higher = answer(QStringLiteral("higher than circle 1"));
    QVERIFY(higher && !higher->isChecked());
    higher->setFocus();
    QTest::keyClick(higher, Qt::Key_Space);
    QVERIFY(!m_open->simulation().isRunning()); // the key was the answer's
    QVERIFY(m_open->bench.progress().guess() == Guess{.answer = 0});
    QTest::keyClick(higher, Qt::Key_Space);
    QVERIFY(m_open->simulation().isRunning()); // the answer has no use for it any more
    m_open->simulation().pause();
    reopen();
    QCOMPARE(m_open->bench.task()->id, QStringLiteral("L42T5"));
    QVERIFY(m_open->bench.progress().guess() == Guess{.answer = 0});
    QVERIFY(answer(QStringLiteral("higher than circle 1"))->isChecked());
    open("L42T10");
    QVERIFY(m_open->bench.progress().guess() == Guess{});
}

void TestMainWindowPrediction::runIsNotBlockedAndTheQuestionStays()
{
    open("L42T5");
    QVERIFY(m_open->says(QStringLiteral("Choose before you run the scene.")));
    m_open->press(Qt::Key_Space);
    QVERIFY(m_open->simulation().isRunning());
    QTRY_VERIFY(m_open->says(QStringLiteral("The scene has run already. What did you expect?")));
    m_open->press(Qt::Key_Space);
    m_open->click(QStringLiteral("lower than circle 1"));
    QVERIFY(m_open->bench.progress().guess() == (Guess{.answer = 2, .watched = true}));
    QVERIFY(!m_open->says(QStringLiteral("You predicted")));
    reopen();
    QVERIFY(m_open->bench.progress().guess() == (Guess{.answer = 2, .watched = true}));
}

void TestMainWindowPrediction::anyMovementOfTheSceneCounts_data()
{
    QTest::addColumn<int>("key");
    QTest::newRow("step") << int(Qt::Key_Right);
    QTest::newRow("next hit") << int(Qt::Key_N);
}

void TestMainWindowPrediction::anyMovementOfTheSceneCounts()
{
    QFETCH(int, key);
    open("L42T10");
    QVERIFY(!m_open->bench.progress().guess().watched);
    m_open->press(key);
    QTRY_VERIFY(m_open->bench.progress().guess().watched);
    // The scene of another step stands at its start.
    open("L42T11");
    QVERIFY(!m_open->bench.progress().guess().watched);
}

void TestMainWindowPrediction::outcomeIsShownOnRequest()
{
    open("L42T10");
    QVERIFY(!m_open->button(QStringLiteral("Show what happens")));
    m_open->click(QStringLiteral("both go on to the right"));
    m_open->click(QStringLiteral("Show what happens"));
    QVERIFY(m_open->says(QStringLiteral("You predicted: both go on to the right with 1")));
    QVERIFY(!answer(QStringLiteral("both go on to the right")));
    reopen();
    QVERIFY(m_open->says(QStringLiteral("You predicted: both go on to the right with 1")));
}

void TestMainWindowPrediction::passingTheCheckShowsTheOutcome()
{
    m_open->click(QStringLiteral("at x = 0"));
    QVERIFY(m_open->bench.document().edit(QStringLiteral("solve"), m_open->solution()));
    m_open->check();
    QVERIFY(m_open->bench.check().report()->passed);
    QVERIFY(m_open->says(QStringLiteral("✓ You predicted: at x = 0")));
    QTRY_VERIFY(!card()->visibleRegion().isEmpty());
}

void TestMainWindowPrediction::failingTheCheckDoesNot()
{
    m_open->click(QStringLiteral("at x = 2 m"));
    m_open->check();
    QVERIFY(!m_open->bench.check().report()->passed);
    QVERIFY(!m_open->says(QStringLiteral("You predicted")));
    QVERIFY(answer(QStringLiteral("at x = 2 m"))->isChecked());
}

void TestMainWindowPrediction::bothModesShareTheAnswer()
{
    open("L42T12");
    m_open->click(QStringLiteral("Not sure"));
    m_open->bench.setMode(Mode::Code);
    QCOMPARE(m_open->bench.progress().guess().answer, std::optional<int>(Guess::notSure));
    QVERIFY(answer(QStringLiteral("Not sure"))->isChecked());
}

void TestMainWindowPrediction::sceneWithoutAStepAsksNothing()
{
    QVERIFY(card()->isVisible());
    QVERIFY(!m_open->bench.openPreset(QStringLiteral(":/labs/lab-4.2/L42T14/preset.json")));
    QVERIFY(!card()->isVisible());
    m_open->press(Qt::Key_Right);
    QVERIFY(m_open->bench.progress().guess() == Guess{});
    const QString plain = m_folder->filePath(QStringLiteral("plain"));
    const LabFiles lab = newLab(QStringLiteral("lab"), QStringLiteral("Lab"), {});
    QVERIFY(!saveLabFiles(lab, {}, plain));
    QVERIFY(!m_open->bench.openLab(plain, QStringLiteral("en")));
    QVERIFY(m_open->bench.task() && !m_open->bench.task()->prediction);
    QVERIFY2(!card()->isVisible(), "this step has no question");
}

QTEST_MAIN(TestMainWindowPrediction)
#include "test_main_window_prediction.moc"
