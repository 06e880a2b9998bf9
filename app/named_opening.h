// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <optional>

namespace cradle {

class MainWindow;
class Workbench;

// What the command line names is opened. Each returns what is wrong with it.

/// Opens a lab, a scene, or with both a step and a scene that scene as the student's work on the
/// step; Lab 4.2 if \p named is empty. An archive is unpacked into \p labs first.
[[nodiscard]] std::optional<Error> openNamed(Workbench &bench, const QString &named,
                                             const QString &step, const QString &labs);

/// Opens the example called \p name.
[[nodiscard]] std::optional<Error> openExampleNamed(Workbench &bench, const QString &name);

/// Opens \p lab to be written, at \p step if one is named, with the tab called \p tab in front. An
/// archive is unpacked into \p labs first.
[[nodiscard]] std::optional<Error> openAuthor(MainWindow &window, const QString &lab,
                                              const QString &step, const QString &tab,
                                              const QString &labs);

} // namespace cradle
