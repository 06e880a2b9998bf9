// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/program_run.h"
#include "tests/cli/verify_run.h"
#include "tests/test_paths.h"

#include <map>

using namespace cradle::programs;

/// What the command verify cannot read, it names.
class TestCliVerifyRefused : public QObject
{
    Q_OBJECT
private slots:
    void fileThatCannotBeReadIsNamed_data();
    void fileThatCannotBeReadIsNamed();
    void unreadableLabIsRefused_data();
    void unreadableLabIsRefused();
    void wrongUsageIsSaid_data();
    void wrongUsageIsSaid();
};

void TestCliVerifyRefused::fileThatCannotBeReadIsNamed_data()
{
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("message"); ///< after the folder
    QTest::newRow("mistake without a diagnosis")
        << QByteArray("S1/mistakes/twice.lua") << load + twice
        << text("/S1/mistakes/twice.lua:1: ");
    QTest::newRow("step with an unknown key")
        << QByteArray("S1/task.json") << QByteArray(R"({"format": 1, "points": 3})")
        << text("/S1/task.json: ");
    QByteArray script = soundLab()["S1/task.json"];
    script.replace(R"("kind": "integrates", "title": "It drifts",)",
                   R"("kind": "script", "title": "It drifts", "parameters": {"script": "d.lua"},)");
    QTest::newRow("check in Lua that is not there")
        << QByteArray("S1/task.json") << script << text("/S1/checks/d.lua: ");
    QByteArray unknown = soundLab()["S1/task.json"];
    unknown.replace("\"velocity\": [2, 0]", "\"speed\": 2");
    QTest::newRow("unknown parameter") << QByteArray("S1/task.json") << unknown
                                       << text("/S1/task.json: /checks/0/parameters/speed: start "
                                               "has no parameter \"speed\"");
    QTest::newRow("broken preset") << QByteArray("S1/preset.json") << QByteArray("{\n\"format\"")
                                   << text("/S1/preset.json:2: ");
}

void TestCliVerifyRefused::fileThatCannotBeReadIsNamed()
{
    QFETCH(QByteArray, file);
    QFETCH(QByteArray, content);
    QFETCH(QString, message);
    Files files = soundLab();
    files[file] = content;
    const QTemporaryDir folder;
    write(folder, files);
    const Outcome outcome = verify({folder.path()});
    VERIFY_CODE(outcome, 1);
    QVERIFY2(outcome.error.startsWith(folder.path() + message), outcome.toText().constData());
    QVERIFY2(!outcome.out.contains(text(" 0 problems")), outcome.toText().constData());
}

void TestCliVerifyRefused::unreadableLabIsRefused_data()
{
    QTest::addColumn<QString>("folder");
    const QString labs = cradle::fixturePath("labs/");
    QTest::newRow("missing") << text("nowhere");
    QTest::newRow("no lab.json") << labs + text("no_lab_json");
    QTest::newRow("broken syntax") << labs + text("broken_syntax");
    QTest::newRow("a file") << labs + text("good/lab.json");
}

void TestCliVerifyRefused::unreadableLabIsRefused()
{
    QFETCH(QString, folder);
    const Outcome outcome = verify({folder});
    VERIFY_CODE(outcome, 2);
    QVERIFY2(outcome.error.startsWith(folder + text("/lab.json:")), outcome.toText().constData());
    QVERIFY(outcome.out.isEmpty());
}

void TestCliVerifyRefused::wrongUsageIsSaid_data()
{
    QTest::addColumn<QStringList>("arguments");
    const QString good = cradle::fixturePath("labs/good");
    QTest::newRow("no lab") << QStringList{};
    QTest::newRow("two labs") << QStringList{good, good};
    QTest::newRow("unknown step") << QStringList{good, text("--task"), text("S9")};
    QTest::newRow("unknown option") << QStringList{good, text("--quick")};
}

void TestCliVerifyRefused::wrongUsageIsSaid()
{
    QFETCH(QStringList, arguments);
    const Outcome outcome = verify(arguments);
    VERIFY_CODE(outcome, 2);
    QVERIFY2(outcome.error.startsWith(text("cradle-cli: ")), outcome.toText().constData());
    QVERIFY(outcome.out.isEmpty());
}

QTEST_GUILESS_MAIN(TestCliVerifyRefused)
#include "test_cli_verify_refused.moc"
