// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_report/lab_report.h"
#include "tasks/work/work_archive.h"

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

/// Judges a student's work anew and tells it, as makeLabReport() does.
using ReportMaker = std::function<LabReport(const Lab &lab, const StudentWork &work)>;

/// Gathers the work in \p folder, and what \p makeReport tells about it.
/// \param seed, when  of that, for the manifest
Result<HandIn> gatherHandIn(const Lab &lab, const QString &folder, const Sender &sender,
                            qint64 seed, const QDateTime &when, const ReportMaker &makeReport);
/// The same with makeLabReport().
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

/// The note to the teacher in such a folder, as one line; empty if there is none.
[[nodiscard]] QString noteToTeacher(const QString &folder);

} // namespace cradle
