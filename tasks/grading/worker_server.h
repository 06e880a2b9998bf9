// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/lockdown.h"
#include "tasks/lab/lab.h"
#include "tasks/lab_files/lab_files.h"

namespace cradle {

/// What one worker may send at all, bytes.
inline constexpr qint64 mostWorkerBytes = 64 * 1024 * 1024;
/// Of memory that a worker may take beyond what it begins with.
inline constexpr qint64 mostWorkerMemory = 256 * 1024 * 1024;

/// Forks a worker for every student who is to be judged, until the other end of \p control is gone;
/// then the workers are gone, too. The lab is there already, so that a worker costs a millisecond.
/// No other threads may run.
void serveJudging(int control, const Lab &lab);

/// The numbers of the descriptors with which runJudgingServer() is started.
inline constexpr int serverControl = 3;
inline constexpr int serverLab = 4;

/// The same as a program of its own, that bubblewrap starts in namespaces: the lab comes through
/// serverLab. \param language  of the lab's texts \return what to exit with
int runJudgingServer(const QString &language);

/// The lab's files for the way there.
[[nodiscard]] QByteArray bytesOf(const LabFiles &files, const QString &folder);

} // namespace cradle
