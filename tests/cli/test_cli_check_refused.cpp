// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/check_run.h"
#include "tests/test_paths.h"

using namespace cradle::programs;

/// What the command check cannot do, it says, with the right exit status.
class TestCliCheckRefused : public QObject
{
    Q_OBJECT
private slots:
    void wrongUsageIsSaid_data();
    void wrongUsageIsSaid();
    void unreadableInputNamesItsPlace_data();
    void unreadableInputNamesItsPlace();
    void programExplainsItself_data();
    void programExplainsItself();
};

void TestCliCheckRefused::wrongUsageIsSaid_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("word");
    const QString good = lab("L42T1/preset.json");
    const auto row = [](const char *name, const QStringList &arguments, const char *word) {
        QTest::newRow(name) << arguments << text(word);
    };
    row("nothing", {}, "Usage");
    row("unknown subcommand", words("judge L42T1"), "unknown subcommand judge");
    row("no step", words("check"), "an argument is missing");
    row("no preset", words("check L42T1"), "--preset");
    row("preset without a value", words("check L42T1 --preset"), "preset");
    row("unknown step", words("check L42T99 --preset") + QStringList{good}, "L42T17");
    row("two steps", words("check L42T1 L42T2 --preset") + QStringList{good}, "L42T2");
    row("unknown option", words("check L42T1 --color --preset") + QStringList{good}, "color");
    row("unknown format", words("check L42T1 --format xml --preset") + QStringList{good},
        "text, json, junit, tap, gradescope, exercism, github");
    row("unknown language", words("check L42T1 --language xx --preset") + QStringList{good},
        "en, ar, de, fr");
    row("seed is a word", words("check L42T1 --seed one --preset") + QStringList{good}, "one");
    row("seed is a half", words("check L42T1 --seed 1.5 --preset") + QStringList{good}, "1.5");
    row("empty step", QStringList{text("check"), QString(), text("--preset"), good}, "no step");
}

void TestCliCheckRefused::wrongUsageIsSaid()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, word);
    const Outcome outcome = runCli(arguments);
    VERIFY_CODE(outcome, 2);
    QVERIFY2(outcome.error.contains(word), outcome.toText().constData());
    QVERIFY(outcome.out.isEmpty());
}

void TestCliCheckRefused::unreadableInputNamesItsPlace_data()
{
    QTest::addColumn<QString>("preset");
    QTest::addColumn<QString>("lab");
    QTest::addColumn<QString>("start"); ///< of the message
    const QString good = lab("L42T1/preset.json");
    const QString bad = cradle::fixturePath("presets/bad/");
    const QString labs = cradle::fixturePath("labs/");
    const auto row = [](const char *name, const QString &preset, const QString &folder,
                        const QString &start) { QTest::newRow(name) << preset << folder << start; };
    row("missing preset", text("nowhere.json"), {}, text("nowhere.json: "));
    row("folder as preset", labs, {}, labs + text(": "));
    row("binary preset", bad + text("binary.json"), {}, bad + text("binary.json:1: "));
    row("negative radius", bad + text("radius_negative.json"), {},
        bad + text("radius_negative.json: /circles/1/radius: "));
    row("endless preset", text("/dev/zero"), {}, text("/dev/zero: "));
    row("missing lab", good, text("nowhere"), text("nowhere/lab.json: "));
    row("step outside", good, labs + text("step_outside"),
        labs + text("step_outside/lab.json: /steps/1: "));
    row("broken syntax", good, labs + text("broken_syntax"),
        labs + text("broken_syntax/lab.json:3: "));
}

void TestCliCheckRefused::unreadableInputNamesItsPlace()
{
    QFETCH(QString, preset);
    QFETCH(QString, lab);
    QFETCH(QString, start);
    QStringList arguments{text("check"), text("L42T1"), text("--preset"), preset};
    if (!lab.isEmpty())
        arguments += {text("--lab"), lab};
    const Outcome outcome = runCli(arguments);
    VERIFY_CODE(outcome, 2);
    QVERIFY2(outcome.error.startsWith(start), outcome.toText().constData());
    QVERIFY(outcome.out.isEmpty());
}

void TestCliCheckRefused::programExplainsItself_data()
{
    QTest::addColumn<QString>("arguments");
    QTest::addColumn<QString>("word");
    QTest::newRow("help") << text("--help") << text("Exit status");
    QTest::newRow("help of check") << text("check --help") << text("--exit-zero");
    QTest::newRow("help of simulate") << text("simulate --help") << text("--every");
    QTest::newRow("version") << text("--version") << text("cradle-cli ");
}

void TestCliCheckRefused::programExplainsItself()
{
    QFETCH(QString, arguments);
    QFETCH(QString, word);
    const Outcome outcome = runCli(arguments.split(QLatin1Char(' ')));
    VERIFY_CODE(outcome, 0);
    QVERIFY2(outcome.out.contains(word), outcome.toText().constData());
    QVERIFY(outcome.error.isEmpty());
}

QTEST_GUILESS_MAIN(TestCliCheckRefused)
#include "test_cli_check_refused.moc"
