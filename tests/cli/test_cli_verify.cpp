// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/program_run.h"
#include "tests/cli/verify_run.h"

#include <QFileInfo>

#include <map>

using namespace cradle::programs;

/// cradle-cli verify: a lab of one step that is sound, and what is said when it is not.
class TestCliVerify : public QObject
{
    Q_OBJECT
private slots:
    void soundLabPasses();
    void seedsAreAsManyAsAskedFor();
    void unsoundLabDoesNotPass_data();
    void unsoundLabDoesNotPass();
    void unfinishedTextsAreTold();
    void mistakesBecomeDifferences();
    void oneStepAlone();
};

void TestCliVerify::soundLabPasses()
{
    const QTemporaryDir folder;
    write(folder, soundLab());
    const Outcome outcome = verify({folder.path()});
    VERIFY_CODE(outcome, 0);
    QVERIFY(outcome.error.isEmpty());
    const QStringList lines = outcome.out.split(QLatin1Char('\n'));
    // The matrix: a row for each program, a column for each check.
    const auto row = [&](const char *name) {
        const QStringList found = lines.filter(text("  ") + text(name) + text(" "));
        return found.size() == 1 ? found.first().simplified() : outcome.out;
    };
    QCOMPARE(row("starter"), text("starter x ."));
    QCOMPARE(row("solution"), text("solution . . with 10 seeds"));
    QCOMPARE(row("mistakes/upward"), text("mistakes/upward x . upward"));
    QCOMPARE(row("mistakes/twice"), text("mistakes/twice . x twice"));
    QVERIFY2(outcome.out.contains(text("1 steps, 2 mistakes, 0 problems")),
             outcome.toText().constData());
}

void TestCliVerify::seedsAreAsManyAsAskedFor()
{
    const QTemporaryDir folder;
    write(folder, soundLab());
    const Outcome some = verify({text("--seeds"), text("3"), folder.path()});
    VERIFY_CODE(some, 0);
    QVERIFY2(some.out.contains(text("with 3 seeds")), some.toText().constData());
    for (const char *wrong : {"0", "many", "1001"})
        VERIFY_CODE(verify({text("--seeds"), text(wrong), folder.path()}), 2);
}

void TestCliVerify::unsoundLabDoesNotPass_data()
{
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QByteArray>("content"); ///< null: the file is missing
    QTest::addColumn<QString>("problem");
    const auto row = [](const char *name, const char *file, const QByteArray &content,
                        const char *problem) {
        QTest::newRow(name) << QByteArray(file) << content << text(problem);
    };
    const QByteArray comment = "-- It moves twice\n\n";
    row("mistake that passes", "S1/mistakes/twice.lua", comment + load + drift,
        "! mistakes/twice passes; a mistake should fail by a check");
    row("mistake that errs", "S1/mistakes/twice.lua", comment + load + "error('no')\n",
        "! mistakes/twice stops with an error at line 6: no");
    row("mistake like another", "S1/mistakes/twice.lua", comment + upward + drift,
        "! mistakes/upward is taken for twice");
    row("starter that errs", "S1/starter.lua",
        "function on_update(dt)\n  local v = nil + dt\nend\n",
        "! starter stops with an error at line 2: ");
    row("starter that passes", "S1/starter.lua", load + drift,
        "! starter passes; a starter should fail by a check");
    row("starter with an error of syntax", "S1/starter.lua", "function on_update(dt)\n",
        "! starter stops with an error at line ");
    row("solution that fails", "S1/solution.lua", load + "function on_update(dt)\nend\n",
        "! solution fails with seed 1 by drifts: ");
    row("solution that errs", "S1/solution.lua", load + "local v = nil .. 'x'\n",
        "! solution stops with an error at line 4: ");
    row("no solution", "S1/solution.lua", {}, "! there is no solution.lua");
    row("scene that does not pass", "S1/solution-preset.json",
        R"({"format": 1, "circles": [{"position": [-2, 2], "velocity": [0, 2]}]})",
        "! solution-preset fails with seed 1 by velocity: ");
    // It drifts from (−2, 2) by 2 m in 1 s, to (0, 2).
    QByteArray tight = soundLab()["S1/task.json"];
    tight.replace(R"("kind": "integrates", "title": "It drifts",)",
                  R"("kind": "ends_at", "title": "It drifts",
                     "parameters": {"positions": [[0.0006, 2]], "tolerance": 0.001},)");
    row("tolerance that the solution nearly uses up", "S1/task.json", tight,
        "! the check drifts allows 0.001, and the solution itself is off by 0.0006");
    row("check that no mistake fails", "S1/mistakes/twice.lua", {},
        "! no mistake fails the check drifts");
}

