// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"
#include "model/world/result.h"

#include <QCommandLineParser>

#include <optional>

namespace cradle::cli {

/// What "cradle-cli simulate" was asked for.
struct SimulateRequest {
    Preset preset{};
    qint64 steps = 0;
    qint64 every = 1;
    std::optional<QString> program{}; ///< a student's, in place of the laws
    QString programFile{};            ///< as the user gave it
    QString states{};                 ///< files; empty if not wanted, "-" for standard output
    QString totals{};
    QString events{};
    bool asJson = false; ///< the summary, which is then wanted beside tables, too

    [[nodiscard]] bool wantsSummary() const
    {
        return asJson || (states.isEmpty() && totals.isEmpty() && events.isEmpty());
    }
};

/// Tells the parser what can be asked for.
void addSimulateOptions(QCommandLineParser &parser);

/// Reads the preset and the program and lays the options over them.
Result<SimulateRequest> readSimulateRequest(const QCommandLineParser &parser);

} // namespace cradle::cli
