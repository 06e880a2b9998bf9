// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/lab_at_hand.h"

#include "tasks/reading/lab_archive.h"
#include "tasks/reading/lab_reader.h"

#include <QTextStream>

namespace cradle::cli {

namespace {

Result<ReadLab> read(const QString &path, const QString &language, const QString &step)
{
    if (!isLabArchive(path))
        return readLabWithFiles(path, language, step);
    auto files = readLabArchive(path);
    return files ? readLabWithFiles(std::move(*files), path, language, step)
                 : Result<ReadLab>(files.error());
}

} // namespace

Result<LabAtHand> readLabAtHand(const QString &path, const QString &language, const QString &step)
{
    auto there = read(path, language, step);
    if (!there)
        return there.error();
    for (const Error &finding : there->lab.findings)
        QTextStream(stderr) << finding.toString() << Qt::endl;
    return LabAtHand{path, language, std::move(there->files), std::move(there->lab)};
}

} // namespace cradle::cli
