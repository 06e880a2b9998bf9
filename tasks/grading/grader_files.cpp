// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/grader_files.h"

#include "model/files/file_io.h"
#include "tasks/report/report_formats.h"
#include "tasks/report/report_text.h"
#include "tasks/text/plain_text.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QXmlStreamWriter>

namespace cradle {

namespace {

struct FilesText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

/// As the student named it.
QString programName(const Task &task)
{
    return task.id + QStringLiteral(".lua");
}

QJsonObject parsed(const QByteArray &text)
{
    return QJsonDocument::fromJson(text).object();
}

bool hasAllVerdicts(const StudentResult &student, const Lab &lab)
{
    return pointsOf(student, lab).earned.has_value();
}

/// Why there is no report of a step.
QString reasonOf(const StepResult &step)
{
    if (!step.reason.isEmpty())
        return step.reason;
    return step.status == StepResult::Status::NotGraded ? FilesText::tr("not graded")
                                                        : FilesText::tr("Nothing was handed in");
}

/// The tests of a step in another's JSON, each with the step in front of its name.
void append(QJsonArray &tests, const QJsonObject &json, const Task &task)
{
    for (const QJsonValue &value : json.value(QStringLiteral("tests")).toArray()) {
        QJsonObject test = value.toObject();
        test.insert(QStringLiteral("name"),
                    task.id + QStringLiteral(": ") + test.value(QStringLiteral("name")).toString());
        for (const QString &key : {QStringLiteral("score"), QStringLiteral("max_score")}) {
            if (test.contains(key))
                test.insert(key, test.value(key).toDouble() * pointScale(task));
        }
        tests.append(test);
    }
}

/// A step of which nothing was handed in, or what was cannot be read, as one test.
QJsonObject unheard(const StepResult &step, const Task &task, const char *message)
{
    return {{QStringLiteral("name"), QStringLiteral("%1: %2").arg(task.id, task.title)},
            {QStringLiteral("score"), 0.0},
            {QString::fromLatin1(message), printable(reasonOf(step))}};
}

void writeEmptySuite(QXmlStreamWriter &xml, const StepResult &step, const Task &task,
                     const QString &labId)
{
    const bool skipped = step.status == StepResult::Status::NotGraded;
    xml.writeStartElement(QStringLiteral("testsuite"));
    xml.writeAttribute(QStringLiteral("name"), task.id);
    xml.writeAttribute(QStringLiteral("tests"), QStringLiteral("1"));
    xml.writeAttribute(QStringLiteral("failures"), QString::number(skipped ? 0 : 1));
    xml.writeAttribute(QStringLiteral("errors"), QStringLiteral("0"));
    xml.writeAttribute(QStringLiteral("skipped"), QString::number(skipped ? 1 : 0));
    xml.writeStartElement(QStringLiteral("testcase"));
    xml.writeAttribute(QStringLiteral("name"), printable(task.title));
    xml.writeAttribute(QStringLiteral("classname"), labId + QLatin1Char('.') + task.id);
    xml.writeStartElement(skipped ? QStringLiteral("skipped") : QStringLiteral("failure"));
    xml.writeAttribute(QStringLiteral("message"), printable(reasonOf(step)));
    xml.writeEndElement();
    xml.writeEndElement();
    xml.writeEndElement();
}

} // namespace

QByteArray gradescopeFile(const StudentResult &student, const Lab &lab, const ClassFacts &facts)
{
    if (!hasAllVerdicts(student, lab))
        return {};
    QJsonArray tests;
    QStringList output;
    for (const Task &task : lab.tasks) {
        const StepResult &step = resultOf(student, task);
        if (step.report) {
            const QJsonObject json = parsed(writeGradescope(*step.report, programName(task)));
            append(tests, json, task);
            output.append(
                QStringLiteral("## %1 · %2\n\n%3")
                    .arg(task.id, task.title, json.value(QStringLiteral("output")).toString()));
        } else {
            QJsonObject test = unheard(step, task, "output");
            test.insert(QStringLiteral("max_score"), mostPoints(task));
            test.insert(QStringLiteral("status"), QStringLiteral("failed"));
            tests.append(test);
        }
    }
    const Points points = pointsOf(student, lab, facts.late);
    return QJsonDocument(
               QJsonObject{{QStringLiteral("score"), *points.earned},
                           {QStringLiteral("output"), output.join(QStringLiteral("\n\n"))},
                           {QStringLiteral("output_format"), QStringLiteral("md")},
                           {QStringLiteral("tests"), tests},
                           {QStringLiteral("extra_data"),
                            QJsonObject{{QStringLiteral("lab"), lab.id},
                                        {QStringLiteral("lab_hash"), lab.hash},
                                        {QStringLiteral("late_days"), student.lateDays}}}})
        .toJson();
}

QByteArray gitHubFile(const StudentResult &student, const Lab &lab)
{
    if (!hasAllVerdicts(student, lab))
        return {};
    QJsonArray tests;
    bool passed = true;
    double most = 0.0;
    for (const Task &task : lab.tasks) {
        const StepResult &step = resultOf(student, task);
        most += mostPoints(task);
        passed = passed && step.status == StepResult::Status::Passed;
        if (step.report) {
            append(tests, parsed(writeGitHub(*step.report, programName(task), &task)), task);
        } else {
            QJsonObject test = unheard(step, task, "message");
            test.insert(QStringLiteral("status"), QStringLiteral("fail"));
            tests.append(test);
        }
    }
    return QJsonDocument(QJsonObject{{QStringLiteral("version"), 1},
                                     {QStringLiteral("status"),
                                      passed ? QStringLiteral("pass") : QStringLiteral("fail")},
                                     {QStringLiteral("max_score"), most},
                                     {QStringLiteral("tests"), tests}})
        .toJson();
}

QByteArray junitFile(const StudentResult &student, const Lab &lab)
{
    return junitFileOf(lab.id, [&](QXmlStreamWriter &xml) {
        for (const Task &task : lab.tasks) {
            const StepResult &step = resultOf(student, task);
            if (step.report)
                writeJUnitSuite(xml, *step.report, programName(task));
            else
                writeEmptySuite(xml, step, task, lab.id);
        }
    });
}

QByteArray tapFile(const StudentResult &student, const Lab &lab)
{
    QString tests;
    int number = 0;
    for (const Task &task : lab.tasks) {
        const StepResult &step = resultOf(student, task);
        const QString prefix = task.id + QStringLiteral(": ");
        if (step.report)
            tests += tapTests(*step.report, programName(task), number, prefix);
        else if (step.status == StepResult::Status::NotGraded)
            tests += tapSkipped(++number, prefix + task.title, reasonOf(step));
        else
            tests +=
                tapFailed(++number, prefix + task.title + QStringLiteral(": ") + reasonOf(step));
    }
    return (QStringLiteral("TAP version 13\n1..%1\n").arg(number) + tests).toUtf8();
}

QByteArray exercismFile(const StepResult &step, const Task &task)
{
    return step.report ? writeExercism(*step.report, programName(task), &task) : QByteArray();
}

std::optional<Error> writeGraderFiles(const QString &folder, const StudentResult &student,
                                      const Lab &lab, const ClassFacts &facts)
{
    struct File {
        QString path;
        QByteArray text;
    };
    const QString id = student.id;
    std::vector<File> files{
        {QStringLiteral("gradescope/%1.json").arg(id), gradescopeFile(student, lab, facts)},
        {QStringLiteral("github/%1.json").arg(id), gitHubFile(student, lab)},
        {QStringLiteral("junit/%1.xml").arg(id), junitFile(student, lab)},
        {QStringLiteral("tap/%1.tap").arg(id), tapFile(student, lab)}};
    for (const Task &task : lab.tasks)
        files.push_back({QStringLiteral("exercism/%1/%2.json").arg(id, task.id),
                         exercismFile(resultOf(student, task), task)});
    for (const File &file : files) {
        const QString path = folder + QLatin1Char('/') + file.path;
        if (file.text.isEmpty()) {
            // What an earlier grading wrote is no longer true.
            QFile::remove(path);
            continue;
        }
        if (auto error = makeFolder(path.section(QLatin1Char('/'), 0, -2)))
            return error;
        if (auto error = writeFile(path, file.text, Keeping::Derivable))
            return error;
    }
    return std::nullopt;
}

} // namespace cradle
