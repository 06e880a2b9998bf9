// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/work/student_work.h"

#include <QDateTime>

namespace cradle {

// A student's work as one file, NAME-lab-4.2.cradle-work: a zip archive that any tool opens.

/// How the name of such a file ends.
inline constexpr char workSuffix[] = ".cradle-work";

/// What the file says of itself; manifest.json, with the SHA-256 of every other file.
struct WorkManifest {
    struct Step {
        QString id;
        QString verdict; ///< "passed", "not passed", "stopped" or "not done"

        friend bool operator==(const Step &, const Step &) = default;
    };

    QString labId{};
    QString labVersion{};
    QString labHash{};
    QString student{};
    QString studentId{};
    QDateTime when{}; ///< UTC
    qint64 seed = 1;  ///< of the checks
    std::vector<Step> steps{};

    friend bool operator==(const WorkManifest &, const WorkManifest &) = default;
};

/// The name of a student's file: letters that every disk takes.
[[nodiscard]] QString workFileName(const QString &student, const QString &labId);

/// \return the bytes of the archive; the same files make the same
Result<QByteArray> packWork(const WorkFiles &files, const WorkManifest &manifest);

/// Takes a file apart, without trust in it: all that unpackLab() refuses, files that are not in the
/// manifest, and files that are not as it says. Nothing of it is ever run by that.
/// \param source  for messages
Result<WorkFiles> unpackWork(const QByteArray &archive, const QString &source);

/// unpackWork() of a file.
Result<WorkFiles> readWorkArchive(const QString &path);

/// The manifest of unpacked files.
Result<WorkManifest> manifestOf(const WorkFiles &files);

/// Whether \p path is a file that is named like one.
[[nodiscard]] bool isWorkArchive(const QString &path);

} // namespace cradle
