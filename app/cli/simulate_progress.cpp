// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/simulate_progress.h"

#include <QCoreApplication>
#include <QTextStream>

#include <cstdio>

#include <unistd.h>

namespace cradle::cli {

namespace {

struct SoFarText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

constexpr qint64 between = 200; ///< ms

} // namespace

SimulateProgress::SimulateProgress()
    : m_onTerminal(isatty(STDERR_FILENO) == 1)
{
    m_timer.start();
}

SimulateProgress::~SimulateProgress()
{
    if (m_stands)
        QTextStream(stderr) << QStringLiteral("\r\x1b[K") << Qt::flush;
}

void SimulateProgress::show(double share)
{
    if (!m_onTerminal || m_timer.elapsed() - m_shown < between)
        return;
    m_shown = m_timer.elapsed();
    m_stands = true;
    QTextStream(stderr)
        << QStringLiteral("\r\x1b[K")
        << SoFarText::tr("%1 % of the run; Ctrl+C ends it here").arg(100.0 * share, 0, 'f', 1)
        << Qt::flush;
}

} // namespace cradle::cli
