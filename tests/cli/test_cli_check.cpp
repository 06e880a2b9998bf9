// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/file_io.h"
#include "tests/cli/check_run.h"
#include "tests/test_paths.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

using namespace cradle::programs;

/// cradle-cli check, as a grader uses it.
class TestCliCheck : public QObject
{
    Q_OBJECT
private slots:
    void solutionsPassAndStartsDoNot_data();
    void solutionsPassAndStartsDoNot();
    void textListsTheChecks();
    void jsonHasTheFieldsOfTheFormat();
    void failedCheckSaysWhatAndWhere();
    void outputGoesIntoAFile();
    void fullDiskLeavesTheOldReport();
    void exitZeroHidesOnlyTheVerdict();
    void seedChangesNothingButTheScenes();
    void ownLabIsRead();
    void languageIsTakenUp();
    void listHasTheCommaOfTheLanguage();
    void namesNeedNotBeText_data();
    void namesNeedNotBeText();

private:
    static QJsonObject json(const QStringList &arguments, int code);

    QTemporaryDir m_folder;
};

QJsonObject TestCliCheck::json(const QStringList &arguments, int code)
{
    const Outcome outcome = runCli(arguments + words("--format json"));
    if (outcome.code != code || !outcome.error.isEmpty())
        qWarning("%s", outcome.toText().constData());
    return QJsonDocument::fromJson(outcome.out.toUtf8()).object();
}

void TestCliCheck::solutionsPassAndStartsDoNot_data()
{
    QTest::addColumn<QString>("step");
    for (const char *step : {"L42T1", "L42X6", "L42T11", "L42T17"})
        QTest::newRow(step) << text(step);
}

void TestCliCheck::solutionsPassAndStartsDoNot()
{
    QFETCH(QString, step);
    const QString folder = lab("") + step;
    const Outcome good =
        runCli({text("check"), step, text("--preset"), folder + text("/solution-preset.json")});
    VERIFY_CODE(good, 0);
    QVERIFY(good.out.contains(step + text(" passed")));
    QVERIFY(good.error.isEmpty());
    const Outcome start =
        runCli({text("check"), step, text("--preset"), folder + text("/preset.json")});
    VERIFY_CODE(start, 1);
    QVERIFY(start.out.contains(step + text(" did not pass")));
    QVERIFY(start.error.isEmpty());
}

void TestCliCheck::textListsTheChecks()
{
    const Outcome outcome =
        runCli({text("check"), text("L42T1"), text("--preset"), lab("L42T1/preset.json")});
    QVERIFY(outcome.out.contains(text("FAIL  Circle 1 starts with (2, 0) m/s")));
    QVERIFY(outcome.out.contains(text("ok    It drifts evenly to the right")));
}

void TestCliCheck::jsonHasTheFieldsOfTheFormat()
{
    const QJsonObject report = json(
        {text("check"), text("L42T1"), text("--preset"), lab("L42T1/solution-preset.json")}, 0);
    for (const char *key : {"format", "lab", "lab_hash", "task", "seed", "passed", "checks",
                            "diagnosis", "remarks", "error", "elapsed_ms"})
        QVERIFY2(report.contains(text(key)), key);
    QCOMPARE(report.value(text("format")).toInt(), 1);
    QCOMPARE(report.value(text("lab")).toString(), text("lab-4.2"));
    QCOMPARE(report.value(text("lab_hash")).toString().size(), 64);
    QCOMPARE(report.value(text("task")).toString(), text("L42T1"));
    QCOMPARE(report.value(text("seed")).toInt(), 1);
    QCOMPARE(report.value(text("passed")), QJsonValue(true));
    QVERIFY(report.value(text("diagnosis")).isNull() && report.value(text("error")).isNull());
}

