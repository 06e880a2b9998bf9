// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/class_results.h"

#include "model/file_io.h"
#include "model/json_schema.h"
#include "tasks/grading/student_page.h"
#include "tasks/grading/student_result_json.h"

#include <QDir>

namespace cradle {

std::optional<Error> writeClassResults(const QString &resultsFolder, const Lab &lab,
                                       const ClassFacts &facts,
                                       const std::function<void(int, int)> &progress)
{
    const QDir students(resultsFolder + QStringLiteral("/students"));
    const QStringList names =
        students.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name);
    int done = 0;
    for (const QString &name : names) {
        const QString path = students.filePath(name);
        const auto text = readFile(path, mostResultBytes);
        if (!text)
            return text.error();
        const auto student = readStudentResult(*text, path);
        if (!student)
            return student.error();
        const QString page = students.filePath(name.chopped(4) + QStringLiteral("html"));
        if (auto error = writeFile(page, studentPage(*student, lab, facts)))
            return error;
        if (progress)
            progress(++done, static_cast<int>(names.size()));
    }
    return std::nullopt;
}

} // namespace cradle
