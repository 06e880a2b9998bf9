// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/class_results.h"
#include "tasks/grading/roster.h"

#include <QByteArray>
#include <QStringList>

#include <vector>

namespace cradle {

/// One student of whom something was found.
struct FoundStudent {
    /// A file that was handed in by itself, as learning platforms give them out.
    struct File {
        QByteArray path;
        QString calledBy; ///< as the student called it

        friend bool operator==(const File &, const File &) = default;
    };

    QString id{};     ///< unlike all others of the class; fit for the name of a file
    QString name{};   ///< of the person, as far as it is known
    QString number{}; ///< of the learning platform or the university; may be empty
    QString email{};
    QStringList rosterNumbers{}; ///< by which the roster knows the student, see JudgingRequest
    Platform platform = Platform::None; ///< that gave out the number
    double lateDays = 0.0;
    QByteArray folder{}; ///< that was handed in; empty if it was files
    std::vector<File> files{};
    QString how{};    ///< how it was understood, for the teacher
    QString remark{}; ///< what is strange about it

    friend bool operator==(const FoundStudent &, const FoundStudent &) = default;
};

/// A class as a folder of what was handed in; nothing in it was read yet.
struct ClassFolder {
    QByteArray root{};                     ///< nothing outside is ever read
    std::vector<FoundStudent> students{};  ///< by id
    Platform platform = Platform::None;    ///< that most of it was downloaded from
    std::vector<MissingStudent> missing{}; ///< who is in the roster and handed in nothing
    QStringList remarks{};                 ///< what was not understood
};

/// Understands the folder \p path: of folders, of .cradle-work or .lua files, or a download of
/// Moodle, Canvas or Blackboard, or clones of GitHub Classroom, in any mixture. A folder that holds
/// nothing but one other is gone into.
/// \param roster  names students, and who is missing; may be empty
Result<ClassFolder> readClassFolder(const QByteArray &path, const QString &labId,
                                    const std::vector<RosterRow> &roster = {});

/// The students of shard \p index of \p count (from 1), in turn: every student is in one.
[[nodiscard]] std::vector<FoundStudent> shardOf(const std::vector<FoundStudent> &students,
                                                int index, int count);

} // namespace cradle
