// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QByteArray>
#include <QStringList>

#include <vector>

namespace cradle {

/// A table of comma-, semicolon- or tab-separated values (RFC 4180): rows of cells. The separator
/// is the one that the first line has most of.
[[nodiscard]] std::vector<QStringList> tableFrom(const QString &text);

/// Somebody of the class, as the roster has them; what it does not say is empty.
struct RosterRow {
    QString folder{}; ///< or file, of what they handed in
    QString id{};
    QString name{};
    QString number{};
    QString email{};
    double lateDays = 0.0;

    friend bool operator==(const RosterRow &, const RosterRow &) = default;
};

/// Reads a roster: a table whose first line names its columns, in any order and case: "folder",
/// "id", "name" (or "first name" and "last name"), "number", "email", "late days", and the names
/// that the learning platforms use for these. Other columns are passed over.
/// \return an error if there is neither a folder nor an id, or a row that is not right
Result<std::vector<RosterRow>> readRoster(const QString &path);
Result<std::vector<RosterRow>> rosterFrom(const QString &text, const QString &source);

} // namespace cradle
