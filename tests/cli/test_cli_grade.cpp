// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/graded_class.h"

#include "tasks/reading/lab_reader.h"
#include "tasks/work/student_work.h"
#include "tasks/work/work_archive.h"

#include <QStandardPaths>

#include <sys/stat.h>

using namespace cradle::programs;

/// cradle-cli grade, used as it is meant.
class TestCliGrade : public QObject
{
    Q_OBJECT
private slots:
    void barFitsTheTerminal();
    void classIsGraded();
    void workFileIsJudgedWithItsHistory();
    void clonesTellTheirTime();
    void exitZeroHidesOnlyTheVerdicts();
    void jobsAndOrderChangeNothing();
    void zipOfTheClassIsTheClass();
    void scenesFollowFromTheSecret();
    void secretIsMadeOnce();
    void lateHandInAloneIsJudgedAgain();
    void studentWhoLeftLeavesNothing();
    void otherVersionIsRefused();
    void dryRunWritesNothing();
    void rosterSaysWhoIsMissing();
    void eventsAreLinesOfJson();
    void eventsThatCannotBeWrittenAreTold();
    void pagesSpeakTheLanguageAskedFor();
    void languageOfTheSystemChangesNothing();
    void nothingIsWrittenWhereTheSubmissionsAre();
    void placeThatCannotBeWrittenIsTold();
    void secondProcessIsRefused();
    void requiredIsolationIsThereOrRefused();
    void wrongUsageIsRefused_data();
    void wrongUsageIsRefused();
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

} // namespace

void TestCliGrade::classIsGraded()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    made.put(text("class/bob/lab.lua"), GradedClass::solution("BALL3"));
    made.putProgram(text("cy"), text("BALL1"), QByteArray("x = 1\n\0", 7));
    made.put(text("class/dot.cradle-work"), "no archive");
    VERIFY_CODE(made.grade(text("out")), 1);
    QCOMPARE(made.verdicts(text("out"), text("ada")),
             (QStringList{text("passed"), text("failed"), text("missing")}));
    QCOMPARE(made.verdicts(text("out"), text("bob")).last(), text("passed"));
    QCOMPARE(made.verdicts(text("out"), text("cy")).first(), text("failed"));
    QCOMPARE(made.verdicts(text("out"), text("dot")),
             (QStringList{text("failed"), text("failed"), text("failed")}));
    const QJsonObject manifest = made.json(text("out/manifest.json"));
    QVERIFY(manifest.value(text("complete")).toBool());
    QCOMPARE(manifest.value(text("students")).toArray().size(), 4);
    for (const char *file : {"out/class.html", "out/gradebook.csv", "out/students/ada.html"})
        QVERIFY2(QFile::exists(made.at(text(file))), file);
    QVERIFY(!QFile::exists(made.at(text("out/manifest.journal"))));
}

/// What Cradle hands in has dates: a worker that may open no file must not need one to read them.
void TestCliGrade::workFileIsJudgedWithItsHistory()
{
    const GradedClass made;
    const auto kept = [](const char *when, bool passed) {
        return cradle::KeptProgram{
            .version = {.id = QString(40, u'0'),
                        .taskId = text("BALL1"),
                        .when = QDateTime::fromString(text(when), Qt::ISODate),
                        .note = {.reason = cradle::VersionReason::Checked, .passed = passed}},
            .text = text("-- as it was\n")};
    };
    const cradle::WorkFiles files{
        {text("steps/BALL1.lua"), GradedClass::solution("BALL1")},
        {text("history.json"), cradle::historyText({kept("2026-05-01T10:30:00Z", true),
                                                    kept("2026-05-01T10:04:00Z", false),
                                                    kept("2026-05-01T10:00:00Z", false)})}};
    const auto packed = cradle::packWork(files, {});
    QVERIFY(packed.ok());
    made.put(text("class/ada.cradle-work"), *packed);
    VERIFY_CODE(made.grade(text("out")), 1);
    QCOMPARE(made.verdicts(text("out"), text("ada")),
             (QStringList{text("passed"), text("missing"), text("missing")}));
    const QJsonObject step =
        made.json(text("out/students/ada.json")).value(text("steps")).toArray().at(0).toObject();
    QCOMPARE(step.value(text("attempts")).toInt(), 3);
    QCOMPARE(step.value(text("minutes")).toDouble(), 4.0); // a pause of 26 minutes is none of work
}

