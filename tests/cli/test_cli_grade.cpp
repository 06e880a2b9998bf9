// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/graded_class.h"
#include "tests/patience.h"

#include "tasks/work/student_work.h"
#include "tasks/work/work_archive.h"

using namespace cradle::programs;

/// The verdicts of cradle-cli grade, and that they are the same again.
class TestCliGrade : public QObject
{
    Q_OBJECT
private slots:
    void classIsGraded();
    void workFileIsJudgedWithItsHistory();
    void clonesTellTheirTime();
    void jobsAndOrderChangeNothing();
    void zipOfTheClassIsTheClass();
    void scenesFollowFromTheSecret();
    void secretIsMadeOnce();
    void lateHandInAloneIsJudgedAgain();
    void studentWhoLeftLeavesNothing();
};

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

QTEST_GUILESS_MAIN(TestCliGrade)
#include "test_cli_grade.moc"
