// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/hand_in/hand_in.h"

#include "hand_in_test.h"
#include "model/files/file_io.h"
#include "tasks/lab_report/report_html.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/workspace/workspace.h"
#include "tests/patience.h"

#include <QDir>
#include <QTest>

using namespace cradle;

/// A student's work in one file: what is in it, and what of it is believed.
class TestHandIn final : public HandInTest
{
    Q_OBJECT
private slots:
    void initTestCase() { readTheLab(); }
    void init() { workOnTheLab(); }
    void holdsAllTheWork();
    void everyStepIsJudgedAnew();
    void sameWorkMakesTheSameFile();
    void plainFolderWillDo();
    void filesOfAFolderAreBounded();
    void opensAsAWorkspaceToLookAt();
    void opensTheSameFolderAgain();
    void unzipReadsIt();
    void namesAreFileNames_data();
    void namesAreFileNames();
};

void TestHandIn::holdsAllTheWork()
{
    const auto files = unpackWork(packed(), {});
    QVERIFY(files);
    for (const char *name : {"cradle.json", "history.bundle", "history.json", "lab.lua",
                             "manifest.json", "note-to-teacher.txt", "notes/BALL1.md", "report.pdf",
                             "steps/BALL1.lua", "steps/BALL2.lua"})
        QVERIFY2(files->contains(QLatin1String(name)), name);
    QCOMPARE(files->size(), 10);
    const StudentWork work = workFrom(*files, m_lab);
    QCOMPARE(work.info.student, QStringLiteral("Ada Lovelace"));
    QCOMPARE(*work.step(QStringLiteral("BALL1")).program, m_lab.tasks[0].solution);
    QCOMPARE(work.step(QStringLiteral("BALL1")).versions.size(), std::size_t(3));
    QCOMPARE(work.step(QStringLiteral("BALL1")).note, QStringLiteral("It *fell* <b>."));
    QCOMPARE(work.noteToTeacher, QStringLiteral("Dear teacher"));
}

void TestHandIn::everyStepIsJudgedAnew()
{
    const HandIn handIn = gathered();
    const auto manifest = manifestOf(*unpackWork(packed(), {}));
    QVERIFY(manifest);
    QVERIFY(*manifest == handIn.manifest);
    QCOMPARE(manifest->labId, m_lab.id);
    const std::vector<WorkManifest::Step> expected{
        {QStringLiteral("BALL1"), QStringLiteral("passed")},
        {QStringLiteral("BALL2"), QStringLiteral("stopped")},
        {QStringLiteral("BALL3"), QStringLiteral("not done")}};
    QVERIFY(manifest->steps == expected);
    const StepReport &first = handIn.report.steps[0];
    QCOMPARE(first.attempts, 3);
    QCOMPARE(first.met.size(), std::size_t(1));
    QCOMPARE(first.met[0].times, 2);
    QVERIFY(!first.scene.isEmpty() && !first.energy.isEmpty() && !first.change.empty());
    QVERIFY(!handIn.report.steps[1].explanation.isEmpty());
    const QString html = labReportPage(handIn.report, Drawings::Inside, QStringLiteral("en")).html;
    QVERIFY(html.contains(QStringLiteral("It <i>fell</i> &lt;b&gt;.")));
    QVERIFY(html.contains(QStringLiteral("<svg ")));
    QVERIFY(html.contains(QStringLiteral("– Ada Lovelace</title>")));
    QVERIFY(labReportPage(handIn.report, Drawings::Inside, QStringLiteral("de"))
                .html.contains(QStringLiteral("22. November 2026")));
    QVERIFY(!html.contains(QStringLiteral("http://www.w3.org/1999/xlink")));
}

void TestHandIn::sameWorkMakesTheSameFile()
{
    QCOMPARE(packed(), packed());
}

void TestHandIn::plainFolderWillDo()
{
    QVERIFY(!makeFolder(path("plain/steps")));
    QVERIFY(!writeFile(path("plain/answers.json"), R"({"BALL1": {"why": "It falls."}})"));
    QVERIFY(!writeFile(
        path("plain/predictions.json"),
        R"({"BALL1": {"answer": 1, "watched": true}, "BALL2": {"answer": -2, "revealed": true}})"));
    const auto read = readWork(path("plain"), m_lab);
    QVERIFY(read);
    QCOMPARE(read->step(QStringLiteral("BALL1")).answers.value(QStringLiteral("why")).toString(),
             QStringLiteral("It falls."));
    QVERIFY((read->step(QStringLiteral("BALL1")).guess == Guess{.answer = 1, .watched = true}));
    QVERIFY((read->step(QStringLiteral("BALL2")).guess == Guess{.revealed = true}));
    QVERIFY(read->step(QStringLiteral("BALL3")).guess == Guess{});
    QVERIFY(!read->step(QStringLiteral("nowhere")).program);
    QVERIFY(!writeFile(path("plain/steps/BALL1.lua"), m_lab.tasks[0].solution.toUtf8()));
    const auto handIn = gatherHandIn(m_lab, path("plain"), {}, 1, m_when);
    QVERIFY(handIn);
    QCOMPARE(handIn->report.passedCount(), 1);
    QVERIFY(!QFile::exists(path("plain/.git"))); // only looked at
    QVERIFY(!gatherHandIn(m_lab, path("nowhere"), {}, 1, m_when));
}

