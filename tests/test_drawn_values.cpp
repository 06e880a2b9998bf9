// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab_with_values.h"
#include "tasks/authoring/lab_edits.h"
#include "tasks/grading/judging_request.h"
#include "tasks/lab_report/lab_report.h"
#include "tasks/proof/lab_verifier.h"
#include "tasks/questions/answers.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/values/value_ranges.h"
#include "tasks/workspace/workspace_info.h"

#include <QJsonArray>
#include <QSet>
#include <QTest>

#include <cmath>

using namespace cradle;

/// What each student draws is drawn alike by everybody, and tried by who verifies the lab.
class TestDrawnValues : public QObject
{
    Q_OBJECT
private slots:
    void drawnValueLiesOnItsGridAndStays();
    void everybodyWhoJudgesDrawsTheSame();
    void numberDrawsTheSameHoweverWritten();
    void rosterDecidesWhoseValuesAreDrawn();
    void verifyTriesTenStudents();
    void everyValueOfARangeIsTried();
    void whatIsNoNumberForSomeIsFound();
};

namespace {

/// A lab in which k is drawn, and a question asks for it in percent.
LabFiles labThatAsksForK()
{
    LabFiles files = labWith(values({{QStringLiteral("k"), range}}));
    edit(files, "S1/task.json", [](QJsonObject &task) {
        task.insert(QStringLiteral("questions"),
                    QJsonArray{QJsonObject{{QStringLiteral("id"), QStringLiteral("k")},
                                           {QStringLiteral("kind"), QStringLiteral("number")},
                                           {QStringLiteral("title"), QStringLiteral("k")},
                                           {QStringLiteral("right"), QStringLiteral("100*k")}}});
    });
    return files;
}

} // namespace

void TestDrawnValues::drawnValueLiesOnItsGridAndStays()
{
    const LabFiles files = labWith(values({{QStringLiteral("k"), range}}));
    QVERIFY(drawsValues(files));
    QSet<QString> drawn;
    for (int i = 0; i < 200; ++i) {
        const double value = k(files, QString::number(i));
        const double steps = (value - 0.6) / 0.05;
        QVERIFY(value >= 0.6 && value <= 0.9);
        QVERIFY(std::abs(steps - std::round(steps)) < 1e-9);
        drawn.insert(QString::number(value));
        QCOMPARE(k(files, QString::number(i)), value);
    }
    QCOMPARE(drawn.size(), 7); // 0.6, 0.65 … 0.9, written so
    QVERIFY(drawn.contains(QStringLiteral("0.75")));
    QCOMPARE(k(files, {}), 0.6);
    LabFiles other = files;
    edit(other, "lab.json",
         [](QJsonObject &lab) { lab.insert(QStringLiteral("draw"), QStringLiteral("next year")); });
    int different = 0;
    for (int i = 0; i < 50; ++i)
        different += k(files, QString::number(i)) != k(other, QString::number(i)) ? 1 : 0;
    QVERIFY(different > 25);
}

void TestDrawnValues::everybodyWhoJudgesDrawsTheSame()
{
    const LabFiles files = labThatAsksForK();
    const Lab lab = *readLab(files, QStringLiteral("here"));
    QVERIFY(lab.drawsValues);
    QString number = QStringLiteral("1");
    for (int i = 2; k(files, number) == 0.6; ++i)
        number = QString::number(i);
    const QString answer = QString::number(100.0 * k(files, number));
    const Lab own = forStudent(lab, number);
    QCOMPARE(own.hash, lab.hash);
    QCOMPARE(own.tasks[0].questions[0].number, 100.0 * k(files, number));
    WorkspaceInfo info;
    info.studentId = number;
    WorkFiles work{{QStringLiteral("cradle.json"), textOf(info)},
                   {QStringLiteral("steps/S1.lua"), own.tasks[0].solution.toUtf8()},
                   {QStringLiteral("answers.json"),
                    answersText({{QStringLiteral("S1"), {{QStringLiteral("k"), answer}}}})}};
    StepResult result;
    JudgingRequest request{.seed = 1, .steps = {own.tasks[0].id}, .files = work};
    judgeWork(
        lab, request, [] {}, [&](const StepResult &step) { result = step; });
    QCOMPARE(result.status, StepResult::Status::Passed);
    const LabReport told = makeLabReport(lab, workFrom(work, lab), 1, {});
    QCOMPARE(told.steps[0].verdict, StepVerdict::Passed);
    work.remove(QStringLiteral("cradle.json")); // nobody's: k is 0.6
    request.files = work;
    judgeWork(
        lab, request, [] {}, [&](const StepResult &step) { result = step; });
    QCOMPARE(result.status, StepResult::Status::Failed);
}

void TestDrawnValues::numberDrawsTheSameHoweverWritten()
{
    const LabFiles files = labWith(values({{QStringLiteral("k"), range}}));
    for (int i = 1; i < 50; ++i) {
        const QString number = QStringLiteral("a%1b").arg(i);
        for (const QString &written :
             {QStringLiteral(" A%1 B "), QStringLiteral("00a%1-b"), QStringLiteral("a.%1/B")})
            QCOMPARE(k(files, written.arg(i)), k(files, number));
    }
}

