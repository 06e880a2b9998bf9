// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/handed_files.h"

#include "tasks/grading/handed_repository.h"
#include "tasks/grading/raw_folder.h"

#include <QCoreApplication>

#include <utility>

namespace cradle {

namespace {

struct HandedFilesText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr int mostDepth = 5;
constexpr std::size_t mostFiles = 2000;           ///< of one student that are looked at
constexpr qint64 mostZipBytes = 32 * 1024 * 1024; ///< of all zips of one student
constexpr qint64 mostUnpacked = 64 * 1024 * 1024; ///< of what is read of them

bool isZip(const QString &name)
{
    return name.endsWith(QLatin1String(".zip"), Qt::CaseInsensitive);
}

} // namespace

HandedFiles::HandedFiles(const FoundStudent &student, const QByteArray &classRoot)
    : m_folder(student.folder)
    , m_root(student.folder.isEmpty() ? classRoot : student.folder)
    , m_unpackLeft(mostUnpacked)
{
    if (!m_folder.isEmpty())
        walk(m_folder, {}, 0);
    else
        for (const FoundStudent::File &file : student.files)
            m_files.push_back({.path = file.path, .name = file.calledBy});
    lookIntoZips();
}

void HandedFiles::walk(const QByteArray &folder, const QString &below, int depth)
{
    const auto entries = entriesOf(folder, mostFiles);
    if (!entries) {
        remarks.append(entries.error().toString());
        return;
    }
    for (const FolderEntry &entry : *entries) {
        const QString name = below + shownName(entry.name);
        const QByteArray path = folder + '/' + entry.name;
        if (entry.name.startsWith('.') || entry.name == "__MACOSX")
            continue;
        if (entry.kind == FolderEntry::Kind::Folder && depth < mostDepth)
            walk(path, name + u'/', depth + 1);
        else if (entry.kind == FolderEntry::Kind::File || entry.kind == FolderEntry::Kind::Link)
            m_files.push_back({.path = path, .name = name});
        if (m_files.size() > mostFiles)
            return;
    }
}

/// Puts what is in zips in their place, as if they were folders.
void HandedFiles::lookIntoZips()
{
    qint64 left = mostZipBytes;
    for (const File &file : std::exchange(m_files, {})) {
        if (!isZip(file.name)) {
            m_files.push_back(file);
            continue;
        }
        auto bytes = read(file, left + 1);
        if (!bytes)
            continue;
        if (bytes->size() > left) {
            remarks.append(HandedFilesText::tr("%1: too large to be unpacked").arg(file.name));
            continue;
        }
        left -= bytes->size();
        auto zip = HandedZip::open(std::move(*bytes));
        if (zip)
            lookInto(*m_zips.emplace_back(std::make_unique<HandedZip>(std::move(*zip))), file);
        else
            remarks.append(file.name + QStringLiteral(": ") + zip.error().message);
    }
}

void HandedFiles::lookInto(const HandedZip &zip, const File &file)
{
    for (const QString &name : zip.leftOut())
        remarks.append(HandedFilesText::tr("%1: left out %2").arg(file.name, name));
    for (const HandedZip::Entry &entry : zip.entries()) {
        if (m_files.size() <= mostFiles)
            m_files.push_back({.path = file.path,
                               .name = file.name + u'/' + entry.name,
                               .zip = &zip,
                               .index = entry.index,
                               .inZip = file.name.size() + 1});
    }
}

std::optional<QByteArray> HandedFiles::read(const File &file, qint64 most)
{
    auto bytes = file.zip ? file.zip->read(file.index, most, m_unpackLeft)
                          : readBelow(m_root, file.path, most);
    if (bytes)
        return std::move(*bytes);
    remarks.append(file.name + QStringLiteral(": ") + bytes.error().message);
    return std::nullopt;
}

RepositoryFiles HandedFiles::history(const QString &folder, const File &file)
{
    if (m_folder.isEmpty() && !file.zip)
        return {};
    const QString inner = file.zip ? folder.mid(file.inZip) : folder;
    for (const QString &place : {inner, QString()}) {
        auto repository = file.zip
                              ? file.zip->repository(place + QStringLiteral(".git/"), m_unpackLeft)
                              : readRepository(m_root, m_folder + '/' + place.toUtf8() + ".git");
        if (!repository)
            remarks.append(repository.error().message);
        else if (!repository->isEmpty())
            return std::move(*repository);
        if (!repository)
            break;
    }
    return {};
}

} // namespace cradle
