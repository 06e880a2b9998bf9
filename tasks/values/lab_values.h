// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_files/lab_files.h"

#include <QJsonObject>

namespace cradle {

// The named values of a lab and its steps, "values" in lab.json and task.json: numbers, expressions
// of other values, or { "from": 0.6, "to": 0.9, "step": 0.05 }, drawn for each student.

/// Values by their names.
using Values = QMap<QString, double>;

/// Whether the lab or a step draws a value for each student.
[[nodiscard]] bool drawsValues(const LabFiles &files);

/// How many values a range has; 0 if it is none.
[[nodiscard]] int countOfRange(const QJsonObject &range);
/// Its value at \p index, from 0, as it would be written: 0.6 + 3*0.05 is 0.75.
[[nodiscard]] double numberOfRange(const QJsonObject &range, int index);

/// A student's number however it is written: letters and digits alone, small, without zeros in
/// front, as spreadsheets drop them. Numbers that are alike in this draw the same values.
[[nodiscard]] QString plainNumber(const QString &number);

/// The values of a step (of the lab alone if \p step is empty) for the student with that number;
/// empty: the first of every range. The same for the same lab and number, everywhere: drawn by
/// HMAC-SHA-256 of name and number under the lab's id and its "draw", which changes from year to
/// year.
/// \param faults  what is wrong with them; may be null
[[nodiscard]] Values valuesOf(const LabFiles &files, const QString &step, const QString &student,
                              std::vector<Error> *faults = nullptr);

/// \p files with their values put in: {{EXPRESSION}} in texts and programs; in scenes and in
/// parameters of checks an expression in the place of a number. Files of a lab without values are
/// as they are, but for the expressions in scenes and those in parameters of checks. A text with a
/// fault stays as it is; a JSON file with one is left out.
[[nodiscard]] LabFiles withValues(const LabFiles &files, const QString &student,
                                  std::vector<Error> *faults = nullptr);

} // namespace cradle