/// Whoever hands in the work of a neighbour, number and all, has the values of the own number.
void TestDrawnValues::rosterDecidesWhoseValuesAreDrawn()
{
    const LabFiles files = labThatAsksForK();
    const Lab lab = *readLab(files, QStringLiteral("here"));
    const QString neighbours = QStringLiteral("1");
    int other = 2;
    while (k(files, QString::number(other)) == k(files, neighbours))
        ++other;
    const QString own = QString::number(other);
    WorkspaceInfo info;
    info.studentId = neighbours;
    const QString answer = QString::number(100.0 * k(files, neighbours));
    const auto judged = [&](const QStringList &numbers) {
        const WorkFiles work{
            {QStringLiteral("cradle.json"), textOf(info)},
            {QStringLiteral("steps/S1.lua"),
             forStudent(lab, neighbours).tasks[0].solution.toUtf8()},
            {QStringLiteral("answers.json"),
             answersText({{QStringLiteral("S1"), {{QStringLiteral("k"), answer}}}})}};
        StepResult result;
        judgeWork(
            lab, {.seed = 1, .steps = {lab.tasks[0].id}, .files = work, .numbers = numbers}, [] {},
            [&](const StepResult &step) { result = step; });
        return result;
    };
    StepResult result = judged({own, QStringLiteral("ada")});
    QCOMPARE(result.status, StepResult::Status::Failed);
    QCOMPARE(result.drawnBy, own);
    QCOMPARE(result.ownNumber, neighbours);
    QVERIFY(result.hasForeignNumber());
    for (const QStringList &numbers :
         {QStringList(), QStringList{QStringLiteral("0001")}, QStringList{own, neighbours}}) {
        result = judged(numbers);
        QCOMPARE(result.status, StepResult::Status::Passed);
        QCOMPARE(result.drawnBy, neighbours);
        QVERIFY(!result.hasForeignNumber());
    }
    info.studentId.clear(); // as a lone program has none
    QCOMPARE(judged({neighbours}).status, StepResult::Status::Passed);
}

void TestDrawnValues::verifyTriesTenStudents()
{
    // With k = 0.6, which nobody's number draws, all is well; the starter moves with others.
    LabFiles files = labWith(values({{QStringLiteral("k"), range}}));
    files.contents[QStringLiteral("S1/solution.lua")] +=
        "\nif {{k}} > 0.7 then error('too stiff') end\n";
    const auto lab = readLab(files, QStringLiteral("here"));
    QVERIFY(lab.ok());
    int last = 0;
    int all = 0;
    // One bar, which does not begin anew for every student.
    const JudgeHooks hooks{.progress = [&](int done, int total) {
        QVERIFY(done >= last && done <= total);
        QVERIFY(all == 0 || all == total);
        last = done;
        all = total;
    }};
    const auto verified = verifyLab(*lab, {}, hooks);
    QCOMPARE(last, all);
    QVERIFY(!verified[0].findings.empty());
    bool told = false;
    for (const LabFinding &finding : verified[0].findings)
        told = told || finding.message.startsWith(QStringLiteral("with the values of the student"));
    QVERIFY(told);
}

void TestDrawnValues::everyValueOfARangeIsTried()
{
    // 0.6, 0.65 … 0.9 are seven; students 1 to 10 draw only some of them.
    const LabFiles files = labWith(values({{QStringLiteral("k"), range}}));
    QStringList ten;
    for (int i = 1; i <= 10; ++i)
        ten.append(QString::number(i));
    QCOMPARE(triedRanges(files, ten)[0].count, 7);
    const QStringList tried = studentsToTry(files, 10, 24);
    QVERIFY(tried.size() >= 10);
    QCOMPARE(triedRanges(files, tried),
             (std::vector<TriedRange>{{QString(), QStringLiteral("k"), 7, 7, 0.6, 0.9}}));
    // The ends come first where there is no room for all.
    const std::vector<TriedRange> few = triedRanges(files, studentsToTry(files, 1, 1));
    QCOMPARE(few[0].least, 0.6);
    QCOMPARE(few[0].most, 0.9);
    // Of 500 numbers, and no more.
    QCOMPARE(studentsToTry(files, 500, 500).size(), 500);
    QCOMPARE(studentsToTry(files, 500, 500).last(), QStringLiteral("500"));
    QCOMPARE(studentsToTry(files, 600, 600).size(), 500);
    QVERIFY(studentsToTry(labWith(values({{QStringLiteral("k"), 2}})), 10, 24).isEmpty());
    // The reference fails for the largest alone.
    LabFiles last = files;
    last.contents[QStringLiteral("S1/solution.lua")] +=
        "\nif {{k}} > 0.88 then error('stiff') end\n";
    const auto verified = verifyLab(*readLab(last, QStringLiteral("here")));
    QVERIFY(
        std::any_of(verified[0].findings.begin(), verified[0].findings.end(),
                    [](const LabFinding &f) { return f.program == QLatin1String("solution"); }));
}

void TestDrawnValues::whatIsNoNumberForSomeIsFound()
{
    const LabFiles files = labWith(
        values({{QStringLiteral("k"), range}, {QStringLiteral("a"), QStringLiteral("1/(k-0.75)")}}),
        "a is {{a}}");
    const auto lab = readLab(files, QStringLiteral("here"));
    QVERIFY(lab && lab->findings.empty()); // of the first, 0.6
    const auto verified = verifyLab(*lab);
    const auto found =
        std::find_if(verified[0].findings.begin(), verified[0].findings.end(),
                     [](const LabFinding &f) { return f.kind == LabFinding::Kind::ValueFails; });
    QVERIFY(found != verified[0].findings.end());
    QVERIFY2(found->message.contains(QStringLiteral("no finite number")),
             qPrintable(found->message));
}

QTEST_GUILESS_MAIN(TestDrawnValues)

#include "test_drawn_values.moc"
