// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports.h"
#include "tasks/grading/moments.h"
#include "tasks/grading/points.h"
#include "tasks/grading/student_result_json.h"
#include "tasks/judging/judgement.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/text/plain_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace cradle;

/// students/ID.json: what is written is read back, and what anybody else wrote harms nobody.
class TestStudentResultJson : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void reportsSurvive_data();
    void reportsSurvive();
    void everythingOfAStudentSurvives();
    void momentsOfARealRunSurvive();
    void momentsAfterALongRunAreNotShown();
    void sameResultSameBytes();
    void noTimeIsTold();
    void pointsFollowFromTheChecks();
    void whatIsWrongIsSaid_data();
    void whatIsWrongIsSaid();
    void cutTextsAreRefused();
    void textsThatAreTooLongAreCut();

private:
    Lab m_lab;
};

namespace {

/// Only the moments of the scenes are kept.
StudentResult withoutScenes(StudentResult result)
{
    for (StepResult &step : result.steps) {
        for (CheckOutcome &check : step.report->checks) {
            check.scene.reset();
            check.pinned = false;
        }
    }
    return result;
}

StudentResult of(const CheckReport &report)
{
    StudentResult result{.id = QStringLiteral("ada")};
    result.steps.push_back(
        {.taskId = report.taskId,
         .status = report.passed ? StepResult::Status::Passed : StepResult::Status::Failed,
         .report = report});
    result.steps.back().report->elapsedMs = 0;
    return withoutScenes(result);
}

} // namespace

void TestStudentResultJson::initTestCase()
{
    const auto lab = readLab(QStringLiteral(":/labs/lab-4.2"));
    QVERIFY(lab.ok());
    m_lab = *lab;
}

void TestStudentResultJson::reportsSurvive_data()
{
    QTest::addColumn<CheckReport>("report");
    QTest::newRow("passed") << reports::passed();
    QTest::newRow("remarked") << reports::remarked();
    QTest::newRow("failed") << reports::failed();
    QTest::newRow("diagnosed") << reports::diagnosed();
    QTest::newRow("unloadable") << reports::unloadable();
    QTest::newRow("stopped") << reports::stopped();
    CheckReport scored = reports::failed();
    scored.checks[0].points = 2.5;
    scored.findings = {Finding{
        .aspect = Aspect::Response, .message = QStringLiteral("x"), .line = 3, .calls = {9, 3}}};
    QTest::newRow("with points and calls") << scored;
}

void TestStudentResultJson::reportsSurvive()
{
    QFETCH(CheckReport, report);
    const StudentResult result = of(report);
    const auto read = readStudentResult(writeStudentResult(result, m_lab), {});
    QVERIFY2(read.ok(), read.ok() ? "" : qPrintable(read.error().toString()));
    QCOMPARE(*read, result);
}

void TestStudentResultJson::everythingOfAStudentSurvives()
{
    StudentResult result{.id = QStringLiteral("ada"),
                         .name = QStringLiteral("Ada </script><b>O'Neill\" =1+1, \u00e4\u4e2d"),
                         .number = QStringLiteral("0012"),
                         .email = QStringLiteral("ada@example.org"),
                         .platform = Platform::Canvas,
                         .seed = -7'000'000'000'000'000'001,
                         .lateDays = 1.5,
                         .remark = QStringLiteral("two files\nof one step")};
    result.steps.push_back({.taskId = QStringLiteral("L42T1"),
                            .status = StepResult::Status::NotGraded,
                            .reason = QStringLiteral("the worker died"),
                            .program = QStringLiteral("-- \x01\t\"\\\n\u00fc"),
                            .attempts = 12,
                            .minutes = 33.25,
                            .drawnBy = QStringLiteral("0012"),
                            .ownNumber = QStringLiteral("13")});
    result.steps.push_back({.taskId = QStringLiteral("L42T2")});
    const auto read = readStudentResult(writeStudentResult(result, m_lab), {});
    QVERIFY2(read.ok(), read.ok() ? "" : qPrintable(read.error().toString()));
    QCOMPARE(*read, result);
}

