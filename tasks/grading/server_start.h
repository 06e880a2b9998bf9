// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"

#include <sys/types.h>

namespace cradle {

// Two ways to start the process that forks workers, see serveJudging(). It has nothing of the files
// that are open here but \c control, and dies with this process. Both return its id, or -1; what
// startBubblewrapped() returns is a process that watches bubblewrap and ends as the other end of
// \c control is closed.

/// By bubblewrap, as the program \p program with the arguments judge-server and \p language; the
/// lab's files are to be sent to the other end of \p lab.
pid_t startBubblewrapped(const QString &program, const QString &language, int control, int lab);

/// As a fork of this process.
pid_t startForked(const Lab &lab, int control);

/// Waits until \p line is ready for \p what. \return false if the process \p server has ended
/// instead: what it left behind may hold the other end, and never read or write.
bool isReady(pid_t server, int line, short what);

/// Writes \p bytes to the socket \p stream, of which \p server reads the other end, unless that
/// ends.
void sendToServer(pid_t server, int stream, const QByteArray &bytes);

/// Waits for the end of \p server, which one of these has started, and ends what it left behind.
/// \return how it ended, as wait() tells it
int collectServer(pid_t server);

} // namespace cradle