/// A clone, as GitHub Classroom makes them: commits alone, which tell no checks.
void TestCliGrade::clonesTellTheirTime()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    const Outcome git = run(text("bash"), {text("-ec"), text(R"(
cd "$1"
git init -q
for minute in 10 14 18 55; do
    echo "-- $minute" >> steps/BALL1.lua
    git add .
    GIT_AUTHOR_DATE="2026-05-01T10:$minute:00Z" GIT_COMMITTER_DATE="2026-05-01T10:$minute:00Z" \
        git -c user.name=Ada -c user.email=ada@example.org commit -qm work
done
git config core.fsmonitor 'touch fsmonitor-ran'
git gc -q)"),
                                           text("bash"), made.at(text("class/ada"))});
    VERIFY_CODE(git, 0);
    const auto before = made.files(text("class"));
    VERIFY_CODE(made.grade(text("out")), 1);
    const QJsonArray steps =
        made.json(text("out/students/ada.json")).value(text("steps")).toArray();
    QCOMPARE(steps[0].toObject().value(text("minutes")).toDouble(), 8.0);
    QCOMPARE(steps[0].toObject().value(text("attempts")).toInt(), 0);
    QVERIFY(contentOf(made.at(text("out/class.html"))).contains("Checks and time on the way"));
    QCOMPARE(made.files(text("class")), before);
}

void TestCliGrade::exitZeroHidesOnlyTheVerdicts()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    VERIFY_CODE(made.grade(text("out"), {text("--exit-zero")}), 0);
    for (const char *step : {"BALL1", "BALL2", "BALL3"})
        made.putProgram(text("ada"), text(step), GradedClass::solution(step));
    VERIFY_CODE(made.grade(text("all")), 0);
}

void TestCliGrade::jobsAndOrderChangeNothing()
{
    const GradedClass made;
    for (int i = 0; i < 7; ++i)
        made.putStudent(QStringLiteral("student%1").arg(i));
    VERIFY_CODE(made.grade(text("one"), {text("--jobs"), text("1")}), 1);
    VERIFY_CODE(made.grade(text("many"), {text("--jobs"), text("5")}), 1);
    QVERIFY(!made.files(text("one")).isEmpty());
    QCOMPARE(made.differing(text("many"), text("one")), QStringList());
    // Once more in the same place: nothing is judged, nothing differs.
    const Outcome again = made.grade(text("one"), {text("--format"), text("json")});
    QVERIFY(!again.out.contains(text("\"student\"")));
    QCOMPARE(made.differing(text("many"), text("one")), QStringList());
}

void TestCliGrade::zipOfTheClassIsTheClass()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    made.putStudent(text("bob"));
    QProcess zip;
    zip.start(text("python3"), {text("-c"),
                                text("import shutil, sys; shutil.make_archive(sys.argv[1], 'zip', "
                                     "sys.argv[2])"),
                                made.at(text("zipped/class")), made.at(text("class"))});
    QVERIFY(zip.waitForFinished(patience));
    VERIFY_CODE(made.grade(text("folder")), 1);
    QStringList arguments = made.arguments(text("zip"));
    arguments[1] = made.at(text("zipped/class.zip"));
    VERIFY_CODE(runCli(arguments), 1);
    QCOMPARE(made.differing(text("zip"), text("folder")), QStringList());
}

void TestCliGrade::scenesFollowFromTheSecret()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    made.putStudent(text("bob"));
    VERIFY_CODE(made.grade(text("one")), 1);
    const auto seed = [&](const char *out, const char *id) {
        return made.json(text(out) + text("/students/") + text(id) + text(".json"))
            .value(text("seed"))
            .toDouble();
    };
    QVERIFY(seed("one", "ada") > 0);
    QVERIFY(seed("one", "ada") != seed("one", "bob"));
    made.put(text("secret"), "another secret of this class");
    VERIFY_CODE(made.grade(text("two")), 1);
    QVERIFY(seed("one", "ada") != seed("two", "ada"));
}

void TestCliGrade::secretIsMadeOnce()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    QStringList arguments = made.arguments(text("out"));
    arguments.removeAt(arguments.indexOf(text("--secret")) + 1);
    arguments.removeOne(text("--secret"));
    const Outcome first = runCli(arguments);
    VERIFY_CODE(first, 1);
    QVERIFY2(first.error.contains(text("secret.txt")), first.toText());
    const auto files = made.files(text("out"));
    QVERIFY(files.value(text("secret.txt")).size() > 32);
    QVERIFY(!(QFile::permissions(made.at(text("out/secret.txt")))
              & (QFile::ReadGroup | QFile::ReadOther)));
    VERIFY_CODE(runCli(arguments), 1);
    QCOMPARE(made.files(text("out")), files);
}

