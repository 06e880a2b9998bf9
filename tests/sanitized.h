// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace cradle {

/// Sanitizers look at what code does, and take some seven times as long: of \p many cases that go
/// through the same code they are shown one. Without sanitizers all are tried.
/// \return of how many cases one is to be taken
#if defined(CRADLE_SANITIZED)
constexpr int oneOf(int many)
{
    return many;
}
#else
constexpr int oneOf(int /*many*/)
{
    return 1;
}
#endif

} // namespace cradle
