// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/hand_in/hand_in.h"

#include "git_home.h"
#include "model/files/file_io.h"
#include "tasks/lab_report/report_html.h"
#include "tasks/reading/lab_archive.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/workspace/workspace.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace cradle;

/// A student's work in one file: what is in it, and what of it is believed.
class TestHandIn final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void holdsAllTheWork();
    void everyStepIsJudgedAnew();
    void forgedPassesAreNotBelieved();
    void sameWorkMakesTheSameFile();
    void plainFolderWillDo();
    void opensAsAWorkspaceToLookAt();
    void opensTheSameFolderAgain();
    void unzipReadsIt();
    void namesAreFileNames_data();
    void namesAreFileNames();
    void changedFilesAreRefused_data();
    void changedFilesAreRefused();
    void hostileHistoryIsOnlyText();
    void longHistoryOpensSoon();

private:
    [[nodiscard]] QString path(const char *name) const
    {
        return m_folder->filePath(QLatin1String(name));
    }
    [[nodiscard]] HandIn gathered() const;
    [[nodiscard]] QByteArray packed() const { return *packHandIn(gathered(), reportName, "%PDF"); }

    static inline const QString reportName = QStringLiteral("report.pdf");
    const QDateTime m_when{QDate(2026, 11, 22), QTime(10, 0), Qt::UTC};
    GitHome m_home;
    Lab m_lab;
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestHandIn::initTestCase()
{
    auto lab = readLab(QLatin1String(bouncingBallLab));
    QVERIFY(lab);
    m_lab = std::move(*lab);
}

/// Step 1 passes, after an attempt that did not; step 2 stops with an error; step 3 is not done.
void TestHandIn::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Workspace workspace(path("w"));
    QVERIFY(!workspace.begin(m_lab));
    QVERIFY(!workspace.save(QStringLiteral("BALL1"), m_lab.tasks[0].solution));
    QVERIFY(!workspace.save(QStringLiteral("BALL2"),
                            QStringLiteral("function on_update() x.y = 1 end\n")));
    const QString mistake = m_lab.tasks[0].mistakes.front().name;
    for (int i = 0; i < 2; ++i)
        QVERIFY(!workspace.keep(
            QStringLiteral("BALL1"), m_lab.tasks[0].mistakes.front().source,
            {.reason = VersionReason::Checked, .passed = false, .findings = {mistake}}));
    QVERIFY(!workspace.keep(QStringLiteral("BALL1"), m_lab.tasks[0].solution,
                            {.reason = VersionReason::Checked, .passed = true}));
    QVERIFY(!workspace.saveNote(QStringLiteral("BALL1"), QStringLiteral("It *fell* <b>.")));
    QVERIFY(!workspace.setStudent(QStringLiteral("Ada Lovelace"), QStringLiteral("s1")));
}

HandIn TestHandIn::gathered() const
{
    const auto handIn =
        gatherHandIn(m_lab, path("w"), {.note = QStringLiteral("Dear teacher")}, 1, m_when);
    if (!handIn)
        qFatal("%s", qPrintable(handIn.error().toString()));
    return *handIn;
}

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

/// A commit, a version or a file that says "passed" is only that: something it says.
void TestHandIn::forgedPassesAreNotBelieved()
{
    const QString id = QStringLiteral("BALL2");
    const VersionNote passed{.reason = VersionReason::Checked, .passed = true};
    auto history = History::open(path("w"));
    QVERIFY(history);
    QVERIFY(!(*history)->commit(passMessage(id, QStringLiteral("BALL2 done"), passed), {}));
    QVERIFY(!(*history)->keep(id, "-- nothing\n", passed, {}));
    QVERIFY(!writeFile(path("w/progress.json"),
                       R"({"format": 1, "labs": {"bouncing-ball": {"tasks": {"BALL2":
                          {"passed": true}, "BALL3": {"passed": true}}}}})"));
    const HandIn handIn = gathered();
    QCOMPARE(handIn.report.passedCount(), 1);
    QCOMPARE(handIn.manifest.steps[1].verdict, QStringLiteral("stopped"));
    QCOMPARE(handIn.manifest.steps[2].verdict, QStringLiteral("not done"));
}

void TestHandIn::sameWorkMakesTheSameFile()
{
    QCOMPARE(packed(), packed());
}

