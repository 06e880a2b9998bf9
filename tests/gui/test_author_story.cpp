// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"

#include "app/author_window.h"
#include "app/code_desk.h"
#include "tasks/authoring/lab_edits.h"
#include "tasks/judging/judgement.h"
#include "tasks/reading/lab_archive.h"
#include "tasks/values/lab_values.h"
#include "tests/gui/open_window.h"
#include "tests/gui/story_programs.h"
#include "tests/gui/student_of_story.h"
#include "tests/gui/writing_test.h"
#include "tests/patience.h"
#include "views/author/arrangement_dialog.h"
#include "views/code/code_pane.h"

#include <QMenu>
#include <QSpinBox>
#include <QStandardPaths>

using namespace cradle;
using namespace cradle::windows;

/// An author writes a lab of three steps from nothing, and two students do it; everything by
/// widgets, no file by hand. A rack of seven balls; drag with a = −k v, where every student has a k
/// of his own, judged by e^(−kt); a spring, judged by its period and its momentum.
class TestAuthorStory : public WritingTest
{
    Q_OBJECT
private slots:
    void initTestCase();
    void cleanupTestCase();
    void rackIsWritten();
    void dragIsWritten();
    void springIsWritten();
    void labIsProven();
    void labIsExported();
    void editionForStudentsHasNoSolutions();
    void oneStudentPasses();
    void anotherFailsWithTrueFindings();

private:
    QTemporaryDir m_folder;
    QString m_file;
};

void TestAuthorStory::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    QDir(userLabsFolder()).removeRecursively();
    m_author = std::make_unique<OpenAuthor>(m_folder);
    beginLab(*m_author, QStringLiteral("Three laws"));
}

void TestAuthorStory::cleanupTestCase()
{
    m_author.reset();
    QDir(userLabsFolder()).removeRecursively();
}

void TestAuthorStory::rackIsWritten()
{
    retitle("RACK", "Break the rack", story::rackText);
    removeSceneThatPasses();
    // Rows: three, a ball that comes from the left: seven.
    OpenAuthor::inDialog<ArrangementDialog>([](ArrangementDialog *dialog) {
        auto *rows = dialog->findChild<QSpinBox *>(QStringLiteral("arrangementRows"));
        rows->setFocus();
        rows->selectAll();
        QTest::keyClicks(rows, QStringLiteral("3"));
        QTest::keyClick(rows, Qt::Key_Return);
        return true;
    });
    m_author->choose(QStringLiteral("Rack…"));
    QCOMPARE(m_author->window.sceneTab().preset().own().circles.size(), std::size_t(7));
    typeCell(0, CircleTableModel::Y, "1/20");
    QCOMPARE(m_author->window.sceneTab().preset().own().circles[0].body.position.y, 0.05);

    makeOwn("solution.lua", story::rackSolution);
    makeOwn("starter.lua", story::rackStarter);
    removePrograms();
    addMistake("whole-velocity", story::wholeVelocity);
    addMistake("one-sided", story::oneSided);

    m_author->window.panes().showTab(AuthorWindow::Checks);
    m_author->click(QStringLiteral("Remove the check")); // of the template: it falls
    beginCheck("swap", "Two balls swap what goes along the line of centres", "collides", "1, 2");
    m_author->pick("sceneKind", QStringLiteral("encounters"));
    m_author->fill("count", QStringLiteral("8"));
    m_author->fill("offset", QStringLiteral("0.6"));
    beginCheck("momentum", "All seven keep momentum and energy", "script", "1, 2, 3, 4, 5, 6, 7");
    m_author->fill("duration", QStringLiteral("2"));
    writeScript(story::rackCheck);
}

