// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace cradle::cli {

/// From now on a first Ctrl+C (SIGINT, SIGTERM) is noticed by who asks stopAsked(); a second ends
/// the process.
void watchForStop();

/// Whether the user wants the work to end.
[[nodiscard]] bool stopAsked();

} // namespace cradle::cli
