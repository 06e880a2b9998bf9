// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/graded_class.h"
#include "tests/cli/slurm_cluster.h"
#include "tests/patience.h"

#include <csignal>

using namespace cradle::programs;

/// A class on many machines, by the scripts in tools/grading and the real schedulers, where they
/// are installed: GNU parallel, and Slurm with munge on the loopback.
class TestCliGradeMachines : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void arrayJobWithKilledTaskMakesOneClass();
    void lostHostAndKilledShardCostNothing();
    void scriptWithoutArgumentsSaysHow();

private:
    [[nodiscard]] Outcome merge(const char *shards, const char *out) const;

    GradedClass m_made{};
};

namespace {

// Sanitizers would take minutes, and see here what they see in the other tests of grade.
#if defined(CRADLE_SANITIZED)
constexpr int students = 20;
#else
constexpr int students = 200;
#endif
constexpr int shards = 4;

/// The process that grades into \p out, found by what it was asked; 0: there is none.
pid_t graderInto(const QString &out)
{
    const QByteArray last = "--out" + QByteArray(1, '\0') + QFile::encodeName(out) + '\0';
    for (const QString &name : QDir(text("/proc")).entryList(QDir::Dirs)) {
        bool isNumber = false;
        const int pid = name.toInt(&isNumber);
        if (isNumber
            && contentOf(text("/proc/") + name + text("/cmdline"))
                   .startsWith(QFile::encodeName(cradle::cliProgram()))
            && contentOf(text("/proc/") + name + text("/cmdline")).endsWith(last))
            return pid;
    }
    return 0;
}

/// Kills the one that grades into \p out when it has done two students, and is at the others.
bool killHalfWay(const QString &out)
{
    const auto done = [&] {
        return QDir(out + text("/students")).entryList({text("*.json")}, QDir::Files).size();
    };
    if (!QTest::qWaitFor([&] { return done() > 1; }, patience))
        return false;
    const pid_t grader = graderInto(out);
    return grader > 0 && kill(grader, SIGKILL) == 0 && done() < students / shards;
}

} // namespace

void TestCliGradeMachines::initTestCase()
{
    // Few of them take time, and these are in shard 2: it is never done before it is killed.
    for (int i = 0; i < students; ++i) {
        const QString student = QStringLiteral("student%1").arg(i, 3, 10, QLatin1Char('0'));
        if (i % 20 == 17)
            m_made.putStudent(student);
        else
            m_made.putProgram(student, text("BALL1"), GradedClass::solution("BALL1"));
    }
    VERIFY_CODE(m_made.grade(text("whole"), {text("--exit-zero")}), 0);
}

Outcome TestCliGradeMachines::merge(const char *folder, const char *out) const
{
    QStringList line{text("grade"), text("--merge")};
    for (int i = 1; i <= shards; ++i)
        line.append(m_made.at(QStringLiteral("%1/%2").arg(text(folder)).arg(i)));
    return runCli(line + QStringList{text("--exit-zero"), text("--out"), m_made.at(text(out))});
}

void TestCliGradeMachines::arrayJobWithKilledTaskMakesOneClass()
{
    SlurmCluster cluster;
    if (const QString why = cluster.start(); !why.isEmpty())
        QSKIP(("no Slurm here: " + why.toUtf8()).constData());
    const QStringList script{cradle::sourcePath("tools/grading/grade-array.sbatch"),
                             m_made.at(text("class")),
                             cradle::sourcePath("tasks/labs/bouncing-ball"),
                             m_made.at(text("secret")), m_made.at(text("slurm"))};
    const QMap<QString, QString> program{{text("CRADLE_CLI"), cradle::cliProgram()}};
    const QString job = cluster.submit(QStringList{text("--array=1-4")} + script, program);
    QVERIFY2(!job.isEmpty(), cluster.words().toUtf8());
    const bool killed = killHalfWay(m_made.at(text("slurm.shards/2")));
    QVERIFY2(cluster.finishes(job), cluster.words().toUtf8());
    QVERIFY2(killed, cluster.words().toUtf8());
    QCOMPARE(cluster.endOf(job, 2), text("FAILED"));
    QCOMPARE(cluster.endOf(job, 3), text("COMPLETED"));
    const Outcome lacking = merge("slurm.shards", "slurm");
    VERIFY_CODE(lacking, 1);
    QVERIFY2(lacking.error.contains(m_made.at(text("slurm.shards/2"))), lacking.toText());
    // Submitted again by its number, as the script says.
    auto again = program;
    again.insert(text("SHARDS"), text("4"));
    const QString second = cluster.submit(QStringList{text("--array=2")} + script, again);
    QVERIFY2(!second.isEmpty() && cluster.finishes(second), cluster.words().toUtf8());
    QCOMPARE(cluster.endOf(second, 2), text("COMPLETED"));
    VERIFY_CODE(merge("slurm.shards", "slurm"), 0);
    QCOMPARE(m_made.differing(text("slurm"), text("whole")), QStringList());
}

/// Two hosts, of which one never answers; what stands for ssh runs the rest here.
void TestCliGradeMachines::lostHostAndKilledShardCostNothing()
{
    if (QStandardPaths::findExecutable(text("parallel")).isEmpty())
        QSKIP("not installed: parallel");
    m_made.put(text("ssh"), "#!/bin/bash\n"
                            "while [[ $1 == -* ]]; do shift; done\n"
                            "host=$1; shift; [ \"$1\" = -- ] && shift\n"
                            "[ \"$host\" = lost ] && exit 255\n"
                            "exec bash -c \"$*\"\n");
    QFile::setPermissions(m_made.at(text("ssh")), QFile::ReadOwner | QFile::ExeOwner);
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(text("CRADLE_CLI"), cradle::cliProgram());
    environment.insert(text("PARALLEL_SSH"), m_made.at(text("ssh")));
    environment.insert(text("HOME"), m_made.at(text("home")));
    environment.remove(text("SHELL")); // as cron has it
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(cradle::sourcePath("tools/grading/grade-over-hosts"),
                  {m_made.at(text("class")), cradle::sourcePath("tasks/labs/bouncing-ball"),
                   m_made.at(text("secret")), m_made.at(text("parallel")), QString::number(shards),
                   text("here,lost")});
    QVERIFY(process.waitForStarted());
    const bool killed = killHalfWay(m_made.at(text("parallel.shards/2")));
    QVERIFY(process.state() == QProcess::NotRunning || process.waitForFinished(patience));
    const QByteArray words = process.readAllStandardError();
    QVERIFY2(killed, words);
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QVERIFY2(process.exitCode() == 1, words); // not every program passes
    QCOMPARE(m_made.differing(text("parallel"), text("whole")), QStringList());
}

void TestCliGradeMachines::scriptWithoutArgumentsSaysHow()
{
    const Outcome usage = run(cradle::sourcePath("tools/grading/grade-over-hosts"), {});
    VERIFY_CODE(usage, 2);
    QVERIFY2(usage.error.contains(text("SUBMISSIONS LAB SECRET RESULTS")), usage.toText());
}

QTEST_GUILESS_MAIN(TestCliGradeMachines)
#include "test_cli_grade_machines.moc"
