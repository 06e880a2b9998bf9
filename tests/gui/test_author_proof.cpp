// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"
#include "tests/patience.h"

#include "app/author_window.h"
#include "tasks/authoring/lab_edits.h"
#include "views/author/proof_matrix.h"
#include "views/error_line.h"
#include "views/menu.h"

#include <QJsonArray>

using namespace cradle;
using namespace cradle::windows;

/// What an author sees of a lab that is not as it should be: steps other than the open one, the
/// very run of a check, and the reference program where it sets what the step fixes.
class TestAuthorProof : public QObject
{
    Q_OBJECT
private slots:
    void otherStepsAreToldAndOpened();
    void runOfACheckKeepsItsScene();
    void referenceStopsAtWhatTheStepFixes();
    void proofSaysNoMoreThanItProves();
    void matrixThatIsSeenIsFilledAnew();
};

namespace {

const QString solutionPath = QStringLiteral("BALL3/solution.lua");

/// Makes the ball of step 3 rise too high.
void breakLastStep(OpenAuthor &author)
{
    QString program = textOf(author.files(), solutionPath);
    QVERIFY(program.contains(QStringLiteral("0.5 ^ (1 / 6)")));
    program.replace(QStringLiteral("0.5 ^ (1 / 6)"), QStringLiteral("0.95"));
    QVERIFY(author.document().edit(QStringLiteral("break"),
                                   withText(author.files(), solutionPath, program)));
}

void waitForProof(OpenAuthor &author, const QString &button)
{
    author.window.panes().showTab(AuthorWindow::Proof);
    author.click(button);
    QTRY_VERIFY(!author.window.proofTab().isRunning());
}

} // namespace

void TestAuthorProof::otherStepsAreToldAndOpened()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    auto *others = author.find<QLabel>("otherSteps");
    waitForProof(author, QStringLiteral("Verify the lab"));
    QVERIFY(others->isVisible());
    QCOMPARE(others->text(), QStringLiteral("So it is in every step of the lab."));

    breakLastStep(author);
    waitForProof(author, QStringLiteral("Verify this step"));
    QVERIFY(author.window.proofTab().result()->findings.empty());
    // What was found of step 3 before it was broken is told of it no more.
    QVERIFY2(!others->isVisible(), qPrintable(others->text()));
    waitForProof(author, QStringLiteral("Verify the lab"));
    QVERIFY(author.window.proofTab().result()->findings.empty());
    QVERIFY2(others->text().contains(QStringLiteral(">3 · Half the height</a> (")),
             qPrintable(others->text()));
    emit others->linkActivated(QStringLiteral("BALL3"));
    QCOMPARE(author.document().step(), QStringLiteral("BALL3"));
    QVERIFY(!author.window.proofTab().result()->findings.empty());
    QVERIFY(!others->isVisible());
}

/// The scene of the check begins where it was drawn, whatever on_load sets.
void TestAuthorProof::runOfACheckKeepsItsScene()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    SceneTab &tab = author.window.sceneTab();
    Preset scene = tab.preset().preset();
    scene.circles.front().body.position = {1.5, 1.0};
    const QString program = QStringLiteral("function on_load()\n"
                                           "  circle1.position = vec(0, 0)\n"
                                           "end\n"
                                           "function on_update(timestep)\n"
                                           "end\n");
    author.window.panes().showTab(AuthorWindow::Scene);
    tab.visit({.scene = scene, .pinned = true, .source = program, .step = 1});
    QCOMPARE(tab.simulation().current(), qint64{1});
    QVERIFY(tab.simulation().recording().circles(1).front().position == (Vec2{1.5, 1.0}));
    // It cannot be edited, and that is to be seen.
    const Preset seen = tab.preset().preset();
    QVERIFY(!tab.preset().whyReadOnly().isEmpty());
    Preset other = seen;
    other.restitution = 0.25;
    QVERIFY(!tab.preset().edit(QStringLiteral("edit"), other));
    QVERIFY(tab.preset().preset() == seen);
    tab.preset().leave();
    QVERIFY(tab.preset().whyReadOnly().isEmpty());
}

void TestAuthorProof::referenceStopsAtWhatTheStepFixes()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    author.document().setStep(QStringLiteral("BALL2"));
    author.window.panes().showTab(AuthorWindow::Scene);
    SceneTab &tab = author.window.sceneTab();
    auto *mover = author.find<QComboBox>("mover");
    mover->setCurrentIndex(1);
    emit mover->activated(1);
    auto *line = tab.findChild<ErrorLine *>();
    QVERIFY(!tab.simulation().programError());
    QVERIFY(!line->isVisible());

    for (QAction *action : tab.locks().actions()) {
        if (action->data().toString() == QLatin1String("restitution"))
            action->trigger();
    }
    QVERIFY(tab.simulation().programError());
    QCOMPARE(tab.simulation().programError()->line, 6);
    QVERIFY(line->isVisible());
    QVERIFY(line->text().contains(QStringLiteral("fixed this: restitution")));
    // From there to the line; what is edited there runs here.
    QTest::mouseClick(line, Qt::LeftButton);
    QCOMPARE(author.window.tabs().currentIndex(), int{AuthorWindow::Programs});
    QString program = textOf(author.files(), QStringLiteral("BALL2/solution.lua"));
    program.remove(QStringLiteral("  restitution = 0.8\n"));
    QVERIFY(author.document().edit(
        QStringLiteral("edit"),
        withText(author.files(), QStringLiteral("BALL2/solution.lua"), program)));
    author.window.panes().showTab(AuthorWindow::Scene);
    QVERIFY(!tab.simulation().programError());
    QVERIFY(!line->isVisible());
    QVERIFY(tab.simulation().isProgrammed());
}

