// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/graded_class.h"

#include "tasks/reading/lab_reader.h"

#include <QStandardPaths>

using namespace cradle::programs;

/// What cradle-cli grade says on the way, to people and to programs.
class TestCliGradeTold : public QObject
{
    Q_OBJECT
private slots:
    void exitZeroHidesOnlyTheVerdicts();
    void dryRunWritesNothing();
    void rosterSaysWhoIsMissing();
    void eventsAreLinesOfJson();
    void eventsThatCannotBeWrittenAreTold();
    void pagesSpeakTheLanguageAskedFor();
    void languageOfTheSystemChangesNothing();
    void barFitsTheTerminal();
};

void TestCliGradeTold::exitZeroHidesOnlyTheVerdicts()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    VERIFY_CODE(made.grade(text("out"), {text("--exit-zero")}), 0);
    for (const char *step : {"BALL1", "BALL2", "BALL3"})
        made.putProgram(text("ada"), text(step), GradedClass::solution(step));
    VERIFY_CODE(made.grade(text("all")), 0);
}

void TestCliGradeTold::dryRunWritesNothing()
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

void TestCliGradeTold::rosterSaysWhoIsMissing()
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

void TestCliGradeTold::eventsAreLinesOfJson()
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
void TestCliGradeTold::eventsThatCannotBeWrittenAreTold()
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
void TestCliGradeTold::pagesSpeakTheLanguageAskedFor()
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
        cradle::readLab(cradle::sourcePath("tasks/labs/bouncing-ball"), text("de"));
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

void TestCliGradeTold::languageOfTheSystemChangesNothing()
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

/// What goes on below the line could not be wiped away.
void TestCliGradeTold::barFitsTheTerminal()
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

QTEST_GUILESS_MAIN(TestCliGradeTold)
#include "test_cli_grade_told.moc"
