// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_files/step_alone.h"

#include <QCryptographicHash>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace cradle {

LabFiles stepAlone(const LabFiles &files, const QString &step)
{
    const QString index = QStringLiteral("lab.json");
    const QString key = QStringLiteral("steps");
    QJsonObject json = QJsonDocument::fromJson(files.contents.value(index)).object();
    const QJsonArray steps = json.value(key).toArray();
    if (!steps.contains(step))
        return files;
    LabFiles alone = files;
    for (const QJsonValue &other : steps) {
        const QString folder = other.toString() + QLatin1Char('/');
        if (other == QJsonValue(step) || folder.size() == 1)
            continue;
        auto it = alone.contents.lowerBound(folder);
        while (it != alone.contents.end() && it.key().startsWith(folder))
            it = alone.contents.erase(it);
    }
    json.insert(key, QJsonArray{step});
    alone.contents.insert(index, QJsonDocument(json).toJson());
    return alone;
}

QStringList unlistedSteps(const LabFiles &files)
{
    const QJsonArray steps =
        QJsonDocument::fromJson(files.contents.value(QStringLiteral("lab.json")))
            .object()
            .value(QStringLiteral("steps"))
            .toArray();
    const QString task = QStringLiteral("/task.json");
    QStringList unlisted;
    for (auto it = files.contents.begin(); it != files.contents.end(); ++it) {
        const QString step = it.key().chopped(std::min(it.key().size(), task.size()));
        if (it.key().endsWith(task) && !step.contains(QLatin1Char('/')) && !steps.contains(step))
            unlisted.append(step);
    }
    return unlisted;
}

QString hashOf(const LabFiles &files)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (auto it = files.contents.begin(); it != files.contents.end(); ++it) {
        hash.addData(it.key().toUtf8() + '\n');
        hash.addData(*it);
    }
    return QString::fromLatin1(hash.result().toHex());
}

} // namespace cradle