void TestCliCheck::failedCheckSaysWhatAndWhere()
{
    // Step 1 starts at rest; 2 m/s to the right are asked for.
    const QJsonObject report =
        json({text("check"), text("L42T1"), text("--preset"), lab("L42T1/preset.json")}, 1);
    QCOMPARE(report.value(text("passed")), QJsonValue(false));
    const QJsonObject first = report.value(text("checks")).toArray().at(0).toObject();
    QCOMPARE(first.value(text("id")).toString(), text("start-velocity"));
    QCOMPARE(first.value(text("passed")), QJsonValue(false));
    QCOMPARE(first.value(text("expected")).toDouble(), 2.0);
    QCOMPARE(first.value(text("observed")), QJsonValue(0.0));
    QCOMPARE(first.value(text("unit")).toString(), text("m/s"));
    QCOMPARE(first.value(text("step")).toInt(), 0);
    QCOMPARE(first.value(text("variant")).toString(), text("preset"));
    QVERIFY(!first.value(text("message")).toString().isEmpty());
}

void TestCliCheck::outputGoesIntoAFile()
{
    const QString path = m_folder.filePath(text("report.json"));
    const QStringList judge{text("check"), text("L42T1"), text("--preset"),
                            lab("L42T1/solution-preset.json")};
    const Outcome outcome = runCli(judge + words("--format json --output") + QStringList{path});
    VERIFY_CODE(outcome, 0);
    QVERIFY(outcome.out.isEmpty());
    QCOMPARE(QJsonDocument::fromJson(contentOf(path)).object().value(text("passed")),
             QJsonValue(true));
    const QString nowhere = m_folder.filePath(text("no/folder/report.json"));
    const Outcome failed = runCli(judge + QStringList{text("--output"), nowhere});
    VERIFY_CODE(failed, 3);
    QVERIFY2(failed.error.startsWith(nowhere + text(": ")), failed.toText().constData());
}

/// The report of before is still one, and nothing half is taken for one.
void TestCliCheck::fullDiskLeavesTheOldReport()
{
    const QString path = m_folder.filePath(text("kept.json"));
    QStringList judge{cradle::cliProgram(),
                      text("check"),
                      text("L42T1"),
                      text("--preset"),
                      lab("L42T1/solution-preset.json"),
                      text("--output"),
                      path};
    VERIFY_CODE(runCli(judge.mid(1)), 0);
    const QByteArray before = contentOf(path);
    // Blocks of 1024 bytes; a report is more than none.
    const Outcome full =
        run(text("/bin/bash"),
            QStringList{text("-c"), text("ulimit -f 0; exec \"$@\""), text("bash")} + judge);
    VERIFY_CODE(full, 3);
    QVERIFY2(full.error.startsWith(path + text(": ")), full.toText().constData());
    QCOMPARE(contentOf(path), before);
    judge.last() = text("/dev/full");
    VERIFY_CODE(runCli(judge.mid(1)), 3);
    judge.last() = text("/dev/null");
    VERIFY_CODE(runCli(judge.mid(1)), 0);
}

void TestCliCheck::exitZeroHidesOnlyTheVerdict()
{
    const QStringList judge{text("check"), text("L42T1"), text("--exit-zero"), text("--preset")};
    const Outcome failed = runCli(judge + QStringList{lab("L42T1/preset.json")});
    VERIFY_CODE(failed, 0);
    QVERIFY(failed.out.contains(text("did not pass")));
    VERIFY_CODE(runCli(judge + QStringList{lab("nowhere.json")}), 2);
}

void TestCliCheck::seedChangesNothingButTheScenes()
{
    const auto report = [](const char *seed) {
        QJsonObject object = json({text("check"), text("L42T2"), text("--preset"),
                                   lab("L42T2/preset.json"), text("--seed"), text(seed)},
                                  1);
        object.remove(text("elapsed_ms"));
        return object;
    };
    const QJsonObject first = report("5");
    QCOMPARE(first.value(text("seed")).toInt(), 5);
    QCOMPARE(report("5"), first);
    QVERIFY(report("6") != first);
}

void TestCliCheck::ownLabIsRead()
{
    const QString folder = cradle::fixturePath("labs/");
    const QStringList judge{text("check"), text("S1"), text("--preset"),
                            lab("L42T4/solution-preset.json"), text("--lab")};
    VERIFY_CODE(runCli(judge + QStringList{folder + text("good")}), 0);
    // Who is judged in one step hears nothing of another; that one cannot be judged, and why is
    // said.
    const QStringList partly = QStringList{text("--lab"), folder + text("unknown_check")};
    const Outcome sound = runCli(judge.mid(0, 4) + partly);
    VERIFY_CODE(sound, 0);
    QVERIFY2(sound.error.isEmpty(), qPrintable(sound.error));
    const Outcome broken = runCli(QStringList{judge[0], text("S2")} + judge.mid(2, 2) + partly);
    VERIFY_CODE(broken, 2);
    QVERIFY(broken.error.startsWith(folder + text("unknown_check/S2/task.json: /checks/1/kind: ")));
}

