// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"
#include "tasks/lab_files/lab_files.h"

namespace cradle {

/// The labs that ship inside the program; the first is the one that opens by itself.
inline constexpr char shippedLab[] = ":/labs/lab-4.2";
inline constexpr char bouncingBallLab[] = ":/labs/bouncing-ball";

/// Reads a lab's folder. Steps that cannot be read are left out and named in Lab::findings; texts
/// are taken in \p language ("de") where the lab has them, else in its own.
/// \return an error if there is no lab.json that can be read
Result<Lab> readLab(const QString &folder, const QString &language = QStringLiteral("en"));

/// A lab with the files that it was read from.
struct ReadLab {
    LabFiles files{};
    Lab lab{};
};

/// readLab() that gives the files, too, for who else is to read the same.
/// \param step  a step to be read alone, with the files that it needs; the hash stays that of the
///              whole lab. Empty, or not to be found: all steps.
Result<ReadLab> readLabWithFiles(const QString &folder,
                                 const QString &language = QStringLiteral("en"),
                                 const QString &step = {});
/// The same of files that are at hand.
Result<ReadLab> readLabWithFiles(LabFiles files, const QString &folder, const QString &language,
                                 const QString &step = {});

/// The same of files that are at hand: of an author's unsaved lab, or of an archive.
/// \param folder   where they lie or will lie, for messages and pictures
/// \param student  number of the one for whom values are drawn; empty: the first of each range
Result<Lab> readLab(const LabFiles &files, const QString &folder,
                    const QString &language = QStringLiteral("en"), const QString &student = {});

/// \p lab as the student with that number has it: itself, if it draws no values.
[[nodiscard]] Lab forStudent(const Lab &lab, const QString &student);

} // namespace cradle
