// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_task_pane.h"
#include "tests/patience.h"
#include "views/task_pane/questions_card.h"

#include <QCheckBox>
#include <QJsonArray>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QSignalSpy>

#include <memory>

using namespace cradle;

/// The questions of a step that count, where the student answers them.
class TestQuestionsCard final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(ThemeChoice::Light); }
    void init();
    void cleanup() { m_open.reset(); }
    void stepWithoutQuestionsHasNoCard();
    void numberIsTyped();
    void oneAnswerIsChosen();
    void severalAnswersAreChosenByKeys();
    void orderIsMadeByKeys();
    void textIsTyped();
    void answersComeBackUntold();

private:
    [[nodiscard]] QuestionsCard *card() const { return m_open->pane.findChild<QuestionsCard *>(); }
    template <typename Widget>
    [[nodiscard]] Widget *field(const char *name) const
    {
        return card()->findChild<Widget *>(QLatin1String(name));
    }
    [[nodiscard]] QJsonValue last() const { return m_told->last()[1].value<QJsonValue>(); }

    std::unique_ptr<OpenTaskPane> m_open;
    std::unique_ptr<QSignalSpy> m_told;
};

void TestQuestionsCard::init()
{
    using Kind = Question::Kind;
    const QStringList three{QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")};
    m_open = std::make_unique<OpenTaskPane>();
    QVERIFY(m_open->show());
    Task task = m_open->lab.tasks[1];
    const auto add = [&](const char *id, Kind kind) {
        const bool chosen = kind != Kind::Number && kind != Kind::Text;
        task.questions.push_back({.id = QLatin1String(id),
                                  .kind = kind,
                                  .title = QStringLiteral("About %1").arg(QLatin1String(id)),
                                  .text = QStringLiteral("What of *it*?"),
                                  .answers = chosen ? three : QStringList(),
                                  .unit = kind == Kind::Number ? QStringLiteral("m/s") : QString(),
                                  .points = kind == Kind::Text ? 3.0 : 1.0});
    };
    add("speed", Kind::Number);
    add("one", Kind::One);
    add("several", Kind::Several);
    add("order", Kind::Order);
    add("why", Kind::Text);
    m_open->pane.showTask(task, 0);
    m_open->pane.setAnswers({});
    QCoreApplication::processEvents();
    m_told = std::make_unique<QSignalSpy>(&m_open->pane, &TaskPane::answered);
}

void TestQuestionsCard::stepWithoutQuestionsHasNoCard()
{
    QVERIFY(card()->isVisible());
    QVERIFY(m_open->says(QStringLiteral("About why (3 points)")));
    m_open->pane.showTask(m_open->lab.tasks[0], 0);
    QVERIFY(!card()->isVisible());
}

void TestQuestionsCard::numberIsTyped()
{
    auto *line = field<QLineEdit>("answer-speed");
    line->setFocus();
    QTest::keyClicks(line, QStringLiteral("9.9 m/s"));
    QCOMPARE(m_told->last()[0].toString(), QStringLiteral("speed"));
    QCOMPARE(last(), QJsonValue(QStringLiteral("9.9 m/s")));
    line->clear();
    QTest::keyClicks(line, QStringLiteral(" "));
    QCOMPARE(last(), QJsonValue(QString()));
}

void TestQuestionsCard::oneAnswerIsChosen()
{
    const auto click = [](QRadioButton *button) {
        button->setFocus(); // which brings it in sight
        QTRY_VERIFY(button->visibleRegion().boundingRect().height() > 12); // laid out
        QTest::mouseClick(button, Qt::LeftButton, {}, QPoint(6, 8));
    };
    click(field<QRadioButton>("answer-one-2"));
    QVERIFY(!m_told->isEmpty());
    QCOMPARE(last(), QJsonValue(2));
    click(field<QRadioButton>("answer-one-3"));
    QCOMPARE(last(), QJsonValue(3));
    QVERIFY(!field<QRadioButton>("answer-one-2")->isChecked());
}

void TestQuestionsCard::severalAnswersAreChosenByKeys()
{
    for (const char *name : {"answer-several-3", "answer-several-1"}) {
        auto *box = field<QCheckBox>(name);
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Space);
    }
    QCOMPARE(last(), QJsonValue(QJsonArray{1, 3}));
}

void TestQuestionsCard::orderIsMadeByKeys()
{
    auto *list = field<QListWidget>("answer-order");
    QCOMPARE(list->count(), 3);
    list->setFocus();
    QVERIFY(m_told->isEmpty());
    // Into the order a, b, c: each in turn goes up to its place.
    for (int place = 0; place < 3; ++place) {
        int at = place;
        while (list->item(at)->text() != QString(QChar(u'a' + place)))
            ++at;
        list->setCurrentRow(at);
        for (; at > place; --at)
            QTest::keyClick(list, Qt::Key_Up, Qt::AltModifier);
    }
    QCOMPARE(last(), QJsonValue(QJsonArray{1, 2, 3}));
}

void TestQuestionsCard::textIsTyped()
{
    auto *text = field<QPlainTextEdit>("answer-why");
    text->setFocus();
    QTest::keyClicks(text, QStringLiteral("It falls."));
    QCOMPARE(last(), QJsonValue(QStringLiteral("It falls.")));
    QTest::keyClick(text, Qt::Key_Tab);
    QVERIFY(!text->hasFocus());
}

void TestQuestionsCard::answersComeBackUntold()
{
    m_open->pane.setAnswers({{QStringLiteral("speed"), QStringLiteral("1 m/s")},
                             {QStringLiteral("one"), 1},
                             {QStringLiteral("several"), QJsonArray{2}},
                             {QStringLiteral("order"), QJsonArray{3, 1, 2}},
                             {QStringLiteral("why"), QStringLiteral("So.")}});
    QVERIFY(m_told->isEmpty());
    QCOMPARE(field<QLineEdit>("answer-speed")->text(), QStringLiteral("1 m/s"));
    QVERIFY(field<QRadioButton>("answer-one-1")->isChecked());
    QVERIFY(field<QCheckBox>("answer-several-2")->isChecked());
    QCOMPARE(field<QListWidget>("answer-order")->item(0)->text(), QStringLiteral("c"));
    QCOMPARE(field<QPlainTextEdit>("answer-why")->toPlainText(), QStringLiteral("So."));
    m_open->pane.setAnswers({});
    QVERIFY(!field<QRadioButton>("answer-one-1")->isChecked());
    QVERIFY(m_told->isEmpty());
}

QTEST_MAIN(TestQuestionsCard)

#include "test_questions_card.moc"