/// At 8 MiB.
void TestHandIn::filesOfAFolderAreBounded()
{
    QVERIFY(!makeFolder(path("large/notes")));
    for (const int more : {0, 1}) {
        QVERIFY(!writeFile(path("large/notes/BALL1.md"), QByteArray(8 * 1024 * 1024 + more, ' ')));
        QCOMPARE(readWorkFiles(path("large")).ok(), more == 0);
    }
}

void TestHandIn::opensAsAWorkspaceToLookAt()
{
    QVERIFY(!writeFile(path("ada.cradle-work"), packed()));
    const auto folder = openHandIn(path("ada.cradle-work"), path("opened"));
    QVERIFY2(folder, folder ? "" : qPrintable(folder.error().toString()));
    Workspace workspace(*folder);
    workspace.beginReading();
    QVERIFY(!workspace.mayWrite());
    QCOMPARE(workspace.info().student, QStringLiteral("Ada Lovelace"));
    QCOMPARE(*workspace.textOf(m_lab, 0), m_lab.tasks[0].solution);
    const auto versions = workspace.history()->versions(QStringLiteral("BALL1"));
    QCOMPARE(versions.size(), std::size_t(3));
    QCOMPARE(versions[0].note.passed, std::optional(true));
    QVERIFY(workspace.save(QStringLiteral("BALL1"), QStringLiteral("-- changed")));
    QCOMPARE(*workspace.textOf(m_lab, 0), m_lab.tasks[0].solution);
    QVERIFY(GitHome::git(*folder, {QStringLiteral("fsck"), QStringLiteral("--strict")}).isEmpty());
}

void TestHandIn::opensTheSameFolderAgain()
{
    QVERIFY(!writeFile(path("ada.cradle-work"), packed()));
    const auto first = openHandIn(path("ada.cradle-work"), path("opened"));
    const auto second = openHandIn(path("ada.cradle-work"), path("opened"));
    QVERIFY(first && second);
    QCOMPARE(*first, *second);
    QCOMPARE(QDir(path("opened"))
                 .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot)
                 .size(),
             1);
}

void TestHandIn::unzipReadsIt()
{
    QVERIFY(!writeFile(path("ada.cradle-work"), packed()));
    QProcess unzip;
    unzip.start(QStringLiteral("unzip"), {QStringLiteral("-q"), path("ada.cradle-work"),
                                          QStringLiteral("-d"), path("unzipped")});
    QVERIFY(unzip.waitForFinished(patience));
    QCOMPARE(unzip.exitCode(), 0);
    QVERIFY(QFile::exists(path("unzipped/steps/BALL1.lua")));
    const QString said =
        gitAround({QStringLiteral("clone"), QStringLiteral("-q"),
                   QStringLiteral("unzipped/history.bundle"), QStringLiteral("cloned")});
    QVERIFY2(QFile::exists(path("cloned/cradle.json")), qPrintable(said));
}

void TestHandIn::namesAreFileNames_data()
{
    QTest::addColumn<QString>("student");
    QTest::addColumn<QString>("file");
    QTest::newRow("plain") << "Ada Lovelace"
                           << "Ada-Lovelace-lab-4.2.cradle-work";
    QTest::newRow("marks") << QString::fromUtf8("Žoë Müller") << "Zoe-Muller-lab-4.2.cradle-work";
    QTest::newRow("none") << ""
                          << "student-lab-4.2.cradle-work";
    QTest::newRow("path") << "../../etc/passwd"
                          << "etc-passwd-lab-4.2.cradle-work";
    QTest::newRow("sign at the end") << "Ada L.?"
                                     << "Ada-L-lab-4.2.cradle-work";
    QTest::newRow("long") << QStringLiteral("a").repeated(59) + QStringLiteral("bc")
                          << QStringLiteral("a").repeated(59)
                                 + QStringLiteral("b-lab-4.2.cradle-work");
    QTest::newRow("other letters") << QString::fromUtf8("李") << "student-lab-4.2.cradle-work";
}

void TestHandIn::namesAreFileNames()
{
    QFETCH(QString, student);
    QFETCH(QString, file);
    QCOMPARE(workFileName(student, QStringLiteral("lab-4.2")), file);
}

QTEST_GUILESS_MAIN(TestHandIn)
#include "test_hand_in.moc"
