// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace cradle {

/// Scenes that ship with the program beside the lab, to look at and to play with.
enum class Example {
    Gas,       ///< a thousand circles that start equally fast
    PistonDrop ///< a heavy circle that falls onto a bed of light ones
};

inline constexpr Example allExamples[] = {Example::Gas, Example::PistonDrop};

/// Its name on the command line and of its file: "gas".
[[nodiscard]] QString idOf(Example example);
[[nodiscard]] std::optional<Example> exampleFromId(const QString &id);

/// The preset's file, in the resources.
[[nodiscard]] QString fileOf(Example example);

/// In the language in force. The text is CommonMark: what there is to see, and how to go back.
[[nodiscard]] QString titleOf(Example example);
[[nodiscard]] QString textOf(Example example);

/// Whether the speeds of its circles are what there is to see.
[[nodiscard]] bool showsSpeeds(Example example);

} // namespace cradle
