// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle {

/// Where tests find what lies outside of them. The paths are absolute; \p inside is a path within.
/// They are functions and no definitions, so that tests compile to the same in every clone.
[[nodiscard]] QString sourcePath(const char *inside);
[[nodiscard]] QString fixturePath(const char *inside);
[[nodiscard]] QString buildPath(const char *inside);

/// The programs cradle-cli and cradle, as built.
[[nodiscard]] QString cliProgram();
[[nodiscard]] QString desktopProgram();

/// The running test, as a program: started again it is the same test.
[[nodiscard]] QString ownProgram();

} // namespace cradle
