// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"
#include "tasks/lab_files/lab_files.h"
#include "tasks/reading/lab_list.h"

namespace cradle {

// A lab as one file, NAME.cradle: a zip archive of its files, with lab.json at its root or in the
// one folder that there is.

/// How the name of such a file ends.
inline constexpr char archiveSuffix[] = ".cradle";

/// The same files make the same bytes: sorted, without times and owners.
/// \return an error for a path that is none, or if there is no lab.json
Result<QByteArray> packLab(const LabFiles &files);

/// The same of any files, with whose paths nothing is wrong.
Result<QByteArray> packFiles(const QMap<QString, QByteArray> &contents);

/// Takes an archive apart, without trust in it: refused are more or larger files than a lab may
/// have (as declared or as unpacked), absurd ratios of compression, paths out of the lab, links,
/// names that are no UTF-8 or that clash, encrypted and broken entries.
/// \param source  the archive's name for messages
Result<LabFiles> unpackLab(const QByteArray &archive, const QString &source);

/// The same of an archive of other files, which has \p index in the place of lab.json.
Result<LabFiles> unpackFiles(const QByteArray &archive, const QString &source,
                             const QString &index);

/// packLab() into a file, whole or not at all.
std::optional<Error> exportLab(const LabFiles &files, const QString &path);
/// unpackLab() of a file.
Result<LabFiles> readLabArchive(const QString &path);

/// Whether \p path is a file that is named like an archive.
[[nodiscard]] bool isLabArchive(const QString &path);

/// readLab() of a folder or, without unpacking it to disk, of an archive.
Result<Lab> readLabOrArchive(const QString &path, const QString &language = QStringLiteral("en"));

/// Where the labs of the user are: "labs" in the application's data.
[[nodiscard]] QString userLabsFolder();

/// Unpacks an archive into a new folder of \p labs, all of it or nothing. The folder has the
/// archive's name, or if another lab has that already, the name with a number; a lab that is
/// there already with the same files is not unpacked again.
/// \param replaced  folder of a lab that gives way to it, once all of it is there; empty: none does
/// \return the folder
Result<QString> importLab(const QString &path, const QString &labs = userLabsFolder(),
                          const QString &replaced = {});

/// A lab of \p labs that an archive may be an update of: it has the same id and other files.
struct OlderLab {
    ListedLab lab{};
    QString newVersion{}; ///< of the archive
};
/// \return nothing also if the archive cannot be read, or is there already
[[nodiscard]] std::optional<OlderLab> olderThan(const QString &path,
                                                const QString &labs = userLabsFolder());

} // namespace cradle
