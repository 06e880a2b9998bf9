// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>
#include <string_view>

namespace cradle {

/// How many instructions one call of a program (of the file itself, of on_load or on_update) takes
/// at most, read from its text alone. What library functions do to long texts and lists is not
/// among them, as those are charged.
///
/// There is a bound where every loop goes over the circles or through written numbers, and where
/// functions are named, called by name, only behind their end, and never handed on as values: then
/// none calls itself, and a library never calls one. Else there may be one that this does not see.
/// \param text     a program that Lua reads
/// \param circles  in the scene
[[nodiscard]] std::optional<qint64> workBound(std::string_view text, std::size_t circles);

/// Whether a call takes so few instructions, by its bound, that they need no count: fewer than
/// limits::uncountedInstructions. What was found of a program is kept in this thread until it is
/// asked of another.
[[nodiscard]] bool takesLittle(const QString &program, std::size_t circles);

} // namespace cradle
