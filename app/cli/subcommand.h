// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QCommandLineParser>
#include <QStringList>

#include <optional>

namespace cradle::cli {

/// What the programs of a grader look at.
enum ExitCode {
    Done = 0,      ///< done, and all passed
    NotPassed = 1, ///< done, and something did not pass
    BadInput = 2,  ///< wrong usage or unreadable input
    Defect = 3,    ///< a defect of ours
    Stopped = 130  ///< by Ctrl+C, as shells have it
};

/// Runs "cradle-cli NAME ARGUMENTS…"; \p arguments begin with the program's name.
using Subcommand = ExitCode (*)(const QStringList &arguments);

ExitCode check(const QStringList &arguments);
ExitCode exportLab(const QStringList &arguments);
ExitCode grade(const QStringList &arguments);
ExitCode handIn(const QStringList &arguments);
ExitCode report(const QStringList &arguments);
ExitCode simulate(const QStringList &arguments);
ExitCode suggest(const QStringList &arguments);
ExitCode verify(const QStringList &arguments);

/// Writes "cradle-cli: message" or "FILE:LINE: message" to standard error.
ExitCode complain(const QString &message);
ExitCode complain(const Error &error);
/// The same about what could not be written, for which nobody's work is to blame.
ExitCode complainUnwritten(const Error &error);

/// Parses; on a fault says so. \return what to exit with, or nullopt to go on
std::optional<ExitCode> parse(QCommandLineParser &parser, const QStringList &arguments,
                              int leastPositional, int mostPositional);

/// Writes \p text to \p path whole or not at all; "-" or an empty path is standard output.
std::optional<Error> writeText(const QString &path, const QByteArray &text);

} // namespace cradle::cli
