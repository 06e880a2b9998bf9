// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/handed_zip.h"

#include "tasks/grading/handed_repository.h"
#include "tasks/grading/platform_names.h"
#include "tasks/grading/raw_folder.h"
#include "tasks/grading/zip_entries.h"

#include <QCoreApplication>
#include <QSet>

#include <algorithm>

namespace cradle {

namespace {

struct HandedZipText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr zip_int64_t mostHandedEntries = 20'000; ///< a clone has some thousands of objects
constexpr qsizetype mostFolders = 6;              ///< that lie in each other

} // namespace

Result<HandedZip> HandedZip::open(QByteArray bytes)
{
    HandedZip zip;
    zip.m_bytes = std::move(bytes);
    ZipError error;
    ZipSource source(zip_source_buffer_create(
        zip.m_bytes.constData(), static_cast<zip_uint64_t>(zip.m_bytes.size()), 0, error));
    if (source)
        zip.m_archive.reset(zip_open_from_source(source.get(), ZIP_RDONLY, error));
    if (!zip.m_archive)
        return Error{HandedZipText::tr("this is no zip: %1").arg(QString::fromUtf8(error.text()))};
    (void)source.release(); // it is the archive's now
    const zip_int64_t count = zip_get_num_entries(zip.m_archive.get(), ZIP_FL_UNCHANGED);
    if (count > mostHandedEntries)
        return Error{
            HandedZipText::tr("there are more than %1 files in it").arg(mostHandedEntries)};
    for (zip_int64_t i = 0; i < count; ++i)
        zip.take(static_cast<zip_uint64_t>(i));
    std::stable_sort(zip.m_entries.begin(), zip.m_entries.end(),
                     [](const Entry &a, const Entry &b) { return a.name < b.name; });
    const auto twice = std::unique(zip.m_entries.begin(), zip.m_entries.end(),
                                   [](const Entry &a, const Entry &b) { return a.name == b.name; });
    if (twice != zip.m_entries.end())
        zip.m_leftOut.append(HandedZipText::tr("names that are in it more than once"));
    zip.m_entries.erase(twice, zip.m_entries.end());
    if (zip.isOfAClass())
        return Error{HandedZipText::tr("this is the zip of a whole class; grade the zip itself")};
    return zip;
}

void HandedZip::take(zip_uint64_t index)
{
    const char *raw = zip_get_name(m_archive.get(), index, ZIP_FL_ENC_RAW);
    QByteArray name(raw ? raw : "");
    name.replace('\\', '/'); // Windows' own programs have packed so for years
    if (name.endsWith('/'))
        return;
    if (!staysBelow(name) || isZippedLink(m_archive.get(), index)) {
        m_leftOut.append(name.isEmpty() ? HandedZipText::tr("a broken entry") : shownName(name));
        return;
    }
    const QByteArrayList parts = name.split('/');
    const bool isHidden = std::any_of(parts.begin(), parts.end(), [](const QByteArray &part) {
        return part.startsWith('.') || part == "__MACOSX";
    });
    if (!isHidden && parts.size() <= mostFolders + 1)
        m_entries.push_back({shownName(name), index});
    else if (parts.contains(".git"))
        m_history.push_back({shownName(name), index});
}

/// Whether a learning platform gave it out for more than one student.
bool HandedZip::isOfAClass() const
{
    QSet<QString> students;
    for (const Entry &entry : m_entries) {
        const QString first = entry.name.section(u'/', 0, 0);
        if (const auto name = platformName(first, first.size() < entry.name.size()))
            students.insert(name->student + u'/' + name->number);
    }
    return students.size() > 1;
}

Result<QByteArray> HandedZip::read(zip_uint64_t index, qint64 most, qint64 &left) const
{
    const ZipFile file(zip_fopen_index(m_archive.get(), index, ZIP_FL_UNCHANGED));
    if (!file)
        return Error{HandedZipText::tr("cannot be unpacked: %1")
                         .arg(QString::fromUtf8(zip_strerror(m_archive.get())))};
    QByteArray bytes;
    QByteArray piece(64 * 1024, Qt::Uninitialized);
    while (bytes.size() < most) {
        const qint64 wanted = std::min<qint64>(piece.size(), most - bytes.size());
        const zip_int64_t got =
            zip_fread(file.get(), piece.data(), static_cast<zip_uint64_t>(wanted));
        if (got < 0)
            return Error{HandedZipText::tr("cannot be unpacked: %1")
                             .arg(QString::fromUtf8(zip_file_strerror(file.get())))};
        if (got == 0)
            break;
        left -= got;
        if (left < 0)
            return Error{HandedZipText::tr("it holds absurdly much")};
        bytes.append(piece.constData(), static_cast<qsizetype>(got));
    }
    return bytes;
}

Result<RepositoryFiles> HandedZip::repository(const QString &folder, qint64 &left) const
{
    RepositoryFiles files;
    for (const Entry &entry : m_history) {
        const QString below = entry.name.mid(folder.size());
        if (!entry.name.startsWith(folder) || !isOfHistory(below.toUtf8()))
            continue;
        auto bytes = read(entry.index, left + 1, left);
        if (!bytes)
            return bytes.error();
        files.insert(below, std::move(*bytes));
    }
    return files;
}

} // namespace cradle
