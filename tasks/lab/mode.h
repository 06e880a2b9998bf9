// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"

#include <optional>

namespace cradle {

/// How a student works on a step.
enum class Mode {
    Explore, ///< sets the engine's laws
    Code     ///< writes the program that moves the circles
};

/// "explore" or "code": a mode in texts of labs and on the command line.
[[nodiscard]] QString wordOf(Mode mode);
/// The mode of that word; nullopt for any other.
[[nodiscard]] std::optional<Mode> modeFrom(const QString &word);
/// The words that begin a part of a step's text: those of the modes, and "all" for both.
[[nodiscard]] QStringList partWords();

/// The parts of a step's text that are for \p mode. A line "<!-- explore -->" or "<!-- code -->"
/// begins a part for one mode, "<!-- all -->" one for both.
[[nodiscard]] QString textFor(Mode mode, const QString &markdown);

/// The step with the texts of \p mode: instructions and hints.
[[nodiscard]] Task taskFor(Mode mode, Task task);

} // namespace cradle
