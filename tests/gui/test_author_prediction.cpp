// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"
#include "tests/patience.h"

#include "app/author_window.h"
#include "tasks/authoring/lab_edits.h"
#include "tests/test_paths.h"
#include "views/task_pane/prediction_card.h"

#include <QLabel>
#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>

using namespace cradle;
using namespace cradle::windows;

/// The prediction of a step as a form: what is typed there, and where it stands for the student.
class TestAuthorPrediction : public QObject
{
    Q_OBJECT
private slots:
    void predictionIsAskedTranslatedAndRemoved();
    void predictionWithoutItsTextsIsNotTaken();
    void predictionStandsWhereTheStudentFindsIt();
};

namespace {

constexpr int predictionPart = 3;

std::optional<Prediction> prediction(OpenAuthor &author, const char *language = "en")
{
    return taskForm(author.files(), author.document().step(), QLatin1String(language))->prediction;
}

void openPrediction(OpenAuthor &author)
{
    author.window.panes().showTab(AuthorWindow::Text);
    author.find<QComboBox>("textPart")->setCurrentIndex(predictionPart);
}

void retype(QPlainTextEdit *text, const QString &words)
{
    QVERIFY(text->isVisible());
    text->setFocus();
    text->selectAll();
    QTest::keyClicks(text, words);
}

QRadioButton *mark(OpenAuthor &author, const char *name)
{
    return qobject_cast<QRadioButton *>(author.button(QLatin1String(name)));
}

} // namespace

void TestAuthorPrediction::predictionIsAskedTranslatedAndRemoved()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    const LabFiles before = author.files();
    openPrediction(author);
    author.click(QStringLiteral("Remove the prediction"));
    QVERIFY(!prediction(author) && !prediction(author, "de"));

    author.click(QStringLiteral("Ask for a prediction"));
    retype(author.find<MarkdownEditor>("predictionQuestion"), QStringLiteral("How far?"));
    // By Tab past the mark of what comes true.
    QTest::keyClick(author.focus(), Qt::Key_Tab);
    QTest::keyClick(author.focus(), Qt::Key_Tab);
    QCOMPARE(author.focus(), author.find<QLineEdit>("predictionAnswer1"));
    QTest::keyClicks(author.focus(), QStringLiteral("2 m"));
    author.fill("predictionAnswer2", QStringLiteral("4 m"));
    author.click(QStringLiteral("Add an answer"));
    author.fill("predictionAnswer3", QStringLiteral("8 m"));
    QTest::mouseClick(mark(author, "Answer 2 comes true"), Qt::LeftButton);
    retype(author.find<MarkdownEditor>("predictionOutcome"), QStringLiteral("It is 4 m."));
    const Prediction wanted{
        .question = QStringLiteral("How far?"),
        .answers = {QStringLiteral("2 m"), QStringLiteral("4 m"), QStringLiteral("8 m")},
        .right = 1,
        .outcome = QStringLiteral("It is 4 m.")};
    QVERIFY(*prediction(author) == wanted);
    author.document().readNow();
    QVERIFY(author.document().lab().findings.empty());
    QVERIFY(*author.document().task()->prediction == wanted);

    // Beside the form stands what the student sees: the answers, and "not sure".
    QStringList shown;
    for (const QRadioButton *answer : author.window.textTab().findChildren<QRadioButton *>()) {
        if (answer->isVisible())
            shown.append(answer->accessibleName());
    }
    QVERIFY(shown.contains(QStringLiteral("8 m")));

    // In German: the texts alone. An answer that goes is gone in both languages.
    author.document().setLanguage(QStringLiteral("de"));
    retype(author.find<MarkdownEditor>("predictionQuestion"), QStringLiteral("Wie weit?"));
    QCOMPARE(prediction(author, "de")->question, QStringLiteral("Wie weit?"));
    QCOMPARE(prediction(author)->question, QStringLiteral("How far?"));
    author.click(QStringLiteral("Remove answer 1"));
    QCOMPARE(prediction(author)->answers,
             (QStringList{QStringLiteral("4 m"), QStringLiteral("8 m")}));
    QCOMPARE(prediction(author, "de")->answers, prediction(author)->answers);
    QCOMPARE(prediction(author)->right, 0);
    QVERIFY(!author.button(QStringLiteral("Remove answer 1"))->isEnabled()); // two are the fewest

    while (author.document().undoStack().canUndo())
        author.document().undoStack().undo();
    QCOMPARE(author.files(), before);
    QVERIFY(author.find<QLineEdit>("predictionAnswer1")->isVisible());
}

void TestAuthorPrediction::predictionWithoutItsTextsIsNotTaken()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    openPrediction(author);
    const LabFiles before = author.files();
    auto *answer = author.find<QLineEdit>("predictionAnswer1");
    const QString old = answer->text();
    answer->setFocus();
    answer->selectAll();
    QTest::keyClick(answer, Qt::Key_Delete);
    QVERIFY(answer->property("refused").toBool());
    const auto says = [&](const char *text) {
        for (const QLabel *label : author.window.findChildren<QLabel *>()) {
            if (label->isVisible() && label->text().contains(QLatin1String(text)))
                return true;
        }
        return false;
    };
    QVERIFY(says("An answer of 1 to 100 characters"));
    QCOMPARE(author.files(), before);
    QTest::keyClicks(answer, QStringLiteral("x"));
    QVERIFY(!answer->property("refused").toBool());
    QVERIFY(!says("An answer of 1 to 100 characters"));
    QCOMPARE(prediction(author)->answers.front(), QStringLiteral("x"));
    author.undo();
    QCOMPARE(answer->text(), old);
    QCOMPARE(author.files(), before);
}

/// In the preview: between the introduction and the first section, and the author can try it.
void TestAuthorPrediction::predictionStandsWhereTheStudentFindsIt()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    const Result<LabFiles> lab = readLabFiles(sourcePath("tasks/labs/lab-4.2"));
    QVERIFY(lab);
    author.document().begin(*lab);
    author.document().setStep(QStringLiteral("L42T12"));
    author.window.panes().showTab(AuthorWindow::Text);
    InstructionsPane &student = author.window.textTab().student();
    auto *card = student.findChild<PredictionCard *>();
    QVERIFY(card);
    QTRY_VERIFY(textShown(student).contains(QStringLiteral("Do\n")));
    QVERIFY(card->isVisible());
    const auto views = student.findChildren<MarkdownView *>();
    const auto top = [&](const QWidget *widget) { return widget->mapTo(&student, QPoint()).y(); };
    const auto first = std::find_if(views.begin(), views.end(), [](const MarkdownView *view) {
        return view->toPlainText().contains(QStringLiteral("Do\n"));
    });
    QVERIFY(first != views.end());
    QTRY_VERIFY(top(*first) > top(card));
    auto *answer = card->findChild<QRadioButton *>();
    QVERIFY(answer);
    answer->click();
    QVERIFY(answer->isChecked());
    // What is written stays in sight: the preview does not jump while one types.
    auto *bar = student.findChild<QScrollArea *>()->verticalScrollBar();
    QTRY_VERIFY(bar->maximum() > 200);
    bar->setValue(150);
    auto *text = author.find<MarkdownEditor>("markdown");
    text->moveCursor(QTextCursor::End);
    QTest::keyClicks(text, QStringLiteral("More."));
    QTRY_VERIFY(textShown(student).contains(QStringLiteral("More.")));
    QTRY_COMPARE(bar->value(), 150);
}

QTEST_MAIN(TestAuthorPrediction)
#include "test_author_prediction.moc"
