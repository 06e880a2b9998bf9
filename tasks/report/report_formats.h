// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"
#include "tasks/lab/lab.h"

#include <QByteArray>
#include <QStringList>

#include <functional>

class QXmlStreamWriter;

namespace cradle {

/// What a report can be written as, for people and for the programs of graders.
enum class ReportFormat {
    Text,       ///< for a terminal, see tasks/report/report_text.h
    Json,       ///< our own, see tasks/report/report_json.h
    JUnit,      ///< XML for the servers that build and test
    Tap,        ///< Test Anything Protocol, version 13
    Gradescope, ///< its results.json
    Exercism,   ///< its results.json, version 3
    GitHub      ///< what GitHub Classroom's autograding reporter reads, version 1
};

/// "text", "json", "junit", "tap", "gradescope", "exercism" and "github".
[[nodiscard]] QStringList reportFormatNames();

/// What has that name; nullopt if nothing has.
[[nodiscard]] std::optional<ReportFormat> reportFormatFromName(const QString &name);

/// The report in that format, UTF-8. In all of them the diagnosis, or what stopped the program,
/// comes before the findings of the checks.
/// \param program  the name of the program's file, for "FILE:LINE"
/// \param task     the step, for formats that show what was tested; may be null
[[nodiscard]] QByteArray writeReport(const CheckReport &report, ReportFormat format,
                                     const QString &program, const Task *task = nullptr);

/// One test suite for the step, a test case for each check. Valid by the schema junit-10 of the
/// Jenkins plugin xUnit. A check that failed is a failure, one that could not be judged because
/// the program stopped an error; the message stands in the attribute and in the element, since
/// some readers show only the one and some only the other. Remarks are in system-out.
[[nodiscard]] QByteArray writeJUnit(const CheckReport &report, const QString &program);

/// The suite alone, to stand among others.
void writeJUnitSuite(QXmlStreamWriter &xml, const CheckReport &report, const QString &program);
/// A file of suites that is called \p name. \param write  writes what is in it
[[nodiscard]] QByteArray junitFileOf(const QString &name,
                                     const std::function<void(QXmlStreamWriter &)> &write);

/// A test for each check. Whatever explains the verdict is in comments at the top, findings are
/// in a YAML block and, since prove shows no YAML, in comments. Without "Bail out!", which would
/// keep prove from reading the reports of the rest of a class.
[[nodiscard]] QByteArray writeTap(const CheckReport &report, const QString &program);

/// The same without version and plan, to stand among others.
/// \param number  of the last test before it; becomes that of its last one
/// \param prefix  of every test's name: "L42T5: "
[[nodiscard]] QString tapTests(const CheckReport &report, const QString &program, int &number,
                               const QString &prefix);
/// A test without a verdict, which TAP calls skipped; and one that failed unheard.
[[nodiscard]] QString tapSkipped(int number, const QString &name, const QString &reason);
[[nodiscard]] QString tapFailed(int number, const QString &name);

/// A point for each check that passed.
[[nodiscard]] QByteArray writeGradescope(const CheckReport &report, const QString &program);

/// Status "error" only where no check could be judged: then nothing but its message is shown.
/// Otherwise the site shows the first test that failed, which therefore says what explains it.
/// \param task  the step, of which the tests show what they ask; may be null
[[nodiscard]] QByteArray writeExercism(const CheckReport &report, const QString &program,
                                       const Task *task = nullptr);

/// A test for each check, with its points. The action that hands it on takes it as base64.
[[nodiscard]] QByteArray writeGitHub(const CheckReport &report, const QString &program,
                                     const Task *task = nullptr);

/// What a check asks: its program, or its kind with its parameters and scenes as JSON; nothing if
/// the step has no such check.
[[nodiscard]] QString testCodeOf(const Task *task, const QString &checkId);

} // namespace cradle
