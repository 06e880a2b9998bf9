// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/calm.h"
#include "tests/gui/open_task_pane.h"
#include "tests/patience.h"
#include "views/markdown_view.h"
#include "views/task_pane/instructions_pane.h"
#include "views/task_pane/prediction_card.h"

#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>

#include <memory>

using namespace cradle;

/// The question of a step: asked, answered, and shown beside what happens.
class TestPredictionCard final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(ThemeChoice::Light); }
    void init();
    void cleanup() { m_open.reset(); }
    void stepWithoutAQuestionHasNoCard();
    void standsBeforeTheFirstSection();
    void isAnsweredByTheMouse();
    void isAnsweredByKeys();
    void keepsTheFocusWhenItsAnswerComesBack();
    void saysThatTheSceneHasRun();
    void showsTheAnswerBesideWhatHappens_data();
    void showsTheAnswerBesideWhatHappens();
    void forgetsAnAnswerThatIsNoneAnyMore();
    void comesInSightWhenItIsRevealed();
    void longAnswersFitTheNarrowestPane();

private:
    void ask();
    [[nodiscard]] PredictionCard *card() const
    {
        return m_open->pane.findChild<PredictionCard *>();
    }
    [[nodiscard]] QList<QRadioButton *> radios() const;
    [[nodiscard]] QString text() const;

    std::unique_ptr<OpenTaskPane> m_open;
    Task m_task;
};

void TestPredictionCard::init()
{
    m_open = std::make_unique<OpenTaskPane>();
    QVERIFY(m_open->show());
    m_task = m_open->lab.tasks[1];
    m_task.instructions =
        QStringLiteral("# Head\n\nIntroduction.\n\n```\n## no heading\n```\n\n## Do\n\nRun it.\n");
    m_task.prediction = Prediction{.question = QStringLiteral("Up or *down*?"),
                                   .answers = {QStringLiteral("up"), QStringLiteral("down")},
                                   .right = 1,
                                   .outcome = QStringLiteral("It falls.")};
}

void TestPredictionCard::ask()
{
    m_open->pane.showTask(m_task, 0);
    m_open->pane.setGuess({});
    QCoreApplication::processEvents();
}

QList<QRadioButton *> TestPredictionCard::radios() const
{
    QList<QRadioButton *> shown;
    for (auto *radio : card()->findChildren<QRadioButton *>()) {
        if (radio->isVisible())
            shown.append(radio);
    }
    return shown;
}

/// All that can be read in the card.
QString TestPredictionCard::text() const
{
    QStringList parts;
    for (const auto *label : card()->findChildren<QLabel *>()) {
        if (label->isVisible())
            parts.append(label->text());
    }
    for (const auto *view : card()->findChildren<MarkdownView *>()) {
        if (view->isVisible())
            parts.append(view->toPlainText());
    }
    return parts.join(QLatin1Char('\n'));
}

void TestPredictionCard::stepWithoutAQuestionHasNoCard()
{
    QVERIFY(!card()->isVisible());
    ask();
    QVERIFY(card()->isVisible());
    m_open->pane.showTask(m_open->lab.tasks[1], 0);
    QVERIFY(!card()->isVisible());
    QVERIFY(
        m_open->pane.findChild<MarkdownView *>()->toPlainText().contains(QStringLiteral("Text")));
}

void TestPredictionCard::standsBeforeTheFirstSection()
{
    ask();
    QList<MarkdownView *> texts;
    for (auto *view : m_open->pane.findChildren<MarkdownView *>()) {
        if (view->isVisible() && view->accessibleName() == QLatin1String("Instructions"))
            texts.append(view);
    }
    QCOMPARE(texts.size(), 2);
    QVERIFY(texts[0]->toPlainText().trimmed().endsWith(QStringLiteral("## no heading")));
    QVERIFY(texts[1]->toPlainText().startsWith(QStringLiteral("Do")));
    QVERIFY(texts[0]->geometry().bottom() < card()->geometry().top());
    QVERIFY(card()->geometry().bottom() < texts[1]->geometry().top());
}

void TestPredictionCard::isAnsweredByTheMouse()
{
    ask();
    QSignalSpy answered(&m_open->pane, &TaskPane::predicted);
    QCOMPARE(radios().size(), 3);
    QTest::mouseClick(radios()[1], Qt::LeftButton, {}, QPoint(6, 8));
    QCOMPARE(answered.size(), 1);
    QCOMPARE(answered[0][0].toInt(), 1);
    // The text belongs to the answer, too.
    for (auto *label : card()->findChildren<QLabel *>()) {
        if (label->isVisible() && label->text() == QLatin1String("Not sure"))
            QTest::mouseClick(label, Qt::LeftButton);
    }
    QCOMPARE(answered.size(), 2);
    QCOMPARE(answered[1][0].toInt(), Guess::notSure);
    QVERIFY(radios()[2]->isChecked() && !radios()[1]->isChecked());
}

