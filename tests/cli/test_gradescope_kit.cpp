// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "program_run.h"
#include "tasks/reading/lab_reader.h"

#include "model/files/file_io.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace cradle;
using namespace cradle::programs;

/// tools/grading/gradescope in the layout that Gradescope documents, below a folder of its own.
class TestGradescopeKit : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void submissionGetsItsResults();
    void sameStudentSameResults();
    void whatCannotBeGradedHasNoResults();

private:
    [[nodiscard]] QString at(const char *path) const
    {
        return m_root.filePath(QStringLiteral("autograder/") + QLatin1String(path));
    }
    [[nodiscard]] Outcome runScript(const char *path) const;
    [[nodiscard]] QByteArray results() const;

    QTemporaryDir m_root;
};

Outcome TestGradescopeKit::runScript(const char *path) const
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("CRADLE_PREFIX"), m_root.path());
    return run(QStringLiteral("bash"), {at(path)}, m_root.path(), environment);
}

QByteArray TestGradescopeKit::results() const
{
    QFile file(at("results/results.json"));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void TestGradescopeKit::initTestCase()
{
    const QString kit = sourcePath("tools/grading/gradescope");
    QVERIFY(QDir().mkpath(at("source")) && QDir().mkpath(at("submission"))
            && QDir().mkpath(at("results")));
    for (const char *name : {"setup.sh", "run_autograder"})
        QVERIFY(QFile::copy(kit + QLatin1Char('/') + QLatin1String(name),
                            at("source") + QLatin1Char('/') + QLatin1String(name)));
    QVERIFY(QFile::copy(at("source/run_autograder"), at("run_autograder")));
    QVERIFY(QFile::link(cliProgram(), at("source/cradle-cli")));
    QVERIFY(QFile::link(sourcePath("tasks/labs/bouncing-ball"), at("source/lab")));
    QVERIFY(!writeFile(at("source/secret"), "a secret of some length, for the tests alone"));
    QVERIFY(!writeFile(at("submission_metadata.json"),
                       "{\"users\": [{\"email\": \"../ada@example.org\", \"name\": \"Ada\"}]}"));
    const auto lab = readLab(sourcePath("tasks/labs/bouncing-ball"));
    QVERIFY(lab.ok());
    QVERIFY(QDir().mkpath(at("submission/steps")));
    const Task &task = lab->tasks.front();
    QVERIFY(!writeFile(at("submission/steps/") + task.id + QStringLiteral(".lua"),
                       task.solution.toUtf8()));
    const Outcome setup = runScript("source/setup.sh");
    QVERIFY2(setup.ended && setup.code == 0, setup.toText());
}

void TestGradescopeKit::submissionGetsItsResults()
{
    const Outcome outcome = runScript("run_autograder");
    QVERIFY2(outcome.ended && outcome.code == 0, outcome.toText());
    const QJsonObject json = QJsonDocument::fromJson(results()).object();
    const double score = json.value(QStringLiteral("score")).toDouble();
    double sum = 0.0;
    for (const QJsonValue &test : json.value(QStringLiteral("tests")).toArray())
        sum += test.toObject().value(QStringLiteral("score")).toDouble();
    QVERIFY(score > 0.0);
    QCOMPARE(sum, score);
}

void TestGradescopeKit::sameStudentSameResults()
{
    QVERIFY(runScript("run_autograder").code == 0);
    const QByteArray first = results();
    QVERIFY(!first.isEmpty());
    QVERIFY(runScript("run_autograder").code == 0);
    QCOMPARE(results(), first);
}

void TestGradescopeKit::whatCannotBeGradedHasNoResults()
{
    QVERIFY(runScript("run_autograder").code == 0);
    QVERIFY(!results().isEmpty());
    QVERIFY(QFile::remove(at("source/lab")));
    const Outcome outcome = runScript("run_autograder");
    QVERIFY(QFile::link(sourcePath("tasks/labs/bouncing-ball"), at("source/lab")));
    QVERIFY2(outcome.ended && outcome.code != 0, outcome.toText());
    QVERIFY(results().isEmpty());
}

QTEST_APPLESS_MAIN(TestGradescopeKit)
#include "test_gradescope_kit.moc"
