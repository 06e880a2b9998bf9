// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_files/lab_files.h"

namespace cradle {

// The named values of a lab and of its steps as a form edits them.

/// One of "values" in lab.json or task.json.
struct ValueForm {
    QString name;
    QString expression{}; ///< a number is one, too; not written if the value is drawn
    bool drawn = false;   ///< for each student, one of from, from + step … to
    double from = 0.0;
    double to = 0.0;
    double step = 0.0; ///< > 0

    friend bool operator==(const ValueForm &, const ValueForm &) = default;
};

/// The values of a step, or of the lab if \p step is empty, in order of the alphabet; none if the
/// file cannot be read.
[[nodiscard]] std::vector<ValueForm> valueForms(const LabFiles &files, const QString &step);

/// Writes \p values in place of those of a step, or of the lab if \p step is empty.
/// \return an error about a file that cannot be read, or a value that cannot be written
[[nodiscard]] Result<LabFiles> withValueForms(const LabFiles &files, const QString &step,
                                              const std::vector<ValueForm> &values);

/// What is wrong with one of these values; empty if nothing is.
[[nodiscard]] QString faultOfValue(const LabFiles &files, const QString &step, const QString &name);

/// All numbers that a drawn value may have, at most \p most of them; empty if the range is none.
[[nodiscard]] std::vector<double> numbersOf(const ValueForm &value, int most);
/// How many these are in all.
[[nodiscard]] int countOf(const ValueForm &value);

/// The files in which an expression names the value: those of the step, or of all steps that have
/// none of that name themselves.
[[nodiscard]] QStringList filesUsing(const LabFiles &files, const QString &step,
                                     const QString &name);

/// The text that, with the lab's id, decides what is drawn for whom; change it every year.
[[nodiscard]] QString drawOf(const LabFiles &files);
[[nodiscard]] Result<LabFiles> withDraw(const LabFiles &files, const QString &draw);

} // namespace cradle
