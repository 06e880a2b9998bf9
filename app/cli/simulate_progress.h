// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>

namespace cradle::cli {

/// Tells on a terminal how far a run has come, once it takes longer than a moment; elsewhere
/// nothing, as standard error has the program's words there.
class SimulateProgress
{
public:
    SimulateProgress();
    ~SimulateProgress(); ///< clears the line
    SimulateProgress(const SimulateProgress &) = delete;
    SimulateProgress &operator=(const SimulateProgress &) = delete;

    void show(double share); ///< 0 to 1; costs next to nothing if it was called just before

private:
    bool m_onTerminal;
    bool m_stands = false;
    qint64 m_shown = 0; ///< ms
    QElapsedTimer m_timer{};
};

} // namespace cradle::cli
