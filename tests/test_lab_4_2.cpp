// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/lab_test.h"

#include "tasks/reading/lab_reader.h"

using namespace cradle;

/// The shipped lab judged from outside: every file is there, solutions pass, starts fail.
class TestLab42 : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void everyFileOfTheLabIsRead();
    void everyStepHasWhatAStudentNeeds_data();
    void everyStepHasWhatAStudentNeeds();
    void solutionPassesForFiveSeeds_data() { addSteps(); }
    void solutionPassesForFiveSeeds();
    void startingSceneFails_data() { addSteps(); }
    void startingSceneFails();
    void commitMessageNamesTheIntegrator();
};

void TestLab42::everyFileOfTheLabIsRead()
{
    for (const Error &finding : m_lab.findings)
        qWarning("%s", qPrintable(finding.toString()));
    QVERIFY(m_lab.findings.empty());
    QCOMPARE(m_lab.tasks.size(), std::size_t{17});
    QCOMPARE(m_lab.hash.size(), 64);
}

void TestLab42::everyStepHasWhatAStudentNeeds_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << QStringLiteral("en");
    QTest::newRow("German") << QStringLiteral("de");
    QTest::newRow("French") << QStringLiteral("fr");
}

void TestLab42::everyStepHasWhatAStudentNeeds()
{
    QFETCH(QString, language);
    const Lab lab = *readLab(QLatin1String(shippedLab), language);
    QVERIFY(lab.findings.empty());
    for (std::size_t i = 0; i < lab.tasks.size(); ++i) {
        const Task &task = lab.tasks[i];
        const Task &english = m_lab.tasks[i];
        QVERIFY2(task.hints.size() >= 3, qPrintable(task.id));
        QVERIFY2(task.instructions.startsWith(QStringLiteral("# ")), qPrintable(task.id));
        QVERIFY2(task.checks.size() >= 2, qPrintable(task.id));
        QCOMPARE(task.prediction.has_value(), english.prediction.has_value());
        if (language == QLatin1String("en"))
            continue;
        if (task.prediction) {
            QVERIFY2(task.prediction->question != english.prediction->question,
                     qPrintable(task.id));
            QVERIFY2(task.prediction->outcome != english.prediction->outcome, qPrintable(task.id));
            QCOMPARE(task.prediction->right, english.prediction->right);
        }
        QVERIFY2(task.instructions != english.instructions, qPrintable(task.id));
        QVERIFY2(task.hints != english.hints, qPrintable(task.id));
        for (std::size_t c = 0; c < task.checks.size(); ++c)
            QVERIFY2(task.checks[c].title != english.checks[c].title, qPrintable(task.id));
    }
}

void TestLab42::solutionPassesForFiveSeeds()
{
    QFETCH(QString, step);
    for (qint64 seed = 1; seed <= 5; ++seed) {
        const CheckReport report = judged(step, solution(step), seed);
        QVERIFY2(report.passed, qPrintable(failedChecks(report)));
    }
}

void TestLab42::startingSceneFails()
{
    QFETCH(QString, step);
    const CheckReport report = judged(step, task(step).preset);
    QVERIFY(!report.passed);
    for (const CheckOutcome &check : report.checks)
        QCOMPARE(check.message.isEmpty(), check.passed);
}

void TestLab42::commitMessageNamesTheIntegrator()
{
    Preset preset = solution(QStringLiteral("L42T7"));
    QCOMPARE(judged(QStringLiteral("L42T7"), preset).commit,
             QStringLiteral("L42T7 Two circles moving under gravity, using the symplectic Euler "
                            "method of integration"));
    for (PresetCircle &circle : preset.circles)
        circle.integrator = Integrator::Euler;
    QCOMPARE(judged(QStringLiteral("L42T7"), preset).commit,
             QStringLiteral("L42T7 Two circles moving under gravity, using the Euler method of "
                            "integration"));
}

QTEST_GUILESS_MAIN(TestLab42)
#include "test_lab_4_2.moc"