void TestCliVerify::unsoundLabDoesNotPass()
{
    QFETCH(QByteArray, file);
    QFETCH(QByteArray, content);
    QFETCH(QString, problem);
    Files files = soundLab();
    if (content.isNull())
        files.erase(file);
    else
        files[file] = content;
    const QTemporaryDir folder;
    write(folder, files);
    const Outcome outcome = verify({folder.path()});
    VERIFY_CODE(outcome, 1);
    QVERIFY2(outcome.out.contains(problem), outcome.toText().constData());
    QVERIFY2(!outcome.out.contains(text(" 0 problems")), outcome.toText().constData());
}

/// A language that is begun in a step, what the step has no more, and what is still the template's,
/// are told and fail nothing.
void TestCliVerify::unfinishedTextsAreTold()
{
    Files files = soundLab();
    files["S1/task.de.json"] = R"({"title": "Treiben", "checks": {"drifts": "Er treibt"},
        "mistakes": {"renamed": "Hin"}})";
    files["S1/task.json"].replace("\"Drift\"", "\"Make it fall\"");
    const QTemporaryDir folder;
    write(folder, files);
    const Outcome outcome = verify({folder.path()});
    VERIFY_CODE(outcome, 0);
    for (const char *line :
         {"? task.json: still the text of the template: title\n",
          "? task.de.json: not in this language yet: hints, checks.velocity, mistakes.twice, "
          "mistakes.upward, instructions.de.md\n",
          "? task.de.json: of what the step has not: mistakes.renamed\n"})
        QVERIFY2(outcome.out.contains(text(line)), outcome.toText().constData());
}

void TestCliVerify::mistakesBecomeDifferences()
{
    Files files = soundLab();
    const QByteArray more = "\nlocal one = 1\nlocal two = 2\nlocal three = 3\nlocal four = 4\n"
                            "local five = 5\nlocal six = 6\nlocal seven = 7\n";
    files["S1/solution.lua"] += more;
    files["S1/mistakes/twice.lua"] += more;
    files["S1/mistakes/upward.lua"] += more;
    const QTemporaryDir folder;
    write(folder, files);
    const Outcome before = verify({folder.path()});
    const Outcome after = verify({folder.path(), text("--fix")});
    VERIFY_CODE(after, 0);
    QVERIFY2(after.error.startsWith(text("2 programs became differences, ")),
             after.toText().constData());
    QVERIFY(QFileInfo::exists(folder.filePath(text("S1/mistakes/twice.diff"))));
    QVERIFY(!QFileInfo::exists(folder.filePath(text("S1/mistakes/twice.lua"))));
    const auto matrix = [](const Outcome &of) { return of.out.section(text(" problems"), 0, 0); };
    QCOMPARE(matrix(after), matrix(before));
}

void TestCliVerify::oneStepAlone()
{
    Files files = soundLab();
    for (const char *name : {"task.json", "preset.json", "instructions.md", "starter.lua",
                             "solution.lua", "mistakes/upward.lua"})
        files[QByteArray("S2/") + name] = files[QByteArray("S1/") + name];
    files["S2/task.json"].replace("\"S1\"", "\"S2\"");
    files["lab.json"].replace("[\"S1\"]", "[\"S1\", \"S2\"]");
    const QTemporaryDir folder;
    write(folder, files);
    // Step 2 lacks a mistake; step 1 lacks nothing.
    VERIFY_CODE(verify({folder.path()}), 1);
    const Outcome first = verify({folder.path(), text("--task"), text("S1")});
    VERIFY_CODE(first, 0);
    QVERIFY(!first.out.contains(text("S2")));
    VERIFY_CODE(verify({folder.path(), text("--task"), text("S2")}), 1);
}

QTEST_GUILESS_MAIN(TestCliVerify)
#include "test_cli_verify.moc"
