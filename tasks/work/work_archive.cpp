// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/work/work_archive.h"

#include "model/files/json_schema.h"
#include "tasks/reading/lab_archive.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace cradle {

namespace {

struct ArchiveText {
    Q_DECLARE_TR_FUNCTIONS(HandIn)
};

const QString manifestFile = QStringLiteral("manifest.json");

struct Field {
    const char *key;
    QString WorkManifest::*field;
};

constexpr Field fields[] = {{"lab", &WorkManifest::labId},
                            {"lab_version", &WorkManifest::labVersion},
                            {"lab_hash", &WorkManifest::labHash},
                            {"name", &WorkManifest::student},
                            {"id", &WorkManifest::studentId}};

QString hashOf(const QByteArray &content)
{
    return QString::fromLatin1(
        QCryptographicHash::hash(content, QCryptographicHash::Sha256).toHex());
}

QByteArray textOf(const WorkManifest &manifest, const WorkFiles &files)
{
    QJsonObject json{{QStringLiteral("format"), 1},
                     {QStringLiteral("when"), manifest.when.toString(Qt::ISODate)},
                     {QStringLiteral("seed"), manifest.seed}};
    for (const Field &each : fields)
        json.insert(QLatin1String(each.key), manifest.*each.field);
    QJsonArray steps;
    for (const WorkManifest::Step &step : manifest.steps)
        steps.append(QJsonObject{{QStringLiteral("id"), step.id},
                                 {QStringLiteral("verdict"), step.verdict}});
    json.insert(QStringLiteral("steps"), steps);
    QJsonObject hashes;
    for (auto it = files.begin(); it != files.end(); ++it)
        hashes.insert(it.key(), hashOf(*it));
    json.insert(QStringLiteral("files"), hashes);
    return QJsonDocument(json).toJson();
}

Result<QJsonObject> manifestJson(const WorkFiles &files, const QString &source)
{
    const QJsonObject json = QJsonDocument::fromJson(files.value(manifestFile)).object();
    if (json.value(QStringLiteral("format")).toInt() == 1)
        return json;
    return Error{.message = ArchiveText::tr("this is no work that was handed in: there is no "
                                            "manifest.json of format 1 in it"),
                 .file = source};
}

/// What is not as the manifest says.
std::optional<Error> faultOfFiles(const WorkFiles &files, const QString &source)
{
    const auto json = manifestJson(files, source);
    if (!json)
        return json.error();
    const QJsonObject hashes = json->value(QStringLiteral("files")).toObject();
    const auto fault = [&source](const QString &file, const QString &message) {
        return Error{.message = file.left(200) + QStringLiteral(": ") + message, .file = source};
    };
    for (auto it = files.begin(); it != files.end(); ++it) {
        if (it.key() == manifestFile)
            continue;
        if (!hashes.contains(it.key()))
            return fault(it.key(), ArchiveText::tr("this file is not in the manifest"));
        if (hashes.value(it.key()).toString() != hashOf(*it))
            return fault(it.key(), ArchiveText::tr("this file was changed after it was handed in"));
    }
    for (auto it = hashes.begin(); it != hashes.end(); ++it) {
        if (!files.contains(it.key()))
            return fault(it.key(), ArchiveText::tr("this file is missing"));
    }
    return std::nullopt;
}

} // namespace

QString workFileName(const QString &student, const QString &labId)
{
    QString name;
    // Letters with marks lose them; all else becomes one dash.
    for (const QChar letter : student.normalized(QString::NormalizationForm_KD)) {
        if (letter.unicode() < 128 && letter.isLetterOrNumber())
            name += letter;
        else if (letter.category() != QChar::Mark_NonSpacing && !name.isEmpty()
                 && !name.endsWith(QLatin1Char('-')))
            name += QLatin1Char('-');
    }
    if (name.endsWith(QLatin1Char('-')))
        name.chop(1);
    if (name.isEmpty())
        name = QStringLiteral("student");
    return name.left(60) + QLatin1Char('-') + labId + QLatin1String(workSuffix);
}

Result<QByteArray> packWork(const WorkFiles &files, const WorkManifest &manifest)
{
    WorkFiles all = files;
    all.insert(manifestFile, textOf(manifest, files));
    return packFiles(all);
}

Result<WorkFiles> unpackWork(const QByteArray &archive, const QString &source)
{
    const auto files = unpackFiles(archive, source, manifestFile);
    if (!files)
        return files.error();
    if (const auto error = faultOfFiles(files->contents, source))
        return *error;
    return files->contents;
}

Result<WorkFiles> readWorkArchive(const QString &path)
{
    const auto archive = readFile(path, limits::labBytes);
    return archive ? unpackWork(*archive, path) : Result<WorkFiles>(archive.error());
}

Result<WorkManifest> manifestOf(const WorkFiles &files)
{
    const auto json = manifestJson(files, manifestFile);
    if (!json)
        return json.error();
    WorkManifest manifest;
    for (const Field &each : fields)
        manifest.*each.field = json->value(QLatin1String(each.key)).toString().simplified();
    manifest.when =
        QDateTime::fromString(json->value(QStringLiteral("when")).toString(), Qt::ISODate);
    manifest.seed = static_cast<qint64>(json->value(QStringLiteral("seed")).toDouble(1.0));
    for (const QJsonValue &step : json->value(QStringLiteral("steps")).toArray())
        manifest.steps.push_back({step.toObject().value(QStringLiteral("id")).toString(),
                                  step.toObject().value(QStringLiteral("verdict")).toString()});
    return manifest;
}

bool isWorkArchive(const QString &path)
{
    return path.endsWith(QLatin1String(workSuffix), Qt::CaseInsensitive)
           && !QFileInfo(path).isDir();
}

} // namespace cradle
