// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/other_forms.h"
#include "tests/sanitized.h"
#include "tests/test_paths.h"

#include "tasks/judging/checker.h"
#include "tasks/proof/lab_verifier.h"
#include "tasks/proof/verified_text.h"
#include "tasks/reading/lab_reader.h"

#include <QDir>
#include <QFile>
#include <QTest>

using namespace cradle;
using namespace cradle::programs;

namespace {

#if defined(CRADLE_SANITIZED)
constexpr qint64 seeds = 1; // ten times slower
#else
constexpr qint64 seeds = 3;
#endif

const QString folder = fixturePath("scripts/correct/");

QStringList correctForms(const QString &step = {})
{
    return QDir(folder).entryList(
        {step.isEmpty() ? QStringLiteral("*.lua") : step + QStringLiteral("-*.lua")}, QDir::Files,
        QDir::Name);
}

} // namespace

/// The programs of Lab 4.2 and of its students, through its own checks.
class TestLabScripts : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void stepHasNoProblems_data();
    void stepHasNoProblems();
    void labKnowsManyMistakes();
    void correctFormPasses_data();
    void correctFormPasses();
    void correctFormsAreMany_data();
    void correctFormsAreMany();

private:
    Lab m_lab;
};

void TestLabScripts::initTestCase()
{
    const Result<Lab> lab = readLab(QLatin1String(shippedLab));
    QVERIFY(lab.ok());
    m_lab = *lab;
    QVERIFY2(m_lab.findings.empty(),
             m_lab.findings.empty() ? "" : qPrintable(m_lab.findings.front().toString()));
}

void TestLabScripts::stepHasNoProblems_data()
{
    QTest::addColumn<QString>("step");
    for (std::size_t i = 0; i < m_lab.tasks.size(); i += std::size_t{oneOf(4)}) {
        const QString &id = m_lab.tasks[i].id;
        QTest::newRow(qPrintable(id)) << id;
    }
}

void TestLabScripts::stepHasNoProblems()
{
    QFETCH(QString, step);
    const std::vector<VerifiedTask> tasks = verifyLab(m_lab, step);
    QCOMPARE(tasks.size(), std::size_t{1});
    const VerifiedTask &task = tasks.front();
    QVERIFY2(task.findings.empty(), qPrintable(describeVerified(task)));
    // A starter, a solution and at least three mistakes were judged.
    QVERIFY2(task.programs.size() >= 5, qPrintable(describeVerified(task)));
}

void TestLabScripts::labKnowsManyMistakes()
{
    std::size_t mistakes = 0;
    for (const Task &task : m_lab.tasks) {
        QVERIFY2(task.mistakes.size() >= 3, qPrintable(task.id));
        mistakes += task.mistakes.size();
    }
    QVERIFY2(mistakes >= 60, QByteArray::number(static_cast<qulonglong>(mistakes)));
}

void TestLabScripts::correctFormPasses_data()
{
    QTest::addColumn<QString>("file");
    for (const QString &file : correctForms())
        QTest::newRow(qPrintable(file)) << file;
}

void TestLabScripts::correctFormPasses()
{
    QFETCH(QString, file);
    QFile program(folder + file);
    QVERIFY(program.open(QIODevice::ReadOnly));
    const QString source = QString::fromUtf8(program.readAll());
    const int index = m_lab.indexOf(file.section(QLatin1Char('-'), 0, 0));
    QVERIFY2(index >= 0, "the name begins with the step");
    const Task &task = m_lab.tasks[static_cast<std::size_t>(index)];
    for (qint64 seed = 1; seed <= seeds; ++seed) {
        const auto report = judgeTask(m_lab, task, Submission(task.preset, source), seed);
        QVERIFY2(report->passed, say(*report).constData());
        QVERIFY2(!report->diagnosis(), say(*report).constData());
    }
}

void TestLabScripts::correctFormsAreMany_data()
{
    QTest::addColumn<QString>("step");
    for (const char *step : {"L42T2", "L42T9", "L42T11", "L42T12", "L42T14", "L42T16", "L42T17"})
        QTest::newRow(step) << QString::fromLatin1(step);
}

void TestLabScripts::correctFormsAreMany()
{
    QFETCH(QString, step);
    QVERIFY2(correctForms(step).size() >= 3,
             qPrintable(correctForms(step).join(QStringLiteral(", "))));
}

QTEST_GUILESS_MAIN(TestLabScripts)
#include "test_lab_scripts.moc"