/// A check that is missing, and a check that adds nothing, stand beside no "all is as it should
/// be".
void TestAuthorProof::proofSaysNoMoreThanItProves()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    ProofTab &proof = author.window.proofTab();
    waitForProof(author, QStringLiteral("Verify this step"));
    const auto says = [&](const QString &text) {
        for (const auto *label : proof.findChildren<QLabel *>()) {
            if (label->isVisible() && label->text().contains(text))
                return true;
        }
        return false;
    };
    QVERIFY(proof.result()->warnings.empty());
    QVERIFY(says(QStringLiteral("every check is needed")));

    // The same check twice: told, and "needed" is not.
    author.window.panes().showTab(AuthorWindow::Checks);
    author.window.checksTab().duplicateCheck();
    waitForProof(author, QStringLiteral("Verify this step"));
    QVERIFY(says(QStringLiteral("Worth a look")));
    QVERIFY(says(QStringLiteral("asks for the same as")));
    QVERIFY(!says(QStringLiteral("every check is needed")));

    // With a coarse look at the end of the fall alone, changes of the solution pass.
    const QString step = author.document().step();
    TaskForm form = *taskForm(author.files(), step);
    std::erase_if(form.checks,
                  [](const CheckForm &check) { return check.id != QLatin1String("falls"); });
    form.checks[0].kind = QStringLiteral("ends_at");
    form.checks[0].parameters = {
        {QStringLiteral("positions"), QJsonArray{QJsonValue(QJsonArray{0.0, -3.78675})}},
        {QStringLiteral("tolerance"), 0.3}};
    form.checks[0].scene = {{QStringLiteral("kind"), QStringLiteral("own")},
                            {QStringLiteral("duration"), 1.0}};
    LabFiles files = *withTask(author.files(), step, form);
    for (const QString &name : knownNames(files, step, KnownKind::Mistake)) {
        if (name != QLatin1String("never-moved"))
            files = *withKnownRemoved(files, step, KnownKind::Mistake, name);
    }
    QVERIFY(author.document().edit(QStringLiteral("fewer"), files));
    waitForProof(author, QStringLiteral("Verify this step"));
    QVERIFY2(proof.result()->findings.empty(),
             proof.result()->findings.empty() ? ""
                                              : qPrintable(proof.result()->findings[0].message));
    QVERIFY(says(QStringLiteral("All is as it should be")));
    waitForProof(author, QStringLiteral("Suggest mistakes"));
    QVERIFY(says(QStringLiteral("Passes every check, so one is missing")));
    QVERIFY(!says(QStringLiteral("All is as it should be")));
    QVERIFY(says(QStringLiteral("a check is missing")));

    // What is answered goes, and what is left is as old as it says.
    const auto rows = [&] {
        int count = 0;
        for (const auto *button : proof.findChildren<QPushButton *>())
            count += button->isVisible() && button->text() == QStringLiteral("Add as a mistake");
        return count;
    };
    const int before = rows();
    QVERIFY(before > 0);
    author.click(QStringLiteral("Add as a mistake"));
    author.window.panes().showTab(AuthorWindow::Proof);
    QTRY_COMPARE(rows(), before - 1);
    QVERIFY(says(QStringLiteral("before the last edits")));
}

/// Its columns come before their headings do. (Their heights once asked for headings that were not
/// there yet.)
void TestAuthorProof::matrixThatIsSeenIsFilledAnew()
{
    ProofMatrix matrix;
    matrix.resize(700, 300);
    static_cast<QWidget &>(matrix).show();
    QVERIFY(QTest::qWaitForWindowExposed(&matrix, patience));
    const VerifiedTask task{
        .id = QStringLiteral("A"),
        .title = {},
        .checks = {QStringLiteral("first"), QStringLiteral("second")},
        .programs = {{.name = QStringLiteral("solution"), .reports = {CheckReport{}}}}};
    for (const VerifiedTask &shown : {task, VerifiedTask{}, task}) {
        matrix.show(shown);
        QCOMPARE(matrix.columnCount(), shown.programs.empty() ? 0 : 4);
    }
    QCOMPARE(matrix.horizontalHeaderItem(2)->toolTip(), QStringLiteral("Check second"));
}

QTEST_MAIN(TestAuthorProof)
#include "test_author_proof.moc"