void TestStudentResultJson::momentsOfARealRunSurvive()
{
    const Task &task =
        m_lab.tasks[static_cast<std::size_t>(m_lab.indexOf(QStringLiteral("L42T5")))];
    const QString program = task.starter;
    const auto report = judgeTask(m_lab, task, {task.preset, program}, 1);
    QVERIFY(report && !report->passed);
    StudentResult result = of(*report);
    result.steps[0].moments = momentsOf(*report, task, &program);
    QVERIFY(!result.steps[0].moments.empty());
    const DrawnMoment &scene = result.steps[0].moments[0].scene;
    QCOMPARE(scene.bodies.size(), std::size_t(2));
    QVERIFY(scene.time > 0.0);
    const auto read = readStudentResult(writeStudentResult(result, m_lab), {});
    QVERIFY2(read.ok(), read.ok() ? "" : qPrintable(read.error().toString()));
    QCOMPARE(*read, result);
}

/// Up to 20,000 steps.
void TestStudentResultJson::momentsAfterALongRunAreNotShown()
{
    const Task &task = m_lab.tasks.front();
    CheckReport report;
    report.checks.resize(1);
    report.checks.front().id = QStringLiteral("late");
    report.checks.front().scene = task.preset;
    for (const auto &[step, shown] :
         {std::pair(-1, 0), std::pair(0, 1), std::pair(20'000, 1), std::pair(20'001, 0)}) {
        report.checks.front().step = step;
        QCOMPARE(momentsOf(report, task, nullptr).size(), std::size_t(shown));
    }
    report.checks.front().step = 5;
    report.checks.front().passed = true;
    QVERIFY(momentsOf(report, task, nullptr).empty());
}

void TestStudentResultJson::sameResultSameBytes()
{
    const StudentResult result = of(reports::diagnosed());
    QCOMPARE(writeStudentResult(result, m_lab), writeStudentResult(result, m_lab));
}

void TestStudentResultJson::noTimeIsTold()
{
    StudentResult slow = of(reports::failed());
    slow.steps[0].report->elapsedMs = 12345;
    QCOMPARE(writeStudentResult(slow, m_lab), writeStudentResult(of(reports::failed()), m_lab));
}

void TestStudentResultJson::pointsFollowFromTheChecks()
{
    const Task &task = m_lab.tasks[0];
    StepResult step{.taskId = task.id, .status = StepResult::Status::Failed};
    step.report = CheckReport{.labId = m_lab.id, .labHash = m_lab.hash, .taskId = task.id};
    for (const CheckSpec &check : task.checks)
        step.report->checks.push_back({.id = check.id, .title = check.title});
    step.report->checks[0].passed = true;
    step.report->checks.push_back({.id = QStringLiteral("invented"), .title = {}, .passed = true});
    QCOMPARE(*pointsOf(step, task).earned, task.checks[0].points);
    StudentResult result{.id = QStringLiteral("ada"), .steps = {step}};
    const QJsonObject json = QJsonDocument::fromJson(writeStudentResult(result, m_lab)).object();
    const QJsonObject written = json.value(QStringLiteral("steps")).toArray()[0].toObject();
    QCOMPARE(written.value(QStringLiteral("points")).toDouble(), task.checks[0].points);
    QCOMPARE(written.value(QStringLiteral("max_points")).toDouble(), mostPoints(task));
    // A step that is worth something of its own shares that out.
    QCOMPARE(pointScale(task), 1.0);
    Task weighed = task;
    weighed.points = 3.0 * mostPoints(task);
    QCOMPARE(mostPoints(weighed), 3.0 * mostPoints(task));
    QCOMPARE(pointScale(weighed), 3.0);
    QCOMPARE(*pointsOf(step, weighed).earned, 3.0 * task.checks[0].points);
}

