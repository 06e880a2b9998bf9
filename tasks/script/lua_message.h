// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle {

// Lua's own messages are English, and short for those who know Lua.

/// What the parser says of a text that it cannot read, in the language of the application;
/// unchanged if it is not one of the usual messages.
[[nodiscard]] QString plainSyntaxMessage(const QString &message);

/// The same for an error of a program that runs, in plainer words.
[[nodiscard]] QString plainRuntimeMessage(const QString &message);

} // namespace cradle