void TestPredictionCard::isAnsweredByKeys()
{
    ask();
    QSignalSpy answered(&m_open->pane, &TaskPane::predicted);
    QVERIFY(QTest::qWaitForWindowActive(&m_open->pane, patience));
    radios()[0]->setFocus(Qt::TabFocusReason);
    QTest::keyClick(radios()[0], Qt::Key_Space);
    QCOMPARE(answered.size(), 1);
    QCOMPARE(answered[0][0].toInt(), 0);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Down);
    QCOMPARE(QApplication::focusWidget(), radios()[1]);
    QCOMPARE(answered.back()[0].toInt(), 1);
    QCOMPARE(radios()[1]->accessibleName(), QStringLiteral("down"));
    m_open->pane.setGuess({.answer = 1});
    QVERIFY(text().contains(QStringLiteral("Kept.")));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QVERIFY(QApplication::focusWidget());
    QCOMPARE(QApplication::focusWidget()->accessibleName(), QStringLiteral("Show what happens"));
    QSignalSpy asked(&m_open->pane, &TaskPane::outcomeRequested);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    QCOMPARE(asked.size(), 1);
}

void TestPredictionCard::keepsTheFocusWhenItsAnswerComesBack()
{
    ask();
    connect(&m_open->pane, &TaskPane::predicted, &m_open->pane,
            [this](int answer) { m_open->pane.setGuess({.answer = answer}); });
    QRadioButton *first = radios()[0];
    first->setFocus();
    QTest::keyClick(first, Qt::Key_Space);
    QVERIFY(first->hasFocus() && first->isChecked());
    m_open->pane.setGuess({.answer = 0, .watched = true});
    QVERIFY(first->hasFocus() && first->isChecked());
}

void TestPredictionCard::saysThatTheSceneHasRun()
{
    ask();
    QVERIFY(text().contains(QStringLiteral("Choose before you run the scene.")));
    QVERIFY(!m_open->button(QStringLiteral("Show what happens")));
    m_open->pane.setGuess({.watched = true});
    QVERIFY(text().contains(QStringLiteral("The scene has run already. What did you expect?")));
    QCOMPARE(radios().size(), 3);
    QVERIFY(m_open->button(QStringLiteral("Show what happens")));
    QVERIFY(!text().contains(QStringLiteral("It falls.")));
}

void TestPredictionCard::showsTheAnswerBesideWhatHappens_data()
{
    QTest::addColumn<int>("answer");
    QTest::addColumn<QString>("own");
    QTest::newRow("right") << 1 << QStringLiteral("✓ You predicted: down");
    QTest::newRow("wrong") << 0 << QStringLiteral("You predicted: up");
    QTest::newRow("not sure") << int(Guess::notSure) << QStringLiteral("You were not sure.");
    QTest::newRow("not asked") << -2 << QString();
}

void TestPredictionCard::showsTheAnswerBesideWhatHappens()
{
    QFETCH(int, answer);
    QFETCH(QString, own);
    ask();
    Guess guess{.watched = true, .revealed = true};
    if (answer >= Guess::notSure)
        guess.answer = answer;
    m_open->pane.setGuess(guess);
    const QStringList lines = text().split(QLatin1Char('\n'));
    QVERIFY(lines.contains(QStringLiteral("What happens: down. It falls.")));
    QVERIFY(lines.contains(QStringLiteral("Up or down?")));
    QCOMPARE(lines.contains(own), !own.isEmpty());
    QCOMPARE(lines.filter(QStringLiteral("You ")).size(), own.isEmpty() ? 0 : 1);
    QVERIFY(radios().isEmpty());
    QVERIFY(!m_open->button(QStringLiteral("Show what happens")));
}

void TestPredictionCard::forgetsAnAnswerThatIsNoneAnyMore()
{
    ask();
    m_open->pane.setGuess({.answer = 3});
    for (const QRadioButton *radio : radios())
        QVERIFY(!radio->isChecked());
    m_open->pane.setGuess({.answer = 3, .revealed = true});
    QVERIFY(!text().contains(QStringLiteral("You predicted")));
}

void TestPredictionCard::comesInSightWhenItIsRevealed()
{
    m_task.instructions += QStringLiteral("\n\nText.\n").repeated(60);
    ask();
    const auto *scroll = m_open->pane.findChild<InstructionsPane *>()->findChild<QScrollArea *>();
    scroll->verticalScrollBar()->setValue(scroll->verticalScrollBar()->maximum());
    QVERIFY(card()->visibleRegion().isEmpty());
    m_open->pane.setGuess({.answer = 1, .revealed = true});
    QTRY_VERIFY(!card()->visibleRegion().isEmpty());
    // What was known before does not pull the text away.
    m_open->pane.showTask(m_task, 0);
    m_open->pane.setGuess({.answer = 1, .revealed = true});
    calm(m_open->pane);
    QCOMPARE(scroll->verticalScrollBar()->value(), 0);
}

void TestPredictionCard::longAnswersFitTheNarrowestPane()
{
    m_task.prediction->answers[0] =
        QStringLiteral("to the right below, along the straight line through both of the centres");
    ask();
    m_open->pane.resize(260, 700);
    QCoreApplication::processEvents();
    QCOMPARE(m_open->pane.width(), 260);
    for (const auto *label : card()->findChildren<QLabel *>()) {
        if (!label->isVisible())
            continue;
        QVERIFY(label->mapTo(card(), QPoint(label->width(), 0)).x() <= card()->width());
        QVERIFY2(label->height() >= label->heightForWidth(label->width()),
                 qPrintable(label->text()));
    }
}

QTEST_MAIN(TestPredictionCard)
#include "test_prediction_card.moc"
