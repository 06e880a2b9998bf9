// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"
#include "tests/patience.h"

#include "app/author_window.h"
#include "tasks/authoring/lab_edits.h"
#include "views/author/remark_editor.h"
#include "views/code/code_editor.h"
#include "views/markdown_view.h"
#include "views/scene/scene_view.h"

using namespace cradle;
using namespace cradle::windows;

/// Fields of a step beside those of the tutorial: titles, how a remark is recognised, the scene
/// that passes without a program.
class TestAuthorFields : public QObject
{
    Q_OBJECT
private slots:
    void stepHasATitleInEachLanguage();
    void newMistakeKeepsItsCommentApart();
    void sceneThatPassesIsMadeEditedAndRemoved();
    void remarkSaysHowItIsRecognised();
    void checkIsWorthAFraction();
    void whatIsTypedGoesWithWhatItIsAbout();
};

namespace {

void openPart(OpenAuthor &author, int part)
{
    author.window.panes().showTab(AuthorWindow::Text);
    author.find<QComboBox>("textPart")->setCurrentIndex(part);
}

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
    author.window.panes().showTab(AuthorWindow::Programs);
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
    author.window.panes().showTab(AuthorWindow::Scene);
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
    author.window.panes().showTab(AuthorWindow::Proof);
    author.click(QStringLiteral("Verify this step"));
    QTRY_VERIFY(!author.window.proofTab().isRunning());
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

void TestAuthorFields::remarkSaysHowItIsRecognised()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    author.window.panes().showTab(AuthorWindow::Programs);
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

    // What cannot be is told and not taken, and stays to be mended.
    author.fill("remarkCircles", QStringLiteral("0"));
    QCOMPARE(remark().circles, std::vector<int>{0});
    QCOMPARE(author.find<QLineEdit>("remarkCircles")->text(), QStringLiteral("0"));
    QCOMPARE(author.window.panes().refused(), {QStringLiteral("BALL1/neat")});

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

/// What the field shows can be typed there, and left there.
void TestAuthorFields::checkIsWorthAFraction()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    author.window.panes().showTab(AuthorWindow::Checks);
    author.fill("checkPoints", QStringLiteral("1/3"));
    QCOMPARE(author.document().form()->checks[0].points, 1.0 / 3.0);
    auto *points = author.find<QLineEdit>("checkPoints");
    QCOMPARE(points->text(), QStringLiteral("1/3"));
    points->setFocus();
    QTest::keyClick(points, Qt::Key_Return);
    QVERIFY(author.window.checksTab().refusedChecks().isEmpty());
}

/// Else it would be told whenever the lab is saved, and nobody could mend it.
void TestAuthorFields::whatIsTypedGoesWithWhatItIsAbout()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    const auto refused = [&] { return author.window.panes().refused(); };
    author.window.panes().showTab(AuthorWindow::Checks);
    author.fill("checkPoints", QStringLiteral("many"));
    const QString first = QStringLiteral("BALL1/") + author.find<QLineEdit>("checkId")->text();
    QCOMPARE(refused(), {first});
    author.click(QStringLiteral("Remove the check"));
    QVERIFY(refused().isEmpty());
    // Of a step it comes back with that.
    author.fill("checkPoints", QStringLiteral("few"));
    QCOMPARE(refused().size(), 1);
    author.click(QStringLiteral("Remove the step"));
    QVERIFY(refused().isEmpty());
    author.document().undoStack().undo();
    QCOMPARE(refused().size(), 1);
}

QTEST_MAIN(TestAuthorFields)
#include "test_author_fields.moc"