void TestAuthorStory::dragIsWritten()
{
    addStep("Slow it down");
    retitle("DRAG", "Slow it down", story::dragText);
    removeSceneThatPasses();
    typeCell(0, CircleTableModel::X, "-3");
    typeCell(0, CircleTableModel::Y, "0");
    typeCell(0, CircleTableModel::VelocityX, "3");
    // k is another number for every student.
    m_author->choose(QStringLiteral("Values of lab and step"));
    m_author->click(QStringLiteral("Add a value"));
    m_author->fill("valueName", QStringLiteral("k"));
    auto *kind = m_author->find<QComboBox>("valueKind");
    kind->setCurrentIndex(1);
    emit kind->activated(1);
    m_author->fill("valueFrom", QStringLiteral("0.4"));
    m_author->fill("valueTo", QStringLiteral("0.8"));
    m_author->fill("valueStep", QStringLiteral("1/10"));

    makeOwn("solution.lua", story::dragSolution);
    makeOwn("starter.lua", story::dragStarter);
    removePrograms();
    addMistake("square", story::square);
    addMistake("speeds-up", story::speedsUp);
    m_author->window.panes().showTab(AuthorWindow::Checks);
    m_author->click(QStringLiteral("Remove the check"));
    beginCheck("decays", "It slows down as exp(-kt)", "script", "1");
    m_author->fill("duration", QStringLiteral("4"));
    writeScript(story::dragCheck);
}

void TestAuthorStory::springIsWritten()
{
    addStep("A spring");
    retitle("SPRING", "A spring", story::springText);
    removeSceneThatPasses();
    addCircle();
    const char *const numbers[][4] = {{"-3/2", "0", "0", "0"}, {"3/2", "0", "1/2", "0"}};
    const int columns[] = {CircleTableModel::X, CircleTableModel::Y, CircleTableModel::VelocityX,
                           CircleTableModel::VelocityY};
    for (int row = 0; row < 2; ++row) {
        for (int i = 0; i < 4; ++i)
            typeCell(row, columns[i], numbers[row][i]);
    }
    const Preset scene = m_author->window.sceneTab().preset().own();
    QCOMPARE(scene.circles.size(), std::size_t(2));
    QCOMPARE(scene.circles[1].body.position, (Vec2{1.5, 0.0}));

    makeOwn("solution.lua", story::springSolution);
    makeOwn("starter.lua", story::springStarter);
    removePrograms();
    addMistake("no-rest-length", story::noRestLength);
    addMistake("one-end", story::oneEnd);
    m_author->window.panes().showTab(AuthorWindow::Checks);
    m_author->click(QStringLiteral("Remove the check"));
    beginCheck("period", "It swings with the right period", "script", "1, 2");
    m_author->fill("duration", QStringLiteral("6"));
    writeScript(story::periodCheck);
    beginCheck("momentum", "The momentum of both stays", "script", "1, 2");
    m_author->fill("duration", QStringLiteral("6"));
    writeScript(story::momentumCheck);
}

void TestAuthorStory::labIsProven()
{
    for (const char *step : {"RACK", "DRAG", "SPRING"}) {
        auto *list = m_author->find<QListWidget>("authorSteps");
        const auto row = static_cast<int>(m_author->document().steps().indexOf(utf8(step)));
        QVERIFY2(row >= 0, step);
        list->setCurrentRow(row);
        m_author->window.panes().showTab(AuthorWindow::Proof);
        m_author->click(QStringLiteral("Verify this step"));
        QTRY_VERIFY(!m_author->window.proofTab().isRunning());
        const VerifiedTask *proof = m_author->window.proofTab().result();
        QVERIFY(proof);
        QStringList findings;
        for (const LabFinding &finding : proof->findings)
            findings.append(finding.program + QStringLiteral(": ") + finding.message);
        QVERIFY2(findings.isEmpty(), qPrintable(findings.join(QLatin1Char('\n'))));
    }
    m_author->document().readNow();
    QVERIFY(m_author->document().lab().findings.empty());
}

void TestAuthorStory::labIsExported()
{
    OpenAuthor::answerDialog(m_folder.filePath(QStringLiteral("three-laws")));
    m_author->choose(QStringLiteral("Save"));
    QTRY_VERIFY(!m_author->document().isModified());
    m_file = m_folder.filePath(QStringLiteral("lab.cradle"));
    OpenAuthor::answerDialog(m_file);
    m_author->choose(QStringLiteral("Export as one file…"));
    QTRY_VERIFY(QFileInfo::exists(m_file));
}

