// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/lab_at_hand.h"

#include "tasks/lab_files/step_alone.h"
#include "tasks/reading/lab_archive.h"
#include "tasks/reading/lab_reader.h"

#include <QCoreApplication>
#include <QTextStream>

namespace cradle::cli {

namespace {

struct LabText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

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

QString noStep(const Lab &lab, const QString &id)
{
    QStringList ids;
    for (const Task &task : lab.tasks)
        ids.append(task.id);
    const bool isThere = lab.files
                         && lab.files->contents.contains(id + QStringLiteral("/task.json"))
                         && !unlistedSteps(*lab.files).contains(id);
    return isThere ? LabText::tr("the step %1 cannot be read; why is said above").arg(id)
                   : LabText::tr("the lab has no step %1; it has %2")
                         .arg(id, ids.join(QStringLiteral(", ")));
}

} // namespace cradle::cli
