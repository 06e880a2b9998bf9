// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <variant>

namespace cradle::cli {

/// The work took too long and was killed.
struct Killed {
};
/// The work broke down by this signal.
struct Crashed {
    int signal = 0;
};

/// Does \p work in a process of its own, so that whatever an untrusted program does to it, this one
/// goes on. \p work writes its output itself. No other threads may run.
/// \return what \p work returned, or why it did not
std::variant<int, Killed, Crashed> runApart(const std::function<int()> &work,
                                            std::chrono::milliseconds most);

} // namespace cradle::cli
