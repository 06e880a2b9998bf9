// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QSet>
#include <QString>
#include <QStringList>

#include <optional>

namespace cradle {

/// Where a name, or a number of a student, comes from.
enum class Platform { None, Moodle, Canvas, Blackboard, GitHub };

/// What a learning platform says by the name of a file or folder that it gives out.
struct PlatformName {
    Platform platform = Platform::None;
    QString student{}; ///< who it belongs to: the same for all files of one student
    QString number{};  ///< of the student on the platform: Moodle, Canvas; the account: Blackboard
    /// Blackboard: what stands before the account, of which it may hold a part, as both may have
    /// a `_`: what follows the last one is taken for it here.
    QString assignment{};
    QString attempt{}; ///< Blackboard: its time; later ones sort later
    QString file{};    ///< as the student called it; empty for a folder, or what is no work
    bool late = false; ///< Canvas says so

    friend bool operator==(const PlatformName &, const PlatformName &) = default;
};

/// Reads a name as the platforms make them:
///     Moodle      Ada Lovelace_1234567_assignsubmission_file_ (or …_file_lab.lua)
///     Canvas      lovelaceada_LATE_12345_67890_lab.lua
///     Blackboard  Lab 4.2_alovelace_attempt_2026-05-01-12-30-00_lab.lua (or ….txt, with the name)
/// \return nothing if it is none of these
[[nodiscard]] std::optional<PlatformName> platformName(const QString &name, bool isFolder);

/// Where the accounts begin in Blackboard's ASSIGNMENT_ACCOUNT, as both may hold a `_`.
struct BlackboardAccounts {
    QHash<QString, QString> byHead{}; ///< by ASSIGNMENT_ACCOUNT
    QString common{};                 ///< the words that all have in front
    bool isGuess = false;             ///< some could begin elsewhere
};

/// Takes an account of \p known (in folded case) where there is one, else what follows the words
/// that all \p heads have in front, else what follows the last `_`.
[[nodiscard]] BlackboardAccounts blackboardAccounts(const QStringList &heads,
                                                    const QSet<QString> &known);

/// "Moodle", "Canvas", "Blackboard", "GitHub" or nothing; and back.
[[nodiscard]] QString platformText(Platform platform);
[[nodiscard]] Platform platformFrom(const QString &text);

} // namespace cradle
