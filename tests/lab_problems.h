// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/proof/lab_verifier.h"
#include "tasks/reading/lab_reader.h"
#include "tests/authoring_labs.h"

namespace cradle::authoring {

/// Words with a space between two.
inline QStringList words(const char *list)
{
    return text(list).split(QLatin1Char(' '));
}

/// What the reader and the verifier say of a lab.
inline QStringList problemsOf(const LabFiles &files, const QString &language)
{
    const Result<Lab> lab = readLab(files, text("lab"), language);
    if (!lab)
        return {lab.error().toString()};
    QStringList problems;
    for (const Error &finding : lab->findings)
        problems.append(finding.toString());
    for (const VerifiedTask &task : verifyLab(*lab)) {
        for (const LabFinding &finding : task.findings)
            problems.append(finding.message);
    }
    return problems;
}

} // namespace cradle::authoring