/// Titles and findings, also those that the process that judges makes.
void TestCliCheck::languageIsTakenUp()
{
    const QString program = m_folder.filePath(text("fast.lua"));
    QVERIFY(!cradle::writeFile(
        program, "function on_load()\n  circle1.velocity = vec(3, 0)\nend\n"
                 "function on_update(t)\n"
                 "  circle1.position = circle1.position + circle1.velocity * t\nend\n"));
    const auto told = [&](const char *language) {
        const QJsonObject report =
            json({text("check"), text("L42T1"), program, text("--language"), text(language)}, 1);
        return QStringList{
            report[text("checks")].toArray().at(0).toObject()[text("title")].toString(),
            report[text("findings")].toArray().at(0).toObject()[text("message")].toString()};
    };
    const QStringList german = told("de");
    QCOMPARE(german[0], QStringLiteral("Kreis 1 startet mit (2, 0) m/s"));
    QVERIFY2(german[1].contains(QStringLiteral("verlangt ist (2, 0) m/s")), qPrintable(german[1]));
    QVERIFY(told("fr")[1].contains(QStringLiteral("il faut (2, 0) m/s")));
    QCOMPARE(told("en")[0], QStringLiteral("Circle 1 starts with (2, 0) m/s"));
}

/// The scene is named by its throw and its timestep.
void TestCliCheck::listHasTheCommaOfTheLanguage()
{
    const QString program = m_folder.filePath(text("far.lua"));
    QVERIFY(!cradle::writeFile(
        program, "function on_update(t)\n"
                 "  circle1.position = circle1.position + circle1.velocity * t * 2\nend\n"));
    const auto told = [&](const char *language) {
        return runCli({text("check"), text("L42T1"), program, text("--language"), text(language)})
            .out;
    };
    QVERIFY(told("de").contains(text(", Zeitschritt ")));
    QVERIFY(told("ar").contains(text("، خطوة زمنية ")));
}

void TestCliCheck::namesNeedNotBeText_data()
{
    QTest::addColumn<QString>("arguments"); // of a shell in which $d is a folder of that kind
    QTest::addColumn<int>("code");
    QTest::newRow("program") << text("S1 \"$d/P.lua\" --lab \"$d/../lab\"") << 0;
    QTest::newRow("lab") << text("S1 \"$d/../P.lua\" --lab \"$d/lab\"") << 0;
    QTest::newRow("lab, with =") << text("S1 \"$d/../P.lua\" --lab=\"$d/lab\"") << 0;
    QTest::newRow("nothing") << text("S1 \"$d/Q.lua\" --lab \"$d/lab\"") << 2;
}

/// Folders of Linux are named by bytes: \351 alone is no UTF-8.
void TestCliCheck::namesNeedNotBeText()
{
    QFETCH(QString, arguments);
    QFETCH(int, code);
    const QTemporaryDir folder;
    const QString script = text("d=$(printf '%s/caf\\351' \"$2\") && mkdir \"$d\""
                                " && cp -r \"$1\" \"$d/lab\" && cp -r \"$1\" \"$2/lab\""
                                " && echo 'x = 1' | tee \"$d/P.lua\" >\"$2/P.lua\""
                                " && exec \"$0\" check --exit-zero ");
    const Outcome outcome =
        run(text("/bin/sh"), {text("-c"), script + arguments, cradle::cliProgram(),
                              cradle::fixturePath("labs/good"), folder.path()});
    VERIFY_CODE(outcome, code);
    QCOMPARE(outcome.out.isEmpty(), code != 0);
    QCOMPARE(outcome.error.contains(text("there is nothing of that name")), code != 0);
}

QTEST_GUILESS_MAIN(TestCliCheck)
#include "test_cli_check.moc"
