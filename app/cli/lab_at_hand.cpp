// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/lab_at_hand.h"

#include "tasks/authoring/lab_archive.h"
#include "tasks/lab_reader.h"

#include <QTextStream>

namespace cradle::cli {

Result<LabAtHand> readLabAtHand(const QString &path, const QString &language)
{
    auto lab = readLabOrArchive(path, language);
    if (!lab)
        return lab.error();
    for (const Error &finding : lab->findings)
        QTextStream(stderr) << finding.toString() << Qt::endl;
    auto files = isLabArchive(path) ? readLabArchive(path) : readLabFiles(path);
    if (!files)
        return files.error();
    return LabAtHand{path, language, std::move(*files), std::move(*lab)};
}

} // namespace cradle::cli