void TestCliGrade::lateHandInAloneIsJudgedAgain()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    made.putStudent(text("bob"));
    VERIFY_CODE(made.grade(text("out")), 1);
    made.putProgram(text("bob"), text("BALL3"), GradedClass::solution("BALL3"));
    const Outcome again = made.grade(text("out"), {text("--format"), text("json")});
    VERIFY_CODE(again, 1);
    QVERIFY2(again.out.contains(text("\"id\":\"bob\"")), again.toText());
    QVERIFY2(!again.out.contains(text("\"id\":\"ada\"")), again.toText());
    QCOMPARE(made.verdicts(text("out"), text("bob")).last(), text("passed"));
}

void TestCliGrade::studentWhoLeftLeavesNothing()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    VERIFY_CODE(made.grade(text("out")), 1);
    const auto before = made.files(text("out"));
    made.putStudent(text("bob"));
    VERIFY_CODE(made.grade(text("out")), 1);
    QDir(made.at(text("class/bob"))).removeRecursively();
    VERIFY_CODE(made.grade(text("out")), 1);
    QCOMPARE(made.files(text("out")), before);
}

void TestCliGrade::otherVersionIsRefused()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    VERIFY_CODE(made.grade(text("out")), 1);
    const auto before = made.files(text("out"));
    made.put(text("secret"), "another secret of this class");
    const Outcome refused = made.grade(text("out"));
    VERIFY_CODE(refused, 2);
    QVERIFY2(refused.error.contains(text("the secret")), refused.toText());
    QCOMPARE(made.files(text("out")), before);
    VERIFY_CODE(made.grade(text("out"), {text("--again")}), 1);
    QVERIFY(made.files(text("out")) != before);
}

void TestCliGrade::dryRunWritesNothing()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    const Outcome told = made.grade(text("out"), {text("--dry-run")});
    VERIFY_CODE(told, 0);
    QVERIFY2(told.out.contains(text("ada")) && told.out.contains(text("programs: 2")),
             told.toText());
    QVERIFY(!QFile::exists(made.at(text("out"))));
    const Outcome json =
        made.grade(text("out"), {text("--dry-run"), text("--format"), text("json")});
    const QJsonArray students =
        QJsonDocument::fromJson(json.out.toUtf8()).object().value(text("students")).toArray();
    QCOMPARE(students.size(), 1);
    QCOMPARE(students[0].toObject().value(text("files")).toArray().size(), 2);
}

void TestCliGrade::rosterSaysWhoIsMissing()
{
    const GradedClass made;
    made.putStudent(text("f1"));
    made.put(text("roster.csv"), "id,folder,name\nada,f1,Ada Lovelace\nzed,,Zed Zero\n");
    VERIFY_CODE(made.grade(text("out"), {text("--roster"), made.at(text("roster.csv"))}), 1);
    const QJsonObject student = made.json(text("out/students/ada.json"));
    QCOMPARE(student.value(text("student"))[u"name"].toString(), text("Ada Lovelace"));
    QCOMPARE(made.json(text("out/manifest.json")).value(text("missing")).toArray().size(), 1);
    QVERIFY(contentOf(made.at(text("out/class.html"))).contains("Zed Zero"));
}

void TestCliGrade::eventsAreLinesOfJson()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    made.putStudent(text("bob"));
    const Outcome outcome = made.grade(text("out"), {text("--format"), text("json")});
    VERIFY_CODE(outcome, 1);
    QStringList events;
    for (const QString &line : outcome.out.split(u'\n', Qt::SkipEmptyParts)) {
        const QJsonDocument json = QJsonDocument::fromJson(line.toUtf8());
        QVERIFY2(json.isObject(), line.toUtf8());
        events.append(json.object().value(text("event")).toString());
    }
    QCOMPARE(events, (QStringList{text("start"), text("student"), text("student"), text("done")}));
}

/// Who reads them may go, or lack room; the class is graded all the same.
void TestCliGrade::eventsThatCannotBeWrittenAreTold()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    VERIFY_CODE(made.grade(text("told")), 1);
    for (const char *where : {">/dev/full", ">&-"}) {
        const QStringList line{text("-c"), text("exec \"$0\" \"$@\" ") + text(where),
                               cradle::cliProgram()};
        const Outcome outcome =
            run(text("sh"), line + made.arguments(text("out"), {text("--format"), text("json")}));
        VERIFY_CODE(outcome, 3);
        QVERIFY2(outcome.error.startsWith(text("-: ")), outcome.toText());
        QCOMPARE(made.differing(text("out"), text("told")), QStringList());
    }
}

