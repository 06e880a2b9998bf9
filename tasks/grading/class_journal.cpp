// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/class_journal.h"

#include "model/files/file_io.h"
#include "model/files/json_schema.h"
#include "tasks/grading/platform_names.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDirIterator>
#include <QFile>
#include <QJsonArray>

#include <cerrno>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace cradle {

namespace {

struct JournalText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr qint64 mostManifestBytes = 256 * 1024 * 1024;
const QString manifestName = QStringLiteral("/manifest.json");
const QString journalName = QStringLiteral("/manifest.journal");

/// Which keys hold what of a version.
struct VersionField {
    const char *key;
    QString ResultsVersion::*field;
};

constexpr VersionField versionFields[] = {{"cradle", &ResultsVersion::cradle},
                                          {"lab", &ResultsVersion::labId},
                                          {"lab_version", &ResultsVersion::labVersion},
                                          {"lab_hash", &ResultsVersion::labHash},
                                          {"secret_sha256", &ResultsVersion::secretHash},
                                          {"language", &ResultsVersion::language}};

QJsonObject jsonOf(const QString &id, const DoneStudent &student)
{
    return {{QStringLiteral("id"), id},
            {QStringLiteral("work"), student.workHash},
            {QStringLiteral("result"), student.resultHash},
            {QStringLiteral("not_graded"), student.notGraded},
            {QStringLiteral("not_passed"), student.notPassed}};
}

void addStudent(Manifest &manifest, const QJsonObject &json)
{
    const QString id = json.value(QStringLiteral("id")).toString();
    if (!id.isEmpty())
        manifest.students[id] = {json.value(QStringLiteral("work")).toString(),
                                 json.value(QStringLiteral("result")).toString(),
                                 json.value(QStringLiteral("not_graded")).toInt(),
                                 json.value(QStringLiteral("not_passed")).toInt()};
}

/// Which keys hold what of who is missing.
struct MissingField {
    const char *key;
    QString MissingStudent::*field;
};

constexpr MissingField missingFields[] = {{"id", &MissingStudent::id},
                                          {"name", &MissingStudent::name},
                                          {"number", &MissingStudent::number},
                                          {"email", &MissingStudent::email}};

QJsonArray jsonOf(const std::vector<MissingStudent> &missing)
{
    QJsonArray list;
    for (const MissingStudent &student : missing) {
        QJsonObject json;
        for (const MissingField &each : missingFields)
            json.insert(QLatin1String(each.key), student.*each.field);
        list.append(json);
    }
    return list;
}

std::vector<MissingStudent> missingFrom(const QJsonArray &list)
{
    std::vector<MissingStudent> missing;
    for (const QJsonValue &value : list) {
        MissingStudent &student = missing.emplace_back();
        for (const MissingField &each : missingFields)
            student.*each.field = value.toObject().value(QLatin1String(each.key)).toString();
    }
    return missing;
}

QStringList textsFrom(const QJsonArray &list)
{
    QStringList texts;
    for (const QJsonValue &text : list)
        texts.append(text.toString());
    return texts;
}

} // namespace

QString sha256(const QByteArray &bytes)
{
    return QString::fromLatin1(QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex());
}

QByteArray bytesOf(const Manifest &manifest)
{
    QJsonObject version;
    for (const VersionField &each : versionFields)
        version.insert(QLatin1String(each.key), manifest.version.*each.field);
    QJsonArray students;
    for (const auto &[id, student] : manifest.students)
        students.append(jsonOf(id, student));
    QJsonObject json{{QStringLiteral("format"), 1},
                     {QStringLiteral("complete"), manifest.complete},
                     {QStringLiteral("version"), version},
                     {QStringLiteral("name"), manifest.className},
                     {QStringLiteral("platform"), platformText(manifest.platform)},
                     {QStringLiteral("isolation"), manifest.isolation},
                     {QStringLiteral("missing"), jsonOf(manifest.missing)},
                     {QStringLiteral("remarks"), QJsonArray::fromStringList(manifest.remarks)},
                     {QStringLiteral("class"), QJsonArray::fromStringList(manifest.classIds)},
                     {QStringLiteral("students"), students}};
    if (manifest.shard.count > 1)
        json.insert(QStringLiteral("shard"),
                    QJsonArray{manifest.shard.index, manifest.shard.count});
    return QJsonDocument(json).toJson();
}

