// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/lab_draft.h"

#include "model/files/file_io.h"
#include "model/files/json_schema.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>

#include <cerrno>
#include <csignal>

namespace cradle {

namespace {

/// Twice what a lab may be: text of base64 is longer.
constexpr qint64 maxBytes = 2 * limits::labBytes;

/// The same for all drafts of a lab.
QString keyOf(const QString &folder)
{
    if (folder.isEmpty())
        return QStringLiteral("new");
    const QByteArray path = QDir(folder).absolutePath().toUtf8();
    return QString::fromLatin1(
        QCryptographicHash::hash(path, QCryptographicHash::Sha256).toHex().left(24));
}

QString pathOf(const QString &drafts, const QString &folder)
{
    return QStringLiteral("%1/%2-%3.json")
        .arg(drafts, keyOf(folder))
        .arg(QCoreApplication::applicationPid());
}

bool isAlive(const QString &name)
{
    const int process = name.section(QLatin1Char('-'), -1).section(QLatin1Char('.'), 0, 0).toInt();
    return process > 0 && (::kill(process, 0) == 0 || errno == EPERM);
}

/// A file of a lab in a draft: null is none.
QJsonValue fileOf(const LabFiles &files, const QString &path)
{
    const auto found = files.contents.find(path);
    return found == files.contents.end() ? QJsonValue(QJsonValue::Null)
                                         : QJsonValue(QString::fromLatin1(found->toBase64()));
}

LabFiles withFiles(LabFiles files, const QJsonObject &changes)
{
    for (auto it = changes.begin(); it != changes.end(); ++it) {
        if (!faultOfLabPath(it.key()).isEmpty())
            continue;
        if (it.value().isNull())
            files.contents.remove(it.key());
        else
            files.contents[it.key()] = QByteArray::fromBase64(it.value().toString().toLatin1());
    }
    return files;
}

std::optional<LabDraft> readDraft(const QString &path, const LabFiles &onDisk)
{
    const auto text = readFile(path, maxBytes);
    const QJsonObject json = QJsonDocument::fromJson(text ? *text : QByteArray()).object();
    if (json.value(QStringLiteral("format")).toInt() != 1)
        return std::nullopt;
    LabDraft draft{
        .folder = json.value(QStringLiteral("folder")).toString(),
        .when = QDateTime::fromString(json.value(QStringLiteral("when")).toString(), Qt::ISODate),
        .files = withFiles(onDisk, json.value(QStringLiteral("files")).toObject()),
        .base = withFiles(onDisk, json.value(QStringLiteral("base")).toObject()),
        .path = path};
    return draft;
}

} // namespace

std::optional<Error> saveDraft(const QString &drafts, const QString &folder, const LabFiles &files,
                               const LabFiles &onDisk)
{
    QJsonObject changes;
    QJsonObject base;
    for (const QString &path : files.contents.keys() + onDisk.contents.keys()) {
        const QJsonValue mine = fileOf(files, path);
        const QJsonValue before = fileOf(onDisk, path);
        if (mine == before)
            continue;
        changes.insert(path, mine);
        base.insert(path, before);
    }
    if (auto error = makeFolder(drafts))
        return error;
    const QJsonObject json{
        {QStringLiteral("format"), 1},
        {QStringLiteral("folder"), folder},
        {QStringLiteral("when"), QDateTime::currentDateTimeUtc().toString(Qt::ISODate)},
        {QStringLiteral("files"), changes},
        {QStringLiteral("base"), base}};
    return writeFile(pathOf(drafts, folder), QJsonDocument(json).toJson(QJsonDocument::Compact));
}

void removeDraft(const QString &drafts, const QString &folder)
{
    QFile::remove(pathOf(drafts, folder));
}

std::optional<LabDraft> findDraft(const QString &drafts, const QString &folder,
                                  const LabFiles &onDisk)
{
    const QDir dir(drafts);
    const QStringList names =
        dir.entryList({keyOf(folder) + QStringLiteral("-*.json")}, QDir::Files, QDir::Time);
    for (const QString &name : names) {
        if (isAlive(name))
            continue;
        if (auto draft = readDraft(dir.filePath(name), onDisk))
            return draft;
    }
    return std::nullopt;
}

} // namespace cradle
