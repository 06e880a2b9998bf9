// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"

#include "app/author_window.h"
#include "tasks/authoring/lab_edits.h"
#include "views/error_line.h"

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
    author.window.showTab(AuthorWindow::Proof);
    author.click(button);
    QTRY_VERIFY_WITH_TIMEOUT(!author.window.proofTab().isRunning(), 120'000);
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
    author.window.showTab(AuthorWindow::Scene);
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
    author.window.showTab(AuthorWindow::Scene);
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
    author.window.showTab(AuthorWindow::Scene);
    QVERIFY(!tab.simulation().programError());
    QVERIFY(!line->isVisible());
    QVERIFY(tab.simulation().isProgrammed());
}

QTEST_MAIN(TestAuthorProof)
#include "test_author_proof.moc"
