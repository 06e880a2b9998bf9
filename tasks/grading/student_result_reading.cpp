// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/json_fields.h"
#include "tasks/grading/moments.h"
#include "tasks/grading/points.h"
#include "tasks/grading/student_result_json.h"
#include "tasks/report/report_json.h"
#include "tasks/report/report_text.h"
#include "tasks/script/script_limits.h"

#include <QCoreApplication>
#include <QJsonDocument>

#include <limits>

namespace cradle {

namespace {

struct ReadingText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

// Far above what a lab, or a program that means no harm, comes to.
constexpr qsizetype nameLetters = 400;
constexpr qsizetype messageLetters = 100'000;
constexpr qsizetype mostReadSteps = 200;
constexpr qsizetype mostChecks = 1'000;
constexpr qsizetype mostReadEntries = 200; ///< findings, remarks, calls, local variables
constexpr qint64 mostLine = 1'000'000;
constexpr qint64 mostStep = std::numeric_limits<int>::max();
constexpr double mostNumber = std::numeric_limits<double>::max();
constexpr qint64 mostSeed = std::numeric_limits<qint64>::max();
constexpr qint64 leastSeed = std::numeric_limits<qint64>::min();

/// The number of a check, or nothing.
std::optional<double> numberIn(JsonFields &json, const char *key)
{
    if (!json.has(key))
        return std::nullopt;
    return json.number(key, -mostNumber, mostNumber);
}

int lineIn(JsonFields &json)
{
    return json.has("line") ? static_cast<int>(json.integer("line", 0, mostLine)) : 0;
}

CheckOutcome readCheck(JsonFields json)
{
    CheckOutcome check{.id = json.text("id", nameLetters),
                       .title = json.text("title", nameLetters),
                       .passed = json.flag("passed"),
                       .message = json.text("message", messageLetters),
                       .expected = numberIn(json, "expected"),
                       .observed = numberIn(json, "observed"),
                       .unit = json.text("unit", nameLetters),
                       .variant = json.text("variant", nameLetters),
                       .line = lineIn(json)};
    check.question = json.has("question") && json.flag("question");
    check.forTeacher = json.has("for_teacher") && json.flag("for_teacher");
    if (json.has("step"))
        check.step = json.integer("step", 0, mostStep);
    if (json.has("points"))
        check.points = json.number("points", 0.0, 1e6);
    return check;
}

Finding readFinding(JsonFields json)
{
    Finding finding{.mistake = json.has("mistake") ? json.text("mistake", nameLetters) : QString(),
                    .message = json.text("message", messageLetters),
                    .check = json.text("check", nameLetters),
                    .line = lineIn(json)};
    const QString name = json.text("aspect", nameLetters);
    if (const auto aspect = aspectFromName(name))
        finding.aspect = *aspect;
    else
        json.refuse(QStringLiteral("aspect"), ReadingText::tr("there is no such aspect"));
    for (const QJsonValue &line : json.list("calls", mostReadEntries))
        finding.calls.push_back(line.toInt());
    return finding;
}

ProgramError readError(JsonFields json)
{
    ProgramError error{.message = json.text("message", messageLetters),
                       .line = lineIn(json),
                       .step = json.integer("step", 0, mostStep),
                       .time = json.number("time", -mostNumber, mostNumber)};
    if (const auto kind = kindFromName(json.text("kind", nameLetters)))
        error.kind = *kind;
    else
        json.refuse(QStringLiteral("kind"), ReadingText::tr("there is no such kind of error"));
    for (const QJsonValue &local : json.list("locals", mostReadEntries))
        error.locals.push_back({local.toArray().at(0).toString().left(nameLetters),
                                local.toArray().at(1).toString().left(messageLetters)});
    return error;
}

/// Reads every element of a list by \p read.
template <typename Value, typename Read>
std::vector<Value> readEach(JsonFields &json, const char *key, qsizetype most, Read read)
{
    std::vector<Value> values;
    qsizetype index = 0;
    for (const QJsonValue &element : json.list(key, most)) {
        values.push_back(read(JsonFields(json, QString::fromLatin1(key), element, index++)));
        if (json.fault())
            break;
    }
    return values;
}

CheckReport readReport(JsonFields json)
{
    CheckReport report{.labId = json.text("lab", nameLetters),
                       .labHash = json.text("lab_hash", nameLetters),
                       .taskId = json.text("task", nameLetters),
                       .seed = json.integer("seed", leastSeed, mostSeed),
                       .passed = json.flag("passed"),
                       .byProgram = json.text("moved_by", nameLetters) == QLatin1String("program"),
                       .commit = json.text("commit", messageLetters)};
    report.checks = readEach<CheckOutcome>(json, "checks", mostChecks, readCheck);
    report.findings = readEach<Finding>(json, "findings", mostReadEntries, readFinding);
    report.remarks = readEach<Remark>(json, "remarks", mostReadEntries, [](JsonFields remark) {
        return Remark{remark.text("id", nameLetters), remark.text("message", messageLetters)};
    });
    if (json.has("error"))
        report.error = readError(JsonFields(json, QStringLiteral("error")));
    return report;
}

Vec2 readVector(JsonFields &json, const char *key)
{
    const QJsonArray pair = json.list(key, 2);
    return {pair.at(0).toDouble(), pair.at(1).toDouble()};
}

DrawnMoment::Body readBody(JsonFields json)
{
    DrawnMoment::Body body{.colour = json.text("colour", 7),
                           .radius = json.number("radius", 0.0, limits::maxLength),
                           .position = readVector(json, "position"),
                           .velocity = readVector(json, "velocity")};
    const QJsonArray way = json.list("way", 2 * static_cast<qsizetype>(mostWayPoints));
    for (qsizetype i = 0; i + 1 < way.size(); i += 2)
        body.way.push_back({way[i].toDouble(), way[i + 1].toDouble()});
    // It goes into a drawing as it is.
    const bool isColour =
        body.colour.size() == 7 && body.colour.startsWith(QLatin1Char('#'))
        && std::all_of(body.colour.begin() + 1, body.colour.end(), [](QChar letter) {
               return QStringLiteral("0123456789abcdefABCDEF").contains(letter);
           });
    if (!isColour)
        json.refuse(QStringLiteral("colour"), ReadingText::tr("a colour like #1e90ff is right"));
    return body;
}

StepMoment readMoment(JsonFields json)
{
    StepMoment moment{.check = json.text("check", nameLetters)};
    moment.scene.halfWidth = json.number("half_width", limits::minLength, limits::maxLength);
    moment.scene.time = json.number("time", 0.0, mostNumber);
    moment.scene.bodies = readEach<DrawnMoment::Body>(
        json, "circles", static_cast<qsizetype>(mostBodiesOfMoment), readBody);
    return moment;
}

StepResult readStep(JsonFields json)
{
    StepResult step{.taskId = json.text("task", nameLetters),
                    .reason = json.text("reason", messageLetters),
                    .program = json.text("program", limits::sourceBytes),
                    .attempts = static_cast<int>(json.integer("attempts", 0, mostLine)),
                    .minutes = json.number("minutes", 0.0, 1e9)};
    if (const auto status = statusFromName(json.text("status", nameLetters)))
        step.status = *status;
    else
        json.refuse(QStringLiteral("status"), ReadingText::tr("there is no such status"));
    if (json.has("values_of"))
        step.drawnBy = json.text("values_of", nameLetters);
    if (json.has("number_handed_in"))
        step.ownNumber = json.text("number_handed_in", nameLetters);
    if (json.has("report"))
        step.report = readReport(JsonFields(json, QStringLiteral("report")));
    step.moments =
        readEach<StepMoment>(json, "moments", static_cast<qsizetype>(mostMoments), readMoment);
    const bool passed = step.status == StepResult::Status::Passed;
    if (passed != (step.report && step.report->passed))
        json.refuse(QStringLiteral("status"),
                    ReadingText::tr("the status and the report say different things"));
    return step;
}

/// Not through the middle of a letter of two parts.
QString cut(const QString &text, qsizetype letters)
{
    if (text.size() <= letters)
        return text;
    const bool parts = text[letters - 1].isHighSurrogate();
    return text.left(parts ? letters - 1 : letters);
}

} // namespace

StudentResult cutToFit(StudentResult result)
{
    for (QString *text : {&result.id, &result.name, &result.number, &result.email})
        *text = cut(*text, nameLetters);
    result.remark = cut(result.remark, messageLetters);
    return result;
}

Result<StudentResult> readStudentResult(const QByteArray &text, const QString &source)
{
    if (text.size() > mostResultBytes)
        return Error{.message = ReadingText::tr("the result is too large"), .file = source};
    QJsonParseError fault;
    const QJsonDocument document = QJsonDocument::fromJson(text, &fault);
    if (fault.error != QJsonParseError::NoError || !document.isObject())
        return Error{.message = ReadingText::tr("this is no result of a student: %1")
                                    .arg(fault.error == QJsonParseError::NoError
                                             ? ReadingText::tr("not a JSON object")
                                             : fault.errorString()),
                     .file = source};
    JsonFields json(document.object(), source);
    if (json.integer("format", 1, 1) != 1 || json.fault())
        return *json.fault();
    JsonFields who(json, QStringLiteral("student"));
    StudentResult result{.id = who.text("id", nameLetters),
                         .name = who.text("name", nameLetters),
                         .number = who.text("number", nameLetters),
                         .email = who.text("email", nameLetters),
                         .seed = json.integer("seed", leastSeed, mostSeed),
                         .lateDays = json.number("late_days", 0.0, 1e6),
                         .remark = json.text("remark", messageLetters)};
    if (who.has("platform"))
        result.platform = platformFrom(who.text("platform", nameLetters));
    result.steps = readEach<StepResult>(json, "steps", mostReadSteps, readStep);
    if (json.fault())
        return *json.fault();
    return result;
}

} // namespace cradle
