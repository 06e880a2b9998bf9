// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/values/values_of_file.h"

#include "model/files/json_schema.h"
#include "model/files/preset_json.h"
#include "tasks/values/lab_values.h"

#include <QDir>
#include <QFileInfo>

namespace cradle {

namespace {

constexpr int mostFolders = 2; ///< between lab.json and a file: STEP/mistakes

/// The lab's folder above \p path; empty if it lies in no step.
QString labAbove(const QString &path)
{
    QDir folder = QFileInfo(path).absoluteDir();
    for (int i = 0; i < mostFolders && folder.cdUp(); ++i) {
        if (folder.exists(QStringLiteral("lab.json")))
            return folder.path();
    }
    return {};
}

} // namespace

Result<QByteArray> withValuesOfItsStep(const QString &path, const QByteArray &bytes,
                                       const QString &student)
{
    const QString lab = labAbove(path);
    if (lab.isEmpty())
        return bytes;
    const QString own = QDir(lab).relativeFilePath(QFileInfo(path).absoluteFilePath());
    const QString step = own.section(QLatin1Char('/'), 0, 0);
    LabFiles files;
    for (const QString &name : {QStringLiteral("lab.json"), step + QStringLiteral("/task.json")}) {
        if (const auto content = readFile(lab + QLatin1Char('/') + name, limits::labFileBytes))
            files.contents.insert(name, *content);
    }
    files.contents.insert(own, bytes);
    std::vector<Error> faults;
    const LabFiles put = withValues(files, student, &faults);
    for (Error &fault : faults) {
        if (fault.file != own)
            continue;
        fault.file = path;
        return fault;
    }
    return put.contents.value(own);
}

Result<Preset> presetWithValues(const QString &path, const QString &student)
{
    const auto bytes = readFile(path, limits::labFileBytes);
    if (!bytes)
        return bytes.error();
    const auto own = withValuesOfItsStep(path, *bytes, student);
    return own ? parsePreset(*own, path) : Result<Preset>(own.error());
}

} // namespace cradle