void TestAuthorStory::editionForStudentsHasNoSolutions()
{
    const QString file = m_folder.filePath(QStringLiteral("students.cradle"));
    OpenAuthor::answerDialog(file);
    m_author->choose(QStringLiteral("Export for students…"));
    QTRY_VERIFY(QFileInfo::exists(file));
    const Result<LabFiles> files = readLabArchive(file);
    QVERIFY(files);
    for (const QString &path : files->contents.keys())
        QVERIFY2(!path.contains(QLatin1String("solution"))
                     && !path.contains(QLatin1String("mistakes")),
                 qPrintable(path));
    // All of its steps have a check in Lua: what that wants as a law nobody can tell.
    QVERIFY2(m_author->window.notice().text().contains(QLatin1String("In RACK, DRAG, SPRING")),
             qPrintable(m_author->window.notice().text()));
    const Result<Lab> lab = readLab(*files, {}, QStringLiteral("en"), QStringLiteral("4711"));
    QVERIFY(lab->findings.empty());
    const Task &rack = lab->tasks.front();
    const auto judged = [&](const char *program) {
        return *judgeTask(*lab, rack, Submission(rack.preset, utf8(program)), 1);
    };
    QVERIFY(judged(story::rackSolution).passed);
    const CheckReport report = judged(story::rackOfAStudent);
    QVERIFY(!report.passed && report.findings.empty());
    QVERIFY(!report.checks.front().message.isEmpty());
}

void TestAuthorStory::oneStudentPasses()
{
    const QTemporaryDir folder;
    OpenWindow student(folder);
    dropLab(student, m_file, "4711");
    handIn(student, "RACK", utf8(story::rackSolution));
    QVERIFY2(student.bench.check().report()->passed, qPrintable(student.bench.code().text()));
    // The number is on the page that he reads.
    const double k = valuesOf(m_author->files(), QStringLiteral("DRAG"), QStringLiteral("4711"))
                         .value(QStringLiteral("k"));
    handIn(student, "DRAG",
           utf8(story::dragSolution).replace(QStringLiteral("{{k}}"), QString::number(k)));
    QVERIFY(student.bench.task()->instructions.contains(QString::number(k)));
    QVERIFY(student.bench.check().report()->passed);
    handIn(student, "SPRING", utf8(story::springSolution));
    QVERIFY(student.bench.check().report()->passed);
    for (int step = 0; step < 3; ++step)
        QVERIFY(student.isTicked(step));
}

void TestAuthorStory::anotherFailsWithTrueFindings()
{
    const QTemporaryDir folder;
    OpenWindow student(folder);
    dropLab(student, m_file, "1234");
    // His own words, with the faults that the author knew, and one that nobody thought of.
    const auto said = [&student] {
        QStringList headlines;
        for (const Finding &finding : student.bench.check().report()->findings)
            headlines.append(finding.message.section(QLatin1Char('\n'), 0, 0));
        return headlines;
    };
    handIn(student, "RACK", utf8(story::rackOfAStudent));
    QVERIFY(!student.bench.check().report()->passed);
    QCOMPARE(said(), QStringList{QStringLiteral("The balls swap all of their velocities")});
    QVERIFY(student.says(QStringLiteral("The balls swap all of their velocities")));
    const double k = valuesOf(m_author->files(), QStringLiteral("DRAG"), QStringLiteral("1234"))
                         .value(QStringLiteral("k"));
    handIn(student, "DRAG", utf8(story::dragOfAStudent).arg(2 * k));
    QVERIFY(!student.bench.check().report()->passed);
    QVERIFY2(!said().isEmpty(), qPrintable(student.bench.check().report()->checks.front().message));
    QCOMPARE(said(), QStringList{QStringLiteral(
                         "What acts on the velocity of circle 1 is 2 times as strong "
                         "as it should be")});
    handIn(student, "SPRING", utf8(story::springOfAStudent));
    QVERIFY(!student.bench.check().report()->passed);
    QCOMPARE(said(), QStringList{QStringLiteral("Only one ball feels the spring")});
    for (int step = 0; step < 3; ++step)
        QVERIFY(!student.isTicked(step));
}

QTEST_MAIN(TestAuthorStory)
#include "test_author_story.moc"
