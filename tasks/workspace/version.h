// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <QStringList>

#include <optional>

namespace cradle {

/// Why a state of a program was kept.
enum class VersionReason {
    Typed,   ///< some minutes of changed text, or the step was left
    Checked, ///< it was judged; the note has the verdict
    Before,  ///< it was about to be replaced: by another version, or by what the step started from
    Outside, ///< another program changed the file
    Unsaved  ///< the window that had it was not, or no longer, the one that saves
};

/// What is known about a state of a program besides its text; kept as trailers of a commit.
struct VersionNote {
    VersionReason reason = VersionReason::Typed;
    std::optional<bool> passed{}; ///< if it was judged
    qint64 seed = 0;              ///< of that check
    QString labHash{};            ///< of the lab that judged it
    QStringList findings{};       ///< names of what was found wrong

    friend bool operator==(const VersionNote &, const VersionNote &) = default;
};

/// A kept state of a step's program.
struct Version {
    QString id;     ///< of its commit: 40 hexadecimal digits
    QString taskId; ///< of the step
    QDateTime when; ///< UTC
    VersionNote note{};

    friend bool operator==(const Version &, const Version &) = default;
};

/// The message of a version's commit: a subject in English, and the note as trailers.
[[nodiscard]] QString versionMessage(const QString &taskId, const VersionNote &note);
/// The note of a message, whoever wrote it; what is not there stays as it is by default.
[[nodiscard]] VersionNote versionNote(const QString &message);
/// The value of the last trailer "KEY: value" of a commit's message; empty if there is none.
[[nodiscard]] QString trailerOf(const QString &message, const QString &key);

/// The message of the commit that is made when a step is passed: the lab's own, and the note.
[[nodiscard]] QString passMessage(const QString &taskId, const QString &subject,
                                  const VersionNote &note);

} // namespace cradle
