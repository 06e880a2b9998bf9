// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_text.h"
#include "tests/class_of_three.h"
#include "tests/reports.h"
#include "tests/text.h"

#include "tasks/grading/judging_request.h"
#include "tasks/grading/moments.h"
#include "tasks/grading/student_page.h"
#include "tasks/judging/judgement.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QTest>

using namespace cradle;

/// What becomes of works that anybody may have written, and how results are read that anybody may
/// have changed: tests/approved/results.
class TestApprovedResults : public QObject
{
    Q_OBJECT
private slots:
    void changedResultsAreReadAsApproved();
    void worksAreJudgedAsApproved();
    void momentsAreThoseOfWhatIsToldAsApproved();
    void pageOfAStudentIsAsApproved();
};

namespace {

void compare(const char *file, const QString &now)
{
    const QString difference =
        approved::compare(QStringLiteral("results/") + QString::fromLatin1(file), now);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

/// Every value in \p value by its path, that of a list's first elements alone.
void listPaths(const QJsonValue &value, const QStringList &path, QList<QStringList> &found)
{
    if (!path.isEmpty())
        found.append(path);
    const QJsonObject object = value.toObject();
    for (auto it = object.constBegin(); it != object.constEnd(); ++it)
        listPaths(*it, path + QStringList{it.key()}, found);
    const QJsonArray list = value.toArray();
    for (qsizetype i = 0; i < std::min<qsizetype>(list.size(), 3); ++i)
        listPaths(list[i], path + QStringList{QString::number(i)}, found);
}

QJsonValue valueAt(QJsonValue value, const QStringList &path)
{
    for (const QString &key : path)
        value = value.isArray() ? value.toArray().at(key.toInt()) : value[key];
    return value;
}

/// \p value with another one at \p path.
QJsonValue changed(const QJsonValue &value, const QStringList &path, const QJsonValue &other)
{
    if (path.isEmpty())
        return other;
    if (value.isArray()) {
        QJsonArray list = value.toArray();
        const auto at = path.first().toInt();
        list[at] = changed(list[at], path.mid(1), other);
        return list;
    }
    QJsonObject object = value.toObject();
    object[path.first()] = changed(object.value(path.first()), path.mid(1), other);
    return object;
}

Result<StudentResult> readWith(const QJsonObject &json, const QStringList &path,
                               const QJsonValue &other)
{
    return readStudentResult(QJsonDocument(changed(json, path, other).toObject()).toJson(), {});
}

StudentResult richResult(const Lab &lab)
{
    StudentResult student = classes::ada(lab);
    student.platform = Platform::Canvas;
    student.remark = text("a remark");
    student.steps = {classes::judged(lab, 0, true, false), classes::judged(lab, 1, false, false)};
    StepResult &first = student.steps[0];
    first.program = text("x = 1\r\n") + QString(400, u'y') + u'\n' + QString(401, u'z') + u'\n';
    first.attempts = 3;
    first.minutes = 2.5;
    first.drawnBy = text("0042");
    first.ownNumber = text("43");
    CheckOutcome &check = first.report->checks[1];
    check.expected = 1.0;
    check.observed = 2.0;
    check.unit = text("m");
    check.step = 4;
    check.variant = text("throw 3");
    check.line = 2;
    first.report->findings[0].calls = {9, 3};
    first.report->remarks = reports::remarked().remarks;
    student.steps[1].report->error = reports::stopped().error;
    return student;
}

/// What lies on the bounds that a message names, and just beyond.
QList<QJsonValue> boundsOf(const QString &message, const QJsonValue &now)
{
    static const QRegularExpression range(text(" from (\\S+) to (\\S+) is right"));
    static const QRegularExpression letters(text("a text of at most (\\d+) letters"));
    static const QRegularExpression count(text("a list of at most (\\d+) "));
    if (const auto found = range.match(message); found.hasMatch()) {
        const double low = found.captured(1).toDouble();
        const double high = found.captured(2).toDouble();
        return {low - 1.0, low, high, high + 1.0};
    }
    if (const auto found = letters.match(message); found.hasMatch()) {
        const auto most = found.captured(1).toInt();
        return {QString(most, u'x'), QString(most + 1, u'x')};
    }
    const auto found = count.match(message);
    if (!found.hasMatch() || now.toArray().isEmpty())
        return {};
    QJsonArray list;
    while (list.size() < found.captured(1).toInt())
        list.append(now.toArray().first());
    const QJsonArray most = list;
    list.append(now.toArray().first());
    return {most, list};
}

QString told(const StepResult &step)
{
    static const char *const states[] = {"passed", "failed", "missing", "not graded"};
    QString all = QStringLiteral("  %1 %2: %3 checks in %4 min, %5 letters, %6 moments, drawn by "
                                 "\"%7\", own \"%8\" %9\n")
                      .arg(step.taskId, text(states[static_cast<int>(step.status)]))
                      .arg(step.attempts)
                      .arg(step.minutes)
                      .arg(step.program.size())
                      .arg(step.moments.size())
                      .arg(step.drawnBy, step.ownNumber, step.reason);
    if (!step.report)
        return all;
    for (const CheckOutcome &check : step.report->checks)
        all += QStringLiteral("    %1 %2 %3\n")
                   .arg(text(check.passed ? "+" : "-"))
                   .arg(check.id)
                   .arg(check.points);
    if (step.report->error)
        all += QStringLiteral("    error of line %1: %2\n")
                   .arg(step.report->error->line)
                   .arg(step.report->error->message);
    all += QStringLiteral("    seed %1, after %2 ms\n")
               .arg(step.report->seed)
               .arg(step.report->elapsedMs);
    return all;
}

} // namespace

/// Each value in turn by one of another sort, with what is said of it.
void TestApprovedResults::changedResultsAreReadAsApproved()
{
    const Lab lab = classes::smallLab();
    const QByteArray whole = writeStudentResult(richResult(lab), lab);
    const QJsonObject json = QJsonDocument::fromJson(whole).object();
    QVERIFY(readStudentResult(whole, {}).ok());
    QJsonArray longList;
    while (longList.size() < 3000)
        longList.append(0);
    const std::pair<const char *, QJsonValue> others[] = {{"null", QJsonValue()},
                                                          {"true", true},
                                                          {"-1", -1},
                                                          {"0.5", 0.5},
                                                          {"7", 7},
                                                          {"1e300", 1e300},
                                                          {"text", text("x")},
                                                          {"[]", QJsonArray()},
                                                          {"[null]", QJsonArray{QJsonValue()}},
                                                          {"long list", longList},
                                                          {"{}", QJsonObject()},
                                                          {"longest text", QString(150'000, u'x')}};
    QList<QStringList> paths;
    listPaths(json, {}, paths);
    QString all;
    for (const QStringList &path : std::as_const(paths)) {
        all += path.join(u'/') + u'\n';
        QStringList fine;
        QMap<QString, QStringList> said;
        for (const auto &[name, other] : others) {
            const auto read = readWith(json, path, other);
            (read ? fine : said[read.error().toString()]).append(text(name));
        }
        if (!fine.isEmpty())
            all += QStringLiteral("  read: %1\n").arg(fine.join(text(", ")));
        QStringList bounds;
        for (const QJsonValue &bound :
             boundsOf(said.isEmpty() ? QString() : said.lastKey(), valueAt(json, path)))
            bounds.append(readWith(json, path, bound) ? text("within") : text("beyond"));
        if (!bounds.isEmpty())
            all += QStringLiteral("  bounds: %1\n").arg(bounds.join(u' '));
        for (auto it = said.cbegin(); it != said.cend(); ++it)
            all += QStringLiteral("  %1: %2\n").arg(it->join(text(", ")), it.key());
    }
    compare("changed.txt", all);
}

void TestApprovedResults::worksAreJudgedAsApproved()
{
    const auto lab = readLab(QLatin1String(bouncingBallLab));
    QVERIFY(lab.ok());
    const QByteArray right = lab->tasks[0].solution.toUtf8();
    const QByteArray wrong = lab->tasks[0].starter.toUtf8();
    QString all;
    const auto add = [&](const char *name, const JudgingRequest &request) {
        all += QStringLiteral("== %1\n").arg(text(name));
        int begun = 0;
        judgeWork(
            *lab, request, [&] { ++begun; }, [&](const StepResult &step) { all += told(step); });
        all += QStringLiteral("  begun %1 times\n").arg(begun);
    };
    const QStringList steps{text("BALL1"), text("BALL2")};
    add("nothing", {.steps = steps});
    add("one step", {.seed = 7, .steps = steps, .files = {{text("steps/BALL1.lua"), right}}});
    add("no moments",
        {.steps = {text("BALL1")}, .files = {{text("steps/BALL1.lua"), wrong}}, .moments = false});
    add("moments", {.steps = {text("BALL1")}, .files = {{text("steps/BALL1.lua"), wrong}}});
    add("lab.lua alone", {.steps = steps, .files = {{text("lab.lua"), right}}});
    add("lab.lua and a step",
        {.steps = steps, .files = {{text("lab.lua"), right}, {text("steps/BALL1.lua"), wrong}}});
    add("lab.lua and a scene",
        {.steps = steps, .files = {{text("lab.lua"), right}, {text("presets/BALL1.json"), "{}"}}});
    add("bytes that are no text", {.steps = steps, .files = {{text("steps/BALL1.lua"), "x\xff"}}});
    add("a program too long",
        {.steps = steps, .files = {{text("steps/BALL1.lua"), QByteArray(3'000'000, ' ')}}});
    add("an archive that is none", {.steps = steps, .archive = "no zip"});
    add("no such step", {.steps = {text("BALL9")}, .files = {{text("steps/BALL1.lua"), right}}});
    add("no repository", {.steps = steps,
                          .files = {{text("steps/BALL1.lua"), right}},
                          .repository = {{text("HEAD"), "x"}}});
    add("endless",
        {.steps = {text("BALL1")}, .files = {{text("steps/BALL1.lua"), "while true do end\n"}}});
    compare("judged.txt", all);
}

/// Of checks that failed, those that findings name come first.
void TestApprovedResults::momentsAreThoseOfWhatIsToldAsApproved()
{
    const auto lab = readLab(QLatin1String(bouncingBallLab));
    QVERIFY(lab.ok());
    const Task &task = lab->tasks[1];
    const QString program = lab->tasks[0].solution;
    const auto judged = judgeTask(*lab, task, Submission(task.preset, program), 1);
    QVERIFY(judged.has_value());
    QString all;
    for (const char *named :
         {"", "any-restitution", "bounces", "falls", "nothing", "any-restitution any-restitution",
          "stays-inside bounces", "stays-inside any-restitution bounces falls"}) {
        for (const qint64 step : {-1, 0, 30, 100'000'000}) {
            CheckReport report = *judged;
            report.findings.clear();
            for (const QString &check : text(named).split(u' '))
                report.findings.push_back({.check = check});
            report.checks[1].step = step;
            all += QStringLiteral("%1; step %2:").arg(text(named)).arg(step);
            for (const StepMoment &moment : momentsOf(report, task, &program))
                all += QStringLiteral(" %1 at %2 s, %3 circles")
                           .arg(moment.check)
                           .arg(moment.scene.time)
                           .arg(moment.scene.bodies.size());
            all += u'\n';
        }
    }
    compare("moments.txt", all);
}

void TestApprovedResults::pageOfAStudentIsAsApproved()
{
    const Lab lab = classes::smallLab();
    StudentResult student = richResult(lab);
    StepResult &step = student.steps[0];
    step.moments.push_back(step.moments[0]);
    step.moments.back().check = text("of no check");
    step.moments.push_back(step.moments[0]);
    step.moments.back().scene.time = 0.0;
    step.report->checks[0].forTeacher = true;
    step.report->checks[0].message = text("for the teacher");
    student.steps[1].report->checks[0].variant = text("preset");
    compare("page.html",
            QString::fromUtf8(studentPage(student, lab, {.late = {.percentPerDay = 10.0}})));
}

QTEST_GUILESS_MAIN(TestApprovedResults)
#include "test_approved_results.moc"
