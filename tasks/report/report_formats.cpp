// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/report/report_formats.h"

#include "tasks/report/report_json.h"
#include "tasks/report/report_text.h"
#include "tasks/text/plain_text.h"

#include <QXmlStreamWriter>

#include <algorithm>
#include <array>

namespace cradle {

namespace {

struct Entry {
    const char *name;
    ReportFormat format;
};

constexpr std::array formats{Entry{"text", ReportFormat::Text},
                             Entry{"json", ReportFormat::Json},
                             Entry{"junit", ReportFormat::JUnit},
                             Entry{"tap", ReportFormat::Tap},
                             Entry{"gradescope", ReportFormat::Gradescope},
                             Entry{"exercism", ReportFormat::Exercism},
                             Entry{"github", ReportFormat::GitHub}};

void writeCase(QXmlStreamWriter &xml, const CheckReport &report, std::size_t index,
               const QString &program)
{
    const CheckOutcome &check = report.checks[index];
    xml.writeStartElement(QStringLiteral("testcase"));
    xml.writeAttribute(QStringLiteral("name"), printable(check.title));
    xml.writeAttribute(QStringLiteral("classname"),
                       report.labId + QLatin1Char('.') + report.taskId);
    if (!check.passed) {
        const bool stopped = wasStopped(report, check);
        const QString message = feedbackOn(report, index, program);
        xml.writeStartElement(stopped ? QStringLiteral("error") : QStringLiteral("failure"));
        xml.writeAttribute(QStringLiteral("type"),
                           stopped ? kindName(report.error->kind) : check.id);
        xml.writeAttribute(QStringLiteral("message"), message);
        xml.writeCharacters(message);
        xml.writeEndElement();
    } else if (check.forTeacher) {
        xml.writeTextElement(QStringLiteral("system-out"), feedbackOn(report, index, program));
    }
    xml.writeEndElement();
}

void writeCounts(QXmlStreamWriter &xml, const CheckReport &report)
{
    const auto count = [&](bool stopped) {
        return QString::number(
            std::count_if(report.checks.begin(), report.checks.end(), [&](const CheckOutcome &c) {
                return !c.passed && wasStopped(report, c) == stopped;
            }));
    };
    xml.writeAttribute(QStringLiteral("tests"), QString::number(report.checks.size()));
    xml.writeAttribute(QStringLiteral("failures"), count(false));
    xml.writeAttribute(QStringLiteral("errors"), count(true));
    // The schema knows no more digits than those of a millisecond.
    xml.writeAttribute(QStringLiteral("time"),
                       QString::number(static_cast<double>(report.elapsedMs) / 1000.0, 'f', 3));
}

void writeProperty(QXmlStreamWriter &xml, const char *name, const QString &value)
{
    xml.writeEmptyElement(QStringLiteral("property"));
    xml.writeAttribute(QStringLiteral("name"), QString::fromLatin1(name));
    xml.writeAttribute(QStringLiteral("value"), value);
}

/// The explanation, the verdict and the remarks, for those who read the whole suite.
QString summaryOf(const CheckReport &report, const QString &program)
{
    QStringList parts{verdictOf(report)};
    if (const QString explanation = explanationOf(report, program); !explanation.isEmpty())
        parts.prepend(explanation);
    for (const Remark &remark : report.remarks)
        parts.append(plainText(remark.message, terminalColumns));
    return parts.join(QStringLiteral("\n\n"));
}

} // namespace

QStringList reportFormatNames()
{
    QStringList names;
    for (const Entry &entry : formats)
        names.append(QString::fromLatin1(entry.name));
    return names;
}

std::optional<ReportFormat> reportFormatFromName(const QString &name)
{
    const auto *found = std::find_if(formats.begin(), formats.end(), [&](const Entry &entry) {
        return name == QLatin1String(entry.name);
    });
    return found == formats.end() ? std::nullopt : std::optional(found->format);
}

QByteArray writeReport(const CheckReport &report, ReportFormat format, const QString &program,
                       const Task *task)
{
    switch (format) {
    case ReportFormat::Json:
        return writeReport(report);
    case ReportFormat::JUnit:
        return writeJUnit(report, program);
    case ReportFormat::Tap:
        return writeTap(report, program);
    case ReportFormat::Gradescope:
        return writeGradescope(report, program);
    case ReportFormat::Exercism:
        return writeExercism(report, program, task);
    case ReportFormat::GitHub:
        return writeGitHub(report, program, task);
    case ReportFormat::Text:
        break;
    }
    return describeReport(report, program).toUtf8();
}

void writeJUnitSuite(QXmlStreamWriter &xml, const CheckReport &report, const QString &program)
{
    xml.writeStartElement(QStringLiteral("testsuite"));
    xml.writeAttribute(QStringLiteral("name"), report.taskId);
    writeCounts(xml, report);
    xml.writeStartElement(QStringLiteral("properties"));
    writeProperty(xml, "lab_hash", report.labHash);
    writeProperty(xml, "seed", QString::number(report.seed));
    for (const QString &mistake : mistakesOf(report))
        writeProperty(xml, "mistake", mistake);
    if (isScored(report)) {
        writeProperty(xml, "score", QString::number(scoreOf(report)));
        writeProperty(xml, "max_score", QString::number(fullScoreOf(report)));
    }
    xml.writeEndElement();
    xml.writeTextElement(QStringLiteral("system-out"), summaryOf(report, program));
    for (std::size_t i = 0; i < report.checks.size(); ++i)
        writeCase(xml, report, i, program);
    xml.writeEndElement();
}

QByteArray writeJUnit(const CheckReport &report, const QString &program)
{
    return junitFileOf(report.labId, [&](QXmlStreamWriter &xml) {
        writeCounts(xml, report);
        writeJUnitSuite(xml, report, program);
    });
}

QByteArray junitFileOf(const QString &name, const std::function<void(QXmlStreamWriter &)> &write)
{
    QByteArray text;
    QXmlStreamWriter xml(&text);
    xml.setAutoFormatting(true);
    xml.setAutoFormattingIndent(2);
    xml.writeStartDocument();
    xml.writeStartElement(QStringLiteral("testsuites"));
    xml.writeAttribute(QStringLiteral("name"), name);
    write(xml);
    xml.writeEndDocument();
    return text;
}

} // namespace cradle