/// What students are told comes from the worker, the rest from the grader: both speak it. Results
/// in two languages are not mixed, and the merge speaks that of its parts.
void TestCliGrade::pagesSpeakTheLanguageAskedFor()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    made.putStudent(text("bob"));
    made.put(text("roster.csv"), "id,name,late days\nada,Ada,1.5\nbob,Bob,0\n");
    const QStringList german{text("--language"),     text("de"),
                             text("--roster"),       made.at(text("roster.csv")),
                             text("--late-percent"), text("2.5")};
    VERIFY_CODE(made.grade(text("out"), german), 1);
    const QByteArray student = contentOf(made.at(text("out/students/ada.html")));
    const QByteArray page = contentOf(made.at(text("out/class.html")));
    QVERIFY(student.contains("<html lang=\"de\"") && page.contains("<html lang=\"de\""));
    QVERIFY2(page.contains("2,5"), page);
    QVERIFY(!page.contains("How it was judged"));
    const cradle::Result<cradle::Lab> lab =
        cradle::readLab(cradle::sourcePath("tasks/bouncing-ball"), text("de"));
    QVERIFY(lab.ok());
    for (const QByteArray &words :
         {lab->tasks[0].title.toHtmlEscaped().toUtf8(), lab->title.toHtmlEscaped().toUtf8()})
        QVERIFY2(student.contains(words), words);
    const QJsonArray steps =
        made.json(text("out/students/ada.json")).value(text("steps")).toArray();
    const QByteArray report = QJsonDocument(steps[1].toObject()).toJson();
    QVERIFY2(!report.contains("At step") && report.contains("Schritt"), report);
    const Outcome mixed = made.grade(text("out"));
    VERIFY_CODE(mixed, 2);
    QVERIFY2(mixed.error.contains(text("the language")), mixed.toText());
    QStringList merge{text("grade"), text("--merge")};
    for (int i = 1; i <= 2; ++i) {
        const QString out = QStringLiteral("shard%1").arg(i);
        VERIFY_CODE(
            made.grade(out, german + QStringList{text("--shard"), QStringLiteral("%1/2").arg(i)}),
            1);
        merge.append(made.at(out));
    }
    VERIFY_CODE(runCli(merge
                       + QStringList{text("--late-percent"), text("2.5"), text("--out"),
                                     made.at(text("merged"))}),
                1);
    QCOMPARE(made.differing(text("merged"), text("out")), QStringList());
    VERIFY_CODE(runCli(merge
                       + QStringList{text("--language"), text("en"), text("--out"),
                                     made.at(text("english"))}),
                2);
}

void TestCliGrade::languageOfTheSystemChangesNothing()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    made.put(text("roster.csv"), "id,late days\nada,1.5\n");
    const QStringList line =
        made.arguments(text("here"), {text("--roster"), made.at(text("roster.csv")),
                                      text("--late-percent"), text("2.5")});
    VERIFY_CODE(runCli(line), 1);
    QStringList other = line;
    other.replaceInStrings(made.at(text("here")), made.at(text("there")));
    const Outcome german =
        run(text("env"), QStringList{text("LC_ALL=de_DE.UTF-8"), text("TZ=Pacific/Auckland"),
                                     cradle::cliProgram()}
                             + other);
    VERIFY_CODE(german, 1);
    QCOMPARE(made.differing(text("there"), text("here")), QStringList());
}

void TestCliGrade::nothingIsWrittenWhereTheSubmissionsAre()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    const auto before = made.files(text("class"));
    VERIFY_CODE(made.grade(text("class/results")), 2);
    VERIFY_CODE(made.grade(text("class")), 2);
    VERIFY_CODE(made.grade(text("out")), 1);
    QCOMPARE(made.files(text("class")), before);
}

void TestCliGrade::placeThatCannotBeWrittenIsTold()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    made.put(text("file"), "old");
    const Outcome file = made.grade(text("file"));
    VERIFY_CODE(file, 3);
    QVERIFY2(file.error.contains(made.at(text("file"))), file.toText());
    QCOMPARE(contentOf(made.at(text("file"))), QByteArray("old"));
    VERIFY_CODE(made.grade(text("file/out")), 3);
    // Where also root may write nothing.
    const Outcome nowhere = runCli({text("grade"), made.at(text("class")), text("--lab"),
                                    cradle::sourcePath("tasks/bouncing-ball"), text("--out"),
                                    text("/proc/results")});
    VERIFY_CODE(nowhere, 3);
    QVERIFY2(nowhere.error.contains(text("/proc/results: you may not write here")),
             nowhere.toText());
}

