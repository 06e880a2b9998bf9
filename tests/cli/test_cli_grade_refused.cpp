// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/graded_class.h"

using namespace cradle::programs;

/// What cradle-cli grade refuses, in words and by its exit status.
class TestCliGradeRefused : public QObject
{
    Q_OBJECT
private slots:
    void otherVersionIsRefused();
    void nothingIsWrittenWhereTheSubmissionsAre();
    void placeThatCannotBeWrittenIsTold();
    void secondProcessIsRefused();
    void requiredIsolationIsThereOrRefused();
    void wrongUsageIsRefused_data();
    void wrongUsageIsRefused();
};

void TestCliGradeRefused::otherVersionIsRefused()
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

void TestCliGradeRefused::nothingIsWrittenWhereTheSubmissionsAre()
{
    const GradedClass made;
    made.putStudent(text("ada"));
    const auto before = made.files(text("class"));
    VERIFY_CODE(made.grade(text("class/results")), 2);
    VERIFY_CODE(made.grade(text("class")), 2);
    VERIFY_CODE(made.grade(text("out")), 1);
    QCOMPARE(made.files(text("class")), before);
}

void TestCliGradeRefused::placeThatCannotBeWrittenIsTold()
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
                                    cradle::sourcePath("tasks/labs/bouncing-ball"), text("--out"),
                                    text("/proc/results")});
    VERIFY_CODE(nowhere, 3);
    QVERIFY2(nowhere.error.contains(text("/proc/results: you may not write here")),
             nowhere.toText());
}

void TestCliGradeRefused::secondProcessIsRefused()
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
void TestCliGradeRefused::requiredIsolationIsThereOrRefused()
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

void TestCliGradeRefused::wrongUsageIsRefused_data()
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

void TestCliGradeRefused::wrongUsageIsRefused()
{
    QFETCH(QStringList, more);
    const GradedClass made;
    made.putStudent(text("ada"));
    VERIFY_CODE(made.grade(text("out"), more), 2);
    VERIFY_CODE(runCli({text("grade"), made.at(text("class"))}), 2);
}

QTEST_GUILESS_MAIN(TestCliGradeRefused)
#include "test_cli_grade_refused.moc"
