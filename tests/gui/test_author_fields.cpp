// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"

#include "app/author_window.h"
#include "tasks/authoring/lab_edits.h"
#include "views/author/lab_dialog.h"
#include "views/author/remark_editor.h"
#include "views/code/code_editor.h"
#include "views/markdown_view.h"
#include "views/scene/scene_view.h"

#include <QJsonArray>
#include <QLabel>
#include <QRadioButton>

using namespace cradle;
using namespace cradle::windows;

/// Fields of the author's window beside those of the tutorial: the prediction, how a remark is
/// recognised, and what lab.json says of the lab.
class TestAuthorFields : public QObject
{
    Q_OBJECT
private slots:
    void stepHasATitleInEachLanguage();
    void newMistakeKeepsItsCommentApart();
    void sceneThatPassesIsMadeEditedAndRemoved();
    void predictionIsAskedTranslatedAndRemoved();
    void predictionWithoutItsTextsIsNotTaken();
    void remarkSaysHowItIsRecognised();
    void labHasTitlesVersionAndId();
    void labWithoutATitleIsRefused();
    void findingsLeadToTheirFields();
};

namespace {

QString ballFolder()
{
    return QStringLiteral(CRADLE_SOURCE_DIR "/tasks/bouncing-ball");
}

/// A copy of the bouncing ball that may be edited.
void openBall(OpenAuthor &author, const QTemporaryDir &folder)
{
    QVERIFY(!author.window.open(ballFolder()));
    QVERIFY(!author.document().saveAs(folder.filePath(QStringLiteral("ball"))));
    QCOMPARE(author.document().steps().size(), 3);
}

std::optional<Prediction> prediction(OpenAuthor &author, const char *language = "en")
{
    return taskForm(author.files(), author.document().step(), QLatin1String(language))->prediction;
}

void openPart(OpenAuthor &author, int part)
{
    author.window.showTab(AuthorWindow::Text);
    author.find<QComboBox>("textPart")->setCurrentIndex(part);
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

constexpr int predictionPart = 3;

QString titleOf(OpenAuthor &author, const char *language)
{
    return taskForm(author.files(), author.document().step(), QLatin1String(language))->title;
}

} // namespace

void TestAuthorFields::stepHasATitleInEachLanguage()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    const LabFiles before = author.files();
    openPart(author, 0);
    author.fill("stepTitle", QStringLiteral("Let go"));
    author.document().setLanguage(QStringLiteral("de"));
    QVERIFY(author.find<QLineEdit>("stepTitle")->text() != QStringLiteral("Let go"));
    author.fill("stepTitle", QStringLiteral("Loslassen"));
    QCOMPARE(titleOf(author, "en"), QStringLiteral("Let go"));
    QCOMPARE(titleOf(author, "de"), QStringLiteral("Loslassen"));
    QVERIFY(author.find<QListWidget>("authorSteps")
                ->item(0)
                ->text()
                .contains(QStringLiteral("Loslassen")));
    author.undo();
    author.undo();
    QCOMPARE(author.files(), before);
}

/// Else the student would read the first comment of the solution, too.
void TestAuthorFields::newMistakeKeepsItsCommentApart()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    author.window.showTab(AuthorWindow::Programs);
    author.choose(QStringLiteral("A mistake that students make"));
    const QString program = author.window.programsTab().editor().text();
    QVERIFY(program.contains(QStringLiteral("where to look.\n\n-- Bouncing ball.")));
    const QString read = author.window.programsTab().findChild<MarkdownView *>()->toPlainText();
    QVERIFY2(read.contains(QStringLiteral("where to look"))
                 && !read.contains(QStringLiteral("Bouncing")),
             qPrintable(read));
}

