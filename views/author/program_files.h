// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/lab_edits.h"

#include <QFileInfo>

#include <optional>

namespace cradle {

// The programs of a step by their files below its folder: "solution.lua", "mistakes/NAME.lua".

/// None for starter and solution.
[[nodiscard]] inline std::optional<KnownKind> kindOfProgram(const QString &file)
{
    if (file.startsWith(QLatin1String("mistakes/")))
        return KnownKind::Mistake;
    return file.startsWith(QLatin1String("remarks/")) ? std::optional(KnownKind::Remark)
                                                      : std::nullopt;
}

[[nodiscard]] inline QString nameOfProgram(const QString &file)
{
    return QFileInfo(file).completeBaseName();
}

[[nodiscard]] inline QString fileOfProgram(KnownKind kind, const QString &name)
{
    return knownPath(QString(), kind, name).mid(1);
}

/// Mistakes, then remarks.
[[nodiscard]] inline QStringList knownPrograms(const LabFiles &files, const QString &step)
{
    QStringList programs;
    for (const KnownKind kind : {KnownKind::Mistake, KnownKind::Remark}) {
        for (const QString &name : knownNames(files, step, kind))
            programs.append(fileOfProgram(kind, name));
    }
    return programs;
}

} // namespace cradle
