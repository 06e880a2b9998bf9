// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle::cli {

/// What is wrong with \p code as the value of --language; empty if nothing is.
[[nodiscard]] QString languageFault(const QString &code);

/// Speaks \p code, or English if it is empty, from now on, with numbers as they are written in it
/// whatever the system says: the same work gives the same bytes everywhere.
void speak(const QString &code);

} // namespace cradle::cli