void TestCliGrade::secondProcessIsRefused()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    VERIFY_CODE(made.grade(text("out")), 1);
    const Outcome second =
        run(text("flock"), QStringList{text("-n"), made.at(text("out")), cradle::cliProgram()}
                               + made.arguments(text("out")));
    if (second.code == -1)
        QSKIP("no program flock here");
    VERIFY_CODE(second, 3);
    QVERIFY2(second.error.contains(text("another process")), second.toText());
}

/// Namespaces need bubblewrap, and a system that allows them.
void TestCliGrade::requiredIsolationIsThereOrRefused()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    const Outcome here = made.grade(text("out"), {text("--require-isolation")});
    const QString isolation =
        made.json(text("out/manifest.json")).value(text("isolation")).toString();
    QCOMPARE(here.code, isolation == text("rlimits, seccomp, namespaces") ? 1 : 3);
    // Where there is no program bwrap, it says what is lacking.
    QProcessEnvironment bare = QProcessEnvironment::systemEnvironment();
    bare.insert(text("PATH"), made.at(text("")));
    const Outcome without = run(cradle::cliProgram(), made.arguments(text("bare")), {}, bare);
    VERIFY_CODE(without, 1);
    const QStringList parts = made.json(text("bare/manifest.json"))
                                  .value(text("isolation"))
                                  .toString()
                                  .split(text("; no "));
    QCOMPARE(parts.size(), 2);
    QVERIFY(parts[0].startsWith(text("rlimits")));
    QVERIFY(parts[1].endsWith(text("namespaces")));
    // Under sanitizers there is no filter of system calls, with namespaces or without.
    QCOMPARE(parts[0].contains(text("seccomp")),
             isolation.section(text("; no "), 0, 0).contains(text("seccomp")));
    const Outcome refused =
        run(cradle::cliProgram(), made.arguments(text("none"), {text("--require-isolation")}), {},
            bare);
    VERIFY_CODE(refused, 3);
    QVERIFY2(refused.error.contains(text("; no ") + parts[1]), refused.toText());
}

void TestCliGrade::wrongUsageIsRefused_data()
{
    QTest::addColumn<QStringList>("more");
    QTest::newRow("jobs") << QStringList{text("--jobs"), text("0")};
    QTest::newRow("shard") << QStringList{text("--shard"), text("3/2")};
    QTest::newRow("format") << QStringList{text("--format"), text("xml")};
    QTest::newRow("late") << QStringList{text("--late-percent"), text("-1")};
    QTest::newRow("roster") << QStringList{text("--roster"), text("/nowhere.csv")};
    QTest::newRow("secret") << QStringList{text("--secret"), text("/dev/null")};
    QTest::newRow("lab") << QStringList{text("--lab"), text("/nowhere")};
    QTest::newRow("two classes") << QStringList{text("/tmp")};
}

void TestCliGrade::wrongUsageIsRefused()
{
    QFETCH(QStringList, more);
    const GradedClass made;
    made.putStudent(text("ada"));
    VERIFY_CODE(made.grade(text("out"), more), 2);
    VERIFY_CODE(runCli({text("grade"), made.at(text("class"))}), 2);
}

/// What goes on below the line could not be wiped away.
void TestCliGrade::barFitsTheTerminal()
{
    const QString script = QStandardPaths::findExecutable(text("script"));
    QVERIFY2(!script.isEmpty(), "script of util-linux gives a program a terminal");
    const GradedClass made;
    for (int i = 0; i < 3; ++i)
        made.putStudent(QStringLiteral("student%1").arg(i));
    const QString command = text("stty cols 60; '") + cradle::cliProgram() + text("' '")
                            + made.arguments(text("out")).join(text("' '"))
                            + text("' --language de");
    const Outcome outcome = run(script, {text("-qec"), command, text("/dev/null")});
    VERIFY_CODE(outcome, 1);
    const QStringList shown = outcome.out.split(text("\r\x1b[K"));
    QVERIFY2(shown.size() > 2, outcome.toText());
    for (const QString &line : shown.mid(1, shown.size() - 2))
        QVERIFY2(line.size() < 60, line.toUtf8());
}

QTEST_GUILESS_MAIN(TestCliGrade)
#include "test_cli_grade.moc"
