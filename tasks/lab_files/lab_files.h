// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QByteArray>
#include <QMap>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace cradle {

/// All files of a lab by their paths below its folder ("L42T1/task.json"), with what they hold.
/// A value: copies share what they have in common, so an undo may keep one for each edit.
struct LabFiles {
    QMap<QString, QByteArray> contents{};

    friend bool operator==(const LabFiles &, const LabFiles &) = default;
};

/// What a lab may be made of; far above what one needs.
namespace limits {
inline constexpr qint64 labFileBytes = 32 * 1024 * 1024;
inline constexpr qint64 labBytes = 128 * 1024 * 1024; ///< all files together
inline constexpr int labFiles = 10'000;
inline constexpr int labDepth = 6;              ///< names in a path
inline constexpr int labPathName = 120;         ///< characters of one name in a path
inline constexpr qint64 labPixels = 32'000'000; ///< of one picture
} // namespace limits

/// What is wrong with \p path as that of a file of a lab; empty if nothing is. Right is a path
/// below the lab's folder, with slashes, of names that every file system takes.
[[nodiscard]] QString faultOfLabPath(const QString &path);

/// What is wrong with a picture: one with more pixels than a screen could show is a bomb or a
/// mistake. Looks at the header only (PNG, JPEG, GIF, BMP). \return empty if nothing is
[[nodiscard]] QString faultOfPicture(const QByteArray &content);

/// Reads all files of a lab's folder (or resource). Names that begin with a dot are not the lab's
/// (".git") and neither are those that end with "~". A file that is too large, cannot be read,
/// is no plain file, or is a link that leaves the folder is named in \p findings and left out;
/// a picture with too many pixels is named, too.
/// \return an error if \p folder is no folder that can be read
Result<LabFiles> readLabFiles(const QString &folder, std::vector<Error> *findings = nullptr);

/// The paths of those files that are not on disk as \p asOnDisk says: another program changed,
/// removed or added them.
[[nodiscard]] QStringList changedOnDisk(const LabFiles &asOnDisk, const QString &folder);

/// \p mine, but what \p theirs has otherwise than \p asOnDisk, as \p theirs has it.
[[nodiscard]] LabFiles withTheirs(const LabFiles &mine, const LabFiles &asOnDisk,
                                  const LabFiles &theirs);

/// What saveLabFiles() does with files that another program changed.
enum class OnConflict { Refuse, Overwrite };

/// Makes the files in \p folder those of \p files: writes what differs, each whole or not at all,
/// lab.json after what it names, and then removes what is in \p asOnDisk alone. A save that is
/// broken off leaves a lab that opens. Creates the folder if there is none.
/// \param asOnDisk  what was last read from, or written to, \p folder; empty if nothing was
/// \return what kept it from being saved: a path that is none, a file that cannot be written, or
///         (if refused) the files that are not as \p asOnDisk says
std::optional<Error> saveLabFiles(const LabFiles &files, const LabFiles &asOnDisk,
                                  const QString &folder,
                                  OnConflict onConflict = OnConflict::Refuse);

} // namespace cradle
