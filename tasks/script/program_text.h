// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QByteArray>
#include <QString>

#include <optional>

namespace cradle {

/// The bytes of a program's file as text: UTF-8 without NUL, at most limits::sourceBytes.
/// \param path  for messages
/// \return an error that says what they are instead, and in which line
Result<QString> programFrom(const QByteArray &bytes, const QString &path);

/// Reads such a file; never more of it than a program may have.
Result<QString> readProgram(const QString &path);

/// What bytes that are no program probably mean as text: UTF-16 (as some editors of Windows save),
/// else Latin-1 with NUL left out.
/// \return nothing if that is no program either: it is too long
[[nodiscard]] std::optional<QString> convertedProgram(const QByteArray &bytes);

} // namespace cradle
