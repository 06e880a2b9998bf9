// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QStringList>

namespace cradle {

/// Begins a table that people open with Excel, which takes what has no mark for the system's own
/// letters. Readers that know nothing of it find it in the first name of the first row.
inline constexpr char byteOrderMark[] = "\xEF\xBB\xBF";

/// A row of CSV by RFC 4180 (UTF-8, quotes where they are needed, CRLF). A text that a spreadsheet
/// would take for a formula (it begins with = + - @ or a tab) gets an apostrophe in front; control
/// characters and line ends become spaces.
/// \param quoteAll  for readers that want every field in quotes
[[nodiscard]] QByteArray csvRow(const QStringList &fields, bool quoteAll = false);

} // namespace cradle
