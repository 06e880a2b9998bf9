// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/hand_in/work_archive.h"
#include "tasks/lab_report/lab_report.h"

namespace cradle {

/// Who hands in, and what they say.
struct Sender {
    QString name{};
    QString number{};
    QString note{}; ///< to the teacher
};

/// What is handed in, judged anew, before it is packed.
struct HandIn {
    WorkFiles files{};  ///< of the work
    LabReport report{}; ///< what a report tells
    WorkManifest manifest{};
};

/// Gathers the work in \p folder, judges every step anew and makes what is told about it.
/// \param progress, cancelled  see makeLabReport()
Result<HandIn> gatherHandIn(const Lab &lab, const QString &folder, const Sender &sender,
                            qint64 seed, const QDateTime &when,
                            const std::function<void(int done, int total)> &progress = {},
                            const std::atomic_bool *cancelled = nullptr);

/// Puts another sender into what was gathered; an empty name or number leaves the one before.
void nameSender(HandIn &handIn, const Sender &sender);

/// The file to hand in, with the report as it was printed.
/// \param reportName  "report.pdf" or "report.html"
Result<QByteArray> packHandIn(const HandIn &handIn, const QString &reportName,
                              const QByteArray &report);

/// Puts a file that was handed in into a new folder of \p place, as a workspace that can be looked
/// at: its programs, and its history as a repository. Nothing of it is run.
/// \return the folder; the same file has the same
Result<QString> openHandIn(const QString &path, const QString &place);

} // namespace cradle
