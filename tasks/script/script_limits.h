// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

#include <chrono>
#include <cstddef>

/// What a student's program may use; past a limit the run stops. "A step" is one on_update, or
/// loading the program with on_load.
namespace cradle::limits {

inline constexpr qint64 instructionsPerStep = 5'000'000; ///< of the Lua machine
/// Calls that cannot take as many, by the text of the program, are not counted; see work_bound.h.
/// What asks how much a program works must ask for more.
inline constexpr qint64 uncountedInstructions = 4'000;
/// Nor what they move, as long as a step moves no more bytes of lists and tables than that.
inline constexpr std::size_t uncountedMovedBytes = 64 * 1024;
inline constexpr std::size_t scriptBytes = 64u * 1024 * 1024;
/// Of a live run only, which must not freeze the window; a verdict knows no clock.
inline constexpr std::chrono::seconds wallTimePerStep{2};
inline constexpr qint64 outputBytesPerStep = 64 * 1024;
/// An instruction counts once more for every so many bytes of the longest text that the program
/// has made: it may copy or compare it.
inline constexpr std::size_t textBytesPerInstruction = 1024;
/// So many bytes of lists and tables that are moved to larger blocks count as one.
inline constexpr std::size_t movedBytesPerInstruction = 64;
inline constexpr int callDepth = 20'000; ///< far above what a lab needs
/// Far above what a lab needs. Lua's parser, which nothing counts, takes time that grows with the
/// square of a long chain of conditions: 0.1 s for this.
inline constexpr qsizetype sourceBytes = 128 * 1024;

} // namespace cradle::limits