void TestAuthorFields::sceneThatPassesIsMadeEditedAndRemoved()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    const QString path = QStringLiteral("BALL1/solution-preset.json");
    const LabFiles before = author.files();
    const Preset start = *presetOf(before, QStringLiteral("BALL1"));
    const Preset passes = *presetOf(before, QStringLiteral("BALL1"), StepPreset::Solution);
    QVERIFY(start != passes);
    author.window.showTab(AuthorWindow::Scene);
    SceneTab &tab = author.window.sceneTab();
    QVERIFY(tab.preset().preset() == start);
    author.find<QComboBox>("whichScene")->setCurrentIndex(1);
    QVERIFY(tab.preset().preset() == passes);

    author.click(QStringLiteral("Remove this scene"));
    QVERIFY(!author.files().contents.contains(path));
    QVERIFY(!tab.scene().isVisible());
    author.click(QStringLiteral("Make it from what the student finds"));
    QVERIFY(tab.scene().isVisible());
    QVERIFY(*presetOf(author.files(), QStringLiteral("BALL1"), StepPreset::Solution) == start);
    Preset falling = tab.preset().preset();
    falling.gravity = {0.0, -9.81};
    QVERIFY(tab.preset().edit(QStringLiteral("gravity"), falling));
    QVERIFY(*presetOf(author.files(), QStringLiteral("BALL1"), StepPreset::Solution) == falling);
    QVERIFY(*presetOf(author.files(), QStringLiteral("BALL1")) == start);

    // What the proof finds of it leads here: by Euler it does not pass.
    author.window.showTab(AuthorWindow::Proof);
    author.click(QStringLiteral("Verify this step"));
    QTRY_VERIFY_WITH_TIMEOUT(!author.window.proofTab().isRunning(), 120'000);
    const VerifiedTask *proof = author.window.proofTab().result();
    QVERIFY(proof && !proof->findings.empty());
    QCOMPARE(proof->findings.front().program, QStringLiteral("solution-preset"));
    author.click(QStringLiteral("Show the run"));
    QVERIFY(tab.preset().isVisiting());
    QVERIFY(tab.preset().preset().gravity.y == -9.81);
    author.click(QStringLiteral("Back to the step's scene"));

    while (author.document().undoStack().canUndo())
        author.document().undoStack().undo();
    QCOMPARE(author.files(), before);
    author.find<QComboBox>("whichScene")->setCurrentIndex(0);
    QVERIFY(tab.preset().preset() == start);
}

void TestAuthorFields::predictionIsAskedTranslatedAndRemoved()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    const LabFiles before = author.files();
    openPart(author, predictionPart);
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

void TestAuthorFields::predictionWithoutItsTextsIsNotTaken()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    openPart(author, predictionPart);
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

void TestAuthorFields::remarkSaysHowItIsRecognised()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    author.window.showTab(AuthorWindow::Programs);
    author.choose(QStringLiteral("A remark on work that passes"));
    author.typeInPlace(author.find<QListWidget>("programs"), QStringLiteral("neat"));
    auto *below = author.find<QTabWidget>("belowProgram");
    QVERIFY(below->isVisible() && below->isTabVisible(1));
    below->setCurrentIndex(1);
    const LabFiles before = author.files();
    const auto remark = [&] {
        return taskForm(author.files(), author.document().step())->remarks.back();
    };
    QCOMPARE(remark().id, QStringLiteral("neat"));
    QCOMPARE(remark().compare, QStringLiteral("velocities"));

    author.pick("remarkCompare", QStringLiteral("positions"));
    author.fill("remarkCircles", QStringLiteral("1"));
    auto *form = author.window.findChild<RemarkEditor *>();
    auto *kind = form->findChild<QComboBox *>(QStringLiteral("sceneKind"));
    kind->setCurrentIndex(kind->findData(QStringLiteral("flight")));
    emit kind->activated(kind->currentIndex());
    auto *count = form->findChild<QLineEdit *>(QStringLiteral("count"));
    QVERIFY(count);
    QTest::keyClicks(count, QStringLiteral("3"));
    QCOMPARE(remark().compare, QStringLiteral("positions"));
    QCOMPARE(remark().circles, std::vector<int>{0});
    QCOMPARE(remark().scene, (QJsonObject{{QStringLiteral("kind"), QStringLiteral("flight")},
                                          {QStringLiteral("count"), 3}}));

    // What cannot be is told, and not taken.
    author.fill("remarkCircles", QStringLiteral("0"));
    QCOMPARE(remark().circles, std::vector<int>{0});
    QCOMPARE(author.find<QLineEdit>("remarkCircles")->text(), QStringLiteral("1"));

    while (author.files() != before) {
        QVERIFY(author.document().undoStack().canUndo());
        author.document().undoStack().undo();
    }
    QCOMPARE(author.find<QComboBox>("remarkCompare")->currentData().toString(),
             QStringLiteral("velocities"));
    // A mistake is recognised by what it does: there is nothing to say.
    author.window.programsTab().openProgram(QStringLiteral("mistakes/thrown.lua"));
    QVERIFY(below->isVisible() && !below->isTabVisible(1));
}

