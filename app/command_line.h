// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"
#include "tasks/lab/mode.h"
#include "views/theme.h"

#include <QStringList>

#include <optional>

namespace cradle {

/// What the command line of the window asks for, in its words.
struct CommandLine {
    QString named{};                      ///< a lab or a scene; may be empty
    QString step{};                       ///< empty: where the student left off
    std::optional<QString> example{};     ///< name of an example
    std::optional<QString> language{};    ///< "en" or "de"
    std::optional<QString> theme{};       ///< see themeFrom()
    std::optional<QString> textSize{};    ///< %
    std::optional<QString> mode{};        ///< see modeFrom()
    std::optional<QString> script{};      ///< a file to be the student's program
    std::optional<QString> author{};      ///< folder of a lab that is to be written
    QString tab{};                        ///< of the author's window
    std::optional<QString> screenshot{};  ///< file of a picture
    QString at{};                         ///< s of the scene's time, in the picture
    QString size{};                       ///< of the picture's window; empty: as it comes
    std::optional<QString> printReport{}; ///< folder of a report that is to be printed
    std::optional<QString> setFormulas{}; ///< folder of formulas that are to be set
};

/// Reads the arguments, the program's name first. --help and --version print, and end the program.
[[nodiscard]] Result<CommandLine> parseCommandLine(const QStringList &arguments);

/// Whether a picture, help or version is asked for, which is had without a display.
[[nodiscard]] bool needsNoDisplay(int argc, char **argv);

/// "system", "light" or "dark"; nullopt for any other word.
[[nodiscard]] std::optional<ThemeChoice> themeFrom(const QString &name);

} // namespace cradle
