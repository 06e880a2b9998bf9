// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/runs/run_tables.h"
#include "views/charts/pinned_runs.h"
#include "views/charts/run_curves.h"

#include <QObject>

namespace cradle {

class Sounds;
class Workbench;
struct Panes;

/// Keeps runs to be compared in the charts, or as tables.
class RunDesk final : public QObject
{
    Q_OBJECT
public:
    /// \param curves  of the run that goes on, which the charts show
    /// \param pins    which the charts show, too
    RunDesk(Workbench &workbench, Panes &panes, const RunCurves &curves, PinnedRuns &pins,
            Sounds &sounds);

    [[nodiscard]] PinnedRuns &pins() { return m_pins; }

public slots:
    void pinRun();          ///< keeps the run to be compared with later ones
    void startNewRunHere(); ///< from the moment shown; keeps the run so far
    void exportRun(cradle::RunTable table);
    void resetCharts(); ///< ends their zoom

private:
    void wireCharts();
    [[nodiscard]] RunSource runSource(); ///< of the run that goes on

    Workbench &m_workbench;
    Panes &m_panes;
    const RunCurves &m_curves;
    PinnedRuns &m_pins;
    Sounds &m_sounds;
};

} // namespace cradle
