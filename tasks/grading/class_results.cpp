// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/class_results.h"

#include "model/files/file_io.h"
#include "model/files/json_schema.h"
#include "tasks/grading/class_page.h"
#include "tasks/grading/class_summary.h"
#include "tasks/grading/gradebooks.h"
#include "tasks/grading/grader_files.h"
#include "tasks/grading/student_page.h"
#include "tasks/grading/student_result_json.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace cradle {

namespace {

struct ResultsText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

Result<StudentResult> readResult(const QString &path)
{
    const auto text = readFile(path, mostResultBytes);
    if (!text)
        return text.error();
    auto student = readStudentResult(*text, path);
    // It names files.
    if (student && student->id != QFileInfo(path).completeBaseName())
        return Error{.message = ResultsText::tr("this is the result of \"%1\", whose file has "
                                                "another name")
                                    .arg(student->id),
                     .file = path};
    return student;
}

} // namespace

std::optional<Error> writeClassResults(const QString &resultsFolder, const Lab &lab,
                                       const ClassFacts &facts,
                                       const std::function<void(int, int)> &progress)
{
    const QDir students(resultsFolder + QStringLiteral("/students"));
    const QStringList names =
        students.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name);
    Gradebooks gradebooks(lab, facts);
    ClassSummary summary(lab, facts);
    int done = 0;
    for (const QString &name : names) {
        const auto student = readResult(students.filePath(name));
        if (!student)
            return student.error();
        gradebooks.add(*student);
        summary.add(*student);
        const QString page = students.filePath(student->id + QStringLiteral(".html"));
        if (auto error = writeFile(page, studentPage(*student, lab, facts), Keeping::Derivable))
            return error;
        if (facts.graderFiles) {
            if (auto error = writeGraderFiles(resultsFolder, *student, lab, facts))
                return error;
        }
        if (progress)
            progress(++done, static_cast<int>(names.size()));
    }
    const auto readAgain = [&](int index) { return readResult(students.filePath(names[index])); };
    if (auto error = summary.finish(readAgain))
        return error;
    if (auto error = gradebooks.write(resultsFolder))
        return error;
    return writeFile(resultsFolder + QStringLiteral("/class.html"), classPage(summary, lab, facts));
}

} // namespace cradle