Result<Manifest> manifestFrom(const QByteArray &text, const QString &source)
{
    const QJsonObject json = QJsonDocument::fromJson(text).object();
    if (json.value(QStringLiteral("format")).toInt() != 1)
        return Error{.message = JournalText::tr("this is no manifest of results of format 1"),
                     .file = source};
    Manifest manifest;
    manifest.complete = json.value(QStringLiteral("complete")).toBool();
    const QJsonObject version = json.value(QStringLiteral("version")).toObject();
    for (const VersionField &each : versionFields)
        manifest.version.*each.field =
            version.value(QLatin1String(each.key)).toString(manifest.version.*each.field);
    const QJsonArray shard = json.value(QStringLiteral("shard")).toArray();
    if (shard.size() == 2)
        manifest.shard = {shard.at(0).toInt(), shard.at(1).toInt()};
    manifest.className = json.value(QStringLiteral("name")).toString();
    manifest.platform = platformFrom(json.value(QStringLiteral("platform")).toString());
    manifest.isolation = json.value(QStringLiteral("isolation")).toString();
    manifest.missing = missingFrom(json.value(QStringLiteral("missing")).toArray());
    manifest.remarks = textsFrom(json.value(QStringLiteral("remarks")).toArray());
    manifest.classIds = textsFrom(json.value(QStringLiteral("class")).toArray());
    for (const QJsonValue &student : json.value(QStringLiteral("students")).toArray())
        addStudent(manifest, student.toObject());
    return manifest;
}

Result<std::optional<Manifest>> readManifest(const QString &folder)
{
    const QString path = folder + manifestName;
    if (!QFile::exists(path))
        return std::optional<Manifest>();
    const auto text = readFile(path, mostManifestBytes);
    if (!text)
        return text.error();
    auto manifest = manifestFrom(*text, path);
    if (!manifest)
        return manifest.error();
    const QString journal = folder + journalName;
    if (!manifest->complete && QFile::exists(journal)) {
        const auto lines = readFile(journal, mostManifestBytes);
        if (!lines)
            return lines.error();
        // A last line that was not finished is no JSON, and counts for nothing.
        for (const QByteArray &line : lines->split('\n'))
            addStudent(*manifest, QJsonDocument::fromJson(line).object());
    }
    return std::optional(std::move(*manifest));
}

Result<ClassJournal> ClassJournal::open(const QString &folder)
{
    const auto fault = [&](const QString &message) {
        return Error{.message = message, .file = folder};
    };
    if (const auto error = makeFolder(folder + QStringLiteral("/students")))
        return *error;
    ClassJournal journal(folder);
    journal.m_lock = Descriptor(
        ::open(QFile::encodeName(folder).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!journal.m_lock)
        return fault(wordsForFault(errno));
    if (::flock(journal.m_lock.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        return fault(JournalText::tr("another process is writing results there"));
    removeUnfinished(folder);
    QDirIterator below(folder, QDir::Dirs | QDir::NoDotAndDotDot | QDir::NoSymLinks,
                       QDirIterator::Subdirectories);
    while (below.hasNext())
        removeUnfinished(below.next());
    return journal;
}

QString ClassJournal::journalPath() const
{
    return m_folder + journalName;
}

QString ClassJournal::studentPath(const QString &id) const
{
    return m_folder + QStringLiteral("/students/") + id + QStringLiteral(".json");
}

std::optional<Error> ClassJournal::begin(const Manifest &manifest)
{
    m_manifest = manifest;
    m_manifest.complete = false;
    // First the manifest, with all that the journal of a run before had; then that may go.
    if (auto error = writeFile(m_folder + manifestName, bytesOf(m_manifest)))
        return error;
    m_file = Descriptor(::open(QFile::encodeName(journalPath()).constData(),
                               O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666));
    if (!m_file)
        return Error{.message = wordsForFault(errno), .file = journalPath()};
    return std::nullopt;
}

std::optional<Error> ClassJournal::keep(const QString &id, const QByteArray &result,
                                        DoneStudent done)
{
    if (auto error = writeFile(studentPath(id), result))
        return error;
    done.resultHash = sha256(result);
    const QByteArray line =
        '\n' + QJsonDocument(jsonOf(id, done)).toJson(QJsonDocument::Compact) + '\n';
    if (!writeAll(m_file.number(), line))
        return Error{.message = wordsForFault(errno), .file = journalPath()};
    m_manifest.students[id] = done;
    return std::nullopt;
}

std::optional<Error> ClassJournal::finish(bool complete)
{
    m_manifest.complete = complete;
    if (auto error = writeFile(m_folder + manifestName, bytesOf(m_manifest)))
        return error;
    m_file.close();
    QFile::remove(journalPath());
    return std::nullopt;
}

} // namespace cradle