void TestHandIn::plainFolderWillDo()
{
    QVERIFY(!makeFolder(path("plain/steps")));
    QVERIFY(!writeFile(path("plain/steps/BALL1.lua"), m_lab.tasks[0].solution.toUtf8()));
    const auto handIn = gatherHandIn(m_lab, path("plain"), {}, 1, m_when);
    QVERIFY(handIn);
    QCOMPARE(handIn->report.passedCount(), 1);
    QVERIFY(!QFile::exists(path("plain/.git"))); // only looked at
    QVERIFY(!gatherHandIn(m_lab, path("nowhere"), {}, 1, m_when));
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
    QVERIFY(unzip.waitForFinished());
    QCOMPARE(unzip.exitCode(), 0);
    QVERIFY(QFile::exists(path("unzipped/steps/BALL1.lua")));
    const QString said = GitHome::git(
        m_folder->path(), {QStringLiteral("clone"), QStringLiteral("-q"),
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
    QTest::newRow("other letters") << QString::fromUtf8("李") << "student-lab-4.2.cradle-work";
}

void TestHandIn::namesAreFileNames()
{
    QFETCH(QString, student);
    QFETCH(QString, file);
    QCOMPARE(workFileName(student, QStringLiteral("lab-4.2")), file);
}

void TestHandIn::changedFilesAreRefused_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("content"); // null: removed
    QTest::addColumn<QString>("words");
    QTest::newRow("a better program")
        << "steps/BALL1.lua" << QByteArray("-- better") << "was changed";
    QTest::newRow("another report") << "report.pdf" << QByteArray("%PDF2") << "was changed";
    QTest::newRow("one more file")
        << "steps/BALL3.lua" << QByteArray("-- more") << "not in the manifest";
    QTest::newRow("a file less") << "lab.lua" << QByteArray() << "is missing";
    QTest::newRow("no manifest") << "manifest.json" << QByteArray("{}") << "manifest.json";
    QTest::newRow("a later format")
        << "manifest.json" << QByteArray(R"({"format": 2})") << "format 1";
    QTest::newRow("a broken manifest") << "manifest.json" << QByteArray("[[[[") << "manifest.json";
    QTest::newRow("a manifest of nothing")
        << "manifest.json" << QByteArray(R"({"format": 1})") << "not in the manifest";
    QTest::newRow("hashes are numbers")
        << "manifest.json" << QByteArray(R"({"format": 1, "files": {"lab.lua": 5}})") << "manifest";
}

void TestHandIn::changedFilesAreRefused()
{
    QFETCH(QString, file);
    QFETCH(QByteArray, content);
    QFETCH(QString, words);
    WorkFiles files = *unpackWork(packed(), {});
    if (content.isNull())
        files.remove(file);
    else
        files[file] = content;
    const auto archive = *packFiles(files);
    const auto work = unpackWork(archive, QStringLiteral("ada.cradle-work"));
    QVERIFY(!work);
    QCOMPARE(work.error().file, QStringLiteral("ada.cradle-work"));
    QVERIFY2(work.error().message.contains(words), qPrintable(work.error().message));
    QVERIFY(!writeFile(path("ada.cradle-work"), archive));
    QVERIFY(!openHandIn(path("ada.cradle-work"), path("opened")));
    QVERIFY(QDir(path("opened")).isEmpty());
}

/// Names of steps that would be other references, dates that are none, programs that are long.
void TestHandIn::hostileHistoryIsOnlyText()
{
    HandIn handIn = gathered();
    handIn.files[QStringLiteral("history.json")] =
        R"([{"step": "../../heads/main", "program": "x", "when": "never"},
            {"step": "a..b", "program": "x"}, {"step": "", "program": "x"}, 5, null,
            {"step": "BALL1", "program": "-- kept", "message": 7, "when": "2026-01-01T00:00:00Z"}])";
    QVERIFY(!writeFile(path("ada.cradle-work"), *packHandIn(handIn, reportName, "%PDF")));
    const auto folder = openHandIn(path("ada.cradle-work"), path("opened"));
    if (!folder) // refused is as well
        return;
    QCOMPARE(GitHome::git(*folder, {QStringLiteral("log"), QStringLiteral("--format=%s")}),
             QStringLiteral("Handed in"));
    Workspace workspace(*folder);
    workspace.beginReading();
    QCOMPARE(workspace.history()->versions(QStringLiteral("BALL1")).size(), std::size_t(1));
}

/// Fifty thousand bytes that took minutes to open: each version waited for the disk.
void TestHandIn::longHistoryOpensSoon()
{
    HandIn handIn = gathered();
    std::vector<KeptProgram> programs;
    for (int i = 0; i < 5000; ++i)
        programs.push_back({{.id = {},
                             .taskId = QStringLiteral("BALL%1").arg(i % 3 + 1),
                             .when = m_when,
                             .note = {.reason = VersionReason::Checked, .passed = true}},
                            QStringLiteral("-- %1\n").arg(i)});
    handIn.files[QStringLiteral("history.json")] = historyText(programs);
    QVERIFY(!writeFile(path("ada.cradle-work"), *packHandIn(handIn, reportName, "%PDF")));
    const auto folder = openHandIn(path("ada.cradle-work"), path("opened"));
    QVERIFY(folder);
    Workspace workspace(*folder);
    workspace.beginReading();
    QCOMPARE(workspace.history()->versions(QStringLiteral("BALL1"), 5000).size(),
             std::size_t(1667));
}

QTEST_GUILESS_MAIN(TestHandIn)
#include "test_hand_in.moc"
