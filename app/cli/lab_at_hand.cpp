// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/lab_at_hand.h"

#include "tasks/authoring/lab_archive.h"
#include "tasks/lab_reader.h"

#include <QTextStream>

namespace cradle::cli {

namespace {

Result<ReadLab> read(const QString &path, const QString &language)
{
    if (!isLabArchive(path))
        return readLabWithFiles(path, language);
    auto files = readLabArchive(path);
    if (!files)
        return files.error();
    auto lab = readLab(*files, path, language);
    if (!lab)
        return lab.error();
    return ReadLab{std::move(*files), std::move(*lab)};
}

} // namespace

Result<LabAtHand> readLabAtHand(const QString &path, const QString &language)
{
    auto there = read(path, language);
    if (!there)
        return there.error();
    for (const Error &finding : there->lab.findings)
        QTextStream(stderr) << finding.toString() << Qt::endl;
    return LabAtHand{path, language, std::move(there->files), std::move(there->lab)};
}

} // namespace cradle::cli