void TestStudentResultJson::whatIsWrongIsSaid_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    QTest::addColumn<QString>("pointer");
    QTest::newRow("no format") << QByteArray("\"format\":1") << QByteArray("\"format\":2")
                               << QStringLiteral("/format");
    QTest::newRow("status that is none")
        << QByteArray("\"status\":\"failed\"") << QByteArray("\"status\":\"perfect\"")
        << QStringLiteral("/steps/0/status");
    QTest::newRow("status that the report contradicts")
        << QByteArray("\"status\":\"failed\"") << QByteArray("\"status\":\"passed\"")
        << QStringLiteral("/steps/0/status");
    QTest::newRow("no text") << QByteArray("\"name\":\"\"") << QByteArray("\"name\":{}")
                             << QStringLiteral("/student/name");
    QTest::newRow("no aspect") << QByteArray("\"aspect\":\"motion\"")
                               << QByteArray("\"aspect\":\"x\"")
                               << QStringLiteral("/steps/0/report/findings/0/aspect");
    QTest::newRow("endless line") << QByteArray("\"line\":17") << QByteArray("\"line\":1e300")
                                  << QStringLiteral("/steps/0/report/checks/1/line");
    QTest::newRow("no list") << QByteArray("\"steps\":[") << QByteArray("\"stops\":[")
                             << QStringLiteral("/steps");
    QTest::newRow("colour that breaks out")
        << QByteArray("#1e90ff") << QByteArray("\\\"><b>x")
        << QStringLiteral("/steps/0/moments/0/circles/0/colour");
    for (const char *colour : {"#ge90ff", "#1e90fg", "1e90ff0", "#1e90f"})
        QTest::newRow(colour) << QByteArray("#1e90ff") << QByteArray(colour)
                              << QStringLiteral("/steps/0/moments/0/circles/0/colour");
}

void TestStudentResultJson::whatIsWrongIsSaid()
{
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    QFETCH(QString, pointer);
    StudentResult result = of(reports::diagnosed());
    result.steps[0].moments = {
        {QStringLiteral("walls"), {.bodies = {{.colour = QStringLiteral("#1e90ff")}}}}};
    QByteArray text = writeStudentResult(result, m_lab);
    QVERIFY(text.contains(before));
    text.replace(before, after);
    const auto read = readStudentResult(text, QStringLiteral("ada.json"));
    QVERIFY(!read.ok());
    QCOMPARE(read.error().pointer, pointer);
    QCOMPARE(read.error().file, QStringLiteral("ada.json"));
    QVERIFY(!read.error().message.isEmpty());
}

void TestStudentResultJson::cutTextsAreRefused()
{
    const QByteArray text = writeStudentResult(of(reports::diagnosed()), m_lab);
    for (qsizetype length = 0; length < text.size() - 2; length += 7)
        QVERIFY(!readStudentResult(text.left(length), {}).ok());
    QVERIFY(!readStudentResult("[]", {}).ok());
    QVERIFY(!readStudentResult("{}", {}).ok());
}

/// Else one student with a long name would leave the class without its pages.
void TestStudentResultJson::textsThatAreTooLongAreCut()
{
    const QString face = QString::fromUcs4(U"\U0001F600");
    StudentResult result{.id = QStringLiteral("ada"),
                         .name = QStringLiteral("x") + face.repeated(5'000),
                         .number = QString(5'000, u'1'),
                         .email = QString(5'000, u'@'),
                         .remark = QString(500'000, u'r')};
    QVERIFY(!readStudentResult(writeStudentResult(result, m_lab), {}).ok());
    result = cutToFit(result);
    const auto read = readStudentResult(writeStudentResult(result, m_lab), {});
    QVERIFY2(read.ok(), read.ok() ? "" : qPrintable(read.error().toString()));
    QCOMPARE(*read, result);
    QVERIFY(result.name.endsWith(face));
}

QTEST_APPLESS_MAIN(TestStudentResultJson)
#include "test_student_result_json.moc"
