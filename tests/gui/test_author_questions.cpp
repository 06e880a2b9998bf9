// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"
#include "tests/gui/open_window.h"
#include "tests/patience.h"

#include "app/author_window.h"
#include "tasks/authoring/lab_edits.h"
#include "tasks/authoring/task_form.h"
#include "views/author/questions_editor.h"

#include <QJsonArray>

using namespace cradle;
using namespace cradle::windows;

/// The questions of a step: written in one window, answered in the other.
class TestAuthorQuestions : public QObject
{
    Q_OBJECT
private slots:
    void questionIsWritten();
    void whatIsNoValueStaysToBeMended();
    void whatIsNoValueIsToldWhenItIsSaved();
    void answersOfAChoiceAreMarked();
    void theLastOfSeveralIsRemoved();
    void studentAnswersWhatWasWritten();
};

namespace {

constexpr int questionsPart = 4;

void openQuestions(OpenAuthor &author, const QTemporaryDir &folder)
{
    openBall(author, folder);
    author.window.panes().showTab(AuthorWindow::Text);
    author.find<QComboBox>("textPart")->setCurrentIndex(questionsPart);
    author.click(QStringLiteral("Add a question"));
}

std::vector<Question> questions(OpenAuthor &author)
{
    return taskForm(author.files(), author.document().step())->questions;
}

} // namespace

void TestAuthorQuestions::questionIsWritten()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openQuestions(author, folder);
    author.fill("questionTitle", QStringLiteral("Speed at the floor"));
    author.fill("questionNumber", QStringLiteral("sqrt(2*9.81*5)"));
    author.fill("questionUnit", QStringLiteral("m/s"));
    author.fill("questionTolerance", QStringLiteral("0.1"));
    author.fill("questionPoints", QStringLiteral("2"));
    author.fill("questionId", QStringLiteral("speed"));
    const auto written = questions(author);
    QCOMPARE(written.size(), std::size_t(1));
    QCOMPARE(written[0].id, QStringLiteral("speed"));
    QCOMPARE(written[0].title, QStringLiteral("Speed at the floor"));
    QCOMPARE(written[0].expression, QStringLiteral("sqrt(2*9.81*5)"));
    QCOMPARE(written[0].unit, QStringLiteral("m/s"));
    QCOMPARE(written[0].tolerance, 0.1);
    QCOMPARE(written[0].points, 2.0);
    for (int i = 0; i < 8 && !questions(author).empty(); ++i)
        author.undo();
    QVERIFY(questions(author).empty());
}

void TestAuthorQuestions::whatIsNoValueStaysToBeMended()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openQuestions(author, folder);
    author.fill("questionUnit", QStringLiteral("furlong"));
    author.fill("questionNumber", QStringLiteral("3"));
    QCOMPARE(author.find<QLineEdit>("questionUnit")->text(), QStringLiteral("furlong"));
    QCOMPARE(questions(author)[0].number, 3.0);
    QVERIFY(questions(author)[0].unit.isEmpty()
            || questions(author)[0].unit != QLatin1String("furlong"));
    author.click(QStringLiteral("Add a question"));
    author.find<QListWidget>("questions")->setCurrentRow(0);
    QCOMPARE(author.find<QLineEdit>("questionUnit")->text(), QStringLiteral("furlong"));
}

/// As of checks; and no more of a question that is gone.
void TestAuthorQuestions::whatIsNoValueIsToldWhenItIsSaved()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openQuestions(author, folder);
    author.fill("questionUnit", QStringLiteral("furlong"));
    QVERIFY(author.window.files().save());
    QVERIFY2(author.window.notice().text().contains(QStringLiteral("BALL1/question")),
             qPrintable(author.window.notice().text()));
    author.click(QStringLiteral("Remove the question"));
    QVERIFY(author.window.panes().refused().isEmpty());
    author.click(QStringLiteral("Add a question"));
    QCOMPARE(author.find<QLineEdit>("questionUnit")->text(), QString());
}

void TestAuthorQuestions::answersOfAChoiceAreMarked()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openQuestions(author, folder);
    author.pick("questionKind", QStringLiteral("several"));
    auto *answers = author.find<QListWidget>("questionAnswers");
    QCOMPARE(answers->count(), 2);
    author.click(QStringLiteral("Add an answer"));
    author.typeInPlace(answers, QStringLiteral("energy"));
    answers->item(2)->setCheckState(Qt::Checked);
    QCOMPARE(questions(author)[0].answers[2], QStringLiteral("energy"));
    QCOMPARE(questions(author)[0].chosen, (std::vector<int>{0, 2}));
    author.pick("questionKind", QStringLiteral("one"));
    answers->item(1)->setCheckState(Qt::Checked); // the mark moves
    QCOMPARE(questions(author)[0].chosen, std::vector<int>{1});
    QCOMPARE(answers->item(0)->checkState(), Qt::Unchecked);
}

/// The form goes on with the question before it. (It once looked for the one that was gone.)
void TestAuthorQuestions::theLastOfSeveralIsRemoved()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openQuestions(author, folder);
    author.fill("questionTitle", QStringLiteral("First"));
    author.click(QStringLiteral("Add a question"));
    author.fill("questionTitle", QStringLiteral("Second"));
    author.click(QStringLiteral("Remove the question"));
    QCOMPARE(questions(author).size(), std::size_t(1));
    QCOMPARE(author.find<QListWidget>("questions")->currentRow(), 0);
    QCOMPARE(author.find<QLineEdit>("questionTitle")->text(), QStringLiteral("First"));
    QVERIFY(!author.button(QStringLiteral("Move the question up"))->isEnabled());
    author.click(QStringLiteral("Remove the question"));
    QVERIFY(questions(author).empty());
    QVERIFY(!author.find<QLineEdit>("questionTitle")->isVisible());
}

void TestAuthorQuestions::studentAnswersWhatWasWritten()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openQuestions(author, folder);
    author.fill("questionId", QStringLiteral("speed"));
    author.fill("questionNumber", QStringLiteral("9.9"));
    author.fill("questionUnit", QStringLiteral("m/s"));
    QVERIFY(!author.document().save());
    OpenWindow student(folder);
    QVERIFY(!student.bench.openLab(author.document().folder(), QStringLiteral("en")));
    const auto field = [&] {
        return student.window.findChild<QLineEdit *>(QStringLiteral("answer-speed"));
    };
    QTRY_VERIFY(field() && field()->isVisible()); // that of another language is gone by then
    QLineEdit *line = field();
    line->setFocus();
    QTest::keyClicks(line, QStringLiteral("9.9 km/h"));
    QCOMPARE(student.bench.progress().answers().value(QStringLiteral("speed")),
             QJsonValue(QStringLiteral("9.9 km/h")));
    student.bench.check().start();
    QTRY_VERIFY(student.bench.check().report());
    QCOMPARE(student.bench.check().report()->checks.back().message,
             QStringLiteral("the number is right, but not in km/h"));
    student.bench.progress().save();
    const QString kept =
        student.bench.code().workspace().folder() + QStringLiteral("/answers.json");
    QFile file(kept);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().contains("9.9 km/h"));
}

QTEST_MAIN(TestAuthorQuestions)

#include "test_author_questions.moc"