void TestAuthorFields::labHasTitlesVersionAndId()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    const LabFiles before = author.files();
    OpenAuthor::inDialog<LabDialog>([](LabDialog *dialog) {
        const auto write = [dialog](const char *name, const QString &text) {
            auto *line = dialog->findChild<QLineEdit *>(QLatin1String(name));
            line->setFocus();
            line->selectAll();
            QTest::keyClicks(line, text);
        };
        write("labTitle.en", QStringLiteral("Super ball"));
        write("labTitle.de", QStringLiteral("Flummi"));
        write("labVersion", QStringLiteral("1.1"));
        write("labId", QStringLiteral("super-ball"));
        QTest::keyClick(dialog->findChild<QLineEdit *>(QStringLiteral("labId")), Qt::Key_Return);
        return true;
    });
    author.click(QStringLiteral("Title, version and id of the lab"));
    const LabForm own = *labForm(author.files());
    QCOMPARE(own.title, QStringLiteral("Super ball"));
    QCOMPARE(own.version, QStringLiteral("1.1"));
    QCOMPARE(own.id, QStringLiteral("super-ball"));
    QCOMPARE(labForm(author.files(), QStringLiteral("de"))->title, QStringLiteral("Flummi"));
    QTRY_VERIFY(author.window.windowTitle().startsWith(QStringLiteral("Super ball")));
    author.undo(); // all of it was one edit
    QCOMPARE(author.files(), before);
}

void TestAuthorFields::labWithoutATitleIsRefused()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    const LabFiles before = author.files();
    QString said;
    const auto tryOut = [&said](const char *name, const QString &text, const QString &language) {
        OpenAuthor::inDialog<LabDialog>([=, &said](LabDialog *dialog) {
            dialog->findChild<QLineEdit *>(QLatin1String(name))->setText(text);
            auto *list = dialog->findChild<QComboBox *>(QStringLiteral("labLanguage"));
            list->setCurrentIndex(list->findData(language));
            dialog->accept();
            for (const QLabel *label : dialog->findChildren<QLabel *>()) {
                if (label->isVisible() && label->property("kind") == QLatin1String("warning"))
                    said = label->text();
            }
            dialog->reject();
            return true;
        });
    };
    tryOut("labTitle.en", QString(), QStringLiteral("en"));
    author.choose(QStringLiteral("Properties…"));
    QVERIFY2(said.contains(QStringLiteral("A title of 1 to 200 characters")), qPrintable(said));
    tryOut("labId", QStringLiteral("two words"), QStringLiteral("en"));
    author.choose(QStringLiteral("Properties…"));
    QVERIFY2(said.contains(QStringLiteral("letters, digits, dots and dashes")), qPrintable(said));
    // German texts are there already, as translations.
    tryOut("labTitle.en", QStringLiteral("Ball"), QStringLiteral("de"));
    author.choose(QStringLiteral("Properties…"));
    QVERIFY2(said.contains(QStringLiteral("translations into this language")), qPrintable(said));
    QCOMPARE(author.files(), before);
}

void TestAuthorFields::findingsLeadToTheirFields()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    LabFiles files = author.files();
    QByteArray &task = files.contents[QStringLiteral("BALL2/task.json")];
    QVERIFY(task.contains("\"right\": 2"));
    task.replace("\"right\": 2", "\"right\": 4");
    QVERIFY(author.document().edit(QStringLiteral("edit"), files));
    author.document().readNow();
    auto *list = author.find<QListWidget>("authorFindings");
    QTRY_COMPARE(list->count(), 1);
    author.window.showTab(AuthorWindow::Scene);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(0)).center());
    QCOMPARE(author.document().step(), QStringLiteral("BALL2"));
    QCOMPARE(author.window.tabs().currentIndex(), int{AuthorWindow::Text});
    QVERIFY(author.find<QLineEdit>("predictionAnswer1")->isVisible());
    // One click on the right answer, and the file is as it was.
    QTest::mouseClick(mark(author, "Answer 2 comes true"), Qt::LeftButton);
    QCOMPARE(prediction(author)->right, 1);
    author.document().readNow();
    QTRY_COMPARE(list->count(), 0);

    // A remark that looks at a circle that is not there.
    files = author.files();
    QByteArray &remarked = files.contents[QStringLiteral("BALL2/task.json")];
    const auto at = remarked.indexOf("\"compare\": \"velocities\", \"circles\": [1]");
    QVERIFY(at > 0);
    remarked.replace("\"compare\": \"velocities\", \"circles\": [1]",
                     "\"compare\": \"velocities\", \"circles\": [3]");
    QVERIFY(author.document().edit(QStringLiteral("edit"), files));
    author.document().readNow();
    QTRY_VERIFY(list->count() >= 1);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(0)).center());
    QCOMPARE(author.window.tabs().currentIndex(), int{AuthorWindow::Programs});
    QVERIFY(author.find<QLineEdit>("remarkCircles")->isVisible());
    QCOMPARE(author.find<QLineEdit>("remarkCircles")->text(), QStringLiteral("3"));
}

QTEST_MAIN(TestAuthorFields)
#include "test_author_fields.moc"
