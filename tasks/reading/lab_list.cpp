// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/reading/lab_list.h"

#include "model/files/json_schema.h"
#include "tasks/reading/lab_reader.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <optional>

namespace cradle {

namespace {

/// Far above what a lab.json needs.
constexpr qint64 mostListBytes = 256 * 1024;
/// Of a menu that can still be used.
constexpr std::size_t maxLabs = 100;

/// A JSON file that fits the schema; empty if there is no such file.
QJsonObject objectIn(const QString &path, const QString &schema)
{
    // A pipe would keep the menu waiting.
    if (!QFileInfo(path).isFile())
        return {};
    const Result<QByteArray> text = readFile(path, mostListBytes);
    if (!text)
        return {};
    const Result<QJsonObject> json = parseJson(*text, QStringLiteral(":/schemas/") + schema, path);
    return json ? *json : QJsonObject();
}

std::optional<ListedLab> listedLab(const QString &folder, const QString &language)
{
    const QJsonObject own =
        objectIn(folder + QStringLiteral("/lab.json"), QStringLiteral("lab.schema.json"));
    if (own.isEmpty())
        return std::nullopt;
    const QJsonObject translated = objectIn(folder + QStringLiteral("/lab.%1.json").arg(language),
                                            QStringLiteral("translation.schema.json"));
    const auto text = [&](const char *key) { return own.value(QLatin1String(key)).toString(); };
    return ListedLab{translated.value(QStringLiteral("title")).toString(text("title")), folder,
                     text("id"), text("version")};
}

} // namespace

std::vector<ListedLab> shippedLabs(const QString &language)
{
    std::vector<ListedLab> labs;
    for (const char *folder : {shippedLab, bouncingBallLab}) {
        if (const auto lab = listedLab(QLatin1String(folder), language))
            labs.push_back(*lab);
    }
    return labs;
}

QString shippedLabWith(const QString &step)
{
    const QString first = QLatin1String(shippedLab);
    const QString other = QLatin1String(bouncingBallLab);
    // Its steps have their ids for folders, so that no lab has to be read.
    return QFile::exists(other + QLatin1Char('/') + step + QStringLiteral("/task.json")) ? other
                                                                                         : first;
}

std::vector<ListedLab> labsIn(const QString &parent, const QString &language)
{
    std::vector<ListedLab> labs;
    const QDir folder(parent);
    for (const QString &name : folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
        if (labs.size() == maxLabs)
            break;
        if (const auto lab = listedLab(folder.filePath(name), language))
            labs.push_back(*lab);
    }
    std::stable_sort(labs.begin(), labs.end(), [](const ListedLab &a, const ListedLab &b) {
        return QString::localeAwareCompare(a.title, b.title) < 0;
    });
    return labs;
}

} // namespace cradle
