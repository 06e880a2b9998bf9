// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/simulate_request.h"
#include "model/run/runner.h"
#include "tasks/runs/run_tables.h"
#include "tasks/script/student_script.h"

#include <array>
#include <functional>

namespace cradle::cli {

/// One run of a scene, by its laws or by a program.
class SimulateRun
{
public:
    /// \param request  must outlive the run
    explicit SimulateRun(const SimulateRequest &request);

    /// Runs to the end, to where the program stops, or until \p goesOn, which is asked with the
    /// share that is done (0 to 1) at least every few hundredths of a second, is false.
    /// \return whether it has not been stopped by \p goesOn
    bool run(const std::function<bool(double share)> &goesOn);

    /// Why the program stopped.
    [[nodiscard]] const std::optional<ProgramError> &error() const { return m_run.error(); }
    [[nodiscard]] double time() const { return m_run.world().time; } ///< that was reached, s
    /// Stepper::mergedFrom()
    [[nodiscard]] std::optional<double> mergedFrom() const { return m_run.mergedFrom(); }

    /// Writes the tables that were asked for. \return what could not be written
    [[nodiscard]] std::optional<Error> writeTables() const;
    /// What became of the run, in two lines or three.
    [[nodiscard]] QByteArray summaryText() const;
    /// The same for other programs; null for the moment from which contacts are merged if they are
    /// not.
    [[nodiscard]] QByteArray summaryJson() const;

private:
    /// A table of the run, which nobody wants if it has no path.
    struct Table {
        RunTable kind;
        QString path;
        QByteArray text;
    };

    void addStep();
    void addState();
    void addHits();
    void print();

    const SimulateRequest &m_request;
    std::optional<StudentScript> m_program;
    Runner m_run;
    std::size_t m_hitCount = 0;
    std::array<Table, 3> m_tables;
};

/// "contacts merged from 2.31 s on"
[[nodiscard]] QString mergedText(double from);

} // namespace cradle::cli
