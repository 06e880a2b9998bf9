// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/class_zip.h"

#include "tasks/grading/descriptors.h"
#include "tasks/grading/raw_folder.h"
#include "tasks/grading/zip_entries.h"
#include "tasks/lab_files/zip_handles.h"

#include "model/files/file_io.h"

#include <QCoreApplication>
#include <QFile>
#include <QStringList>

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>

namespace cradle {

namespace {

struct ZipText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr zip_int64_t mostZipEntries = 200'000;
constexpr qint64 mostFileBytes = 32 * 1024 * 1024;
constexpr qint64 mostBytes = qint64(4) * 1024 * 1024 * 1024;

class ClassUnpacker
{
public:
    ClassUnpacker(zip_t *archive, QByteArray place)
        : m_archive(archive)
        , m_place(std::move(place))
    {
    }

    Result<QStringList> unpack()
    {
        const zip_int64_t count = zip_get_num_entries(m_archive, ZIP_FL_UNCHANGED);
        if (count > mostZipEntries)
            return Error{ZipText::tr("there are more than %1 files in it").arg(mostZipEntries)};
        for (zip_int64_t i = 0; i < count; ++i) {
            if (auto error = take(static_cast<zip_uint64_t>(i)))
                return *error;
        }
        return m_leftOut;
    }

private:
    /// \return why nothing more can be unpacked
    std::optional<Error> take(zip_uint64_t index)
    {
        zip_stat_t info{};
        const char *raw = zip_get_name(m_archive, index, ZIP_FL_ENC_RAW);
        if (!raw || zip_stat_index(m_archive, index, ZIP_FL_UNCHANGED, &info) != 0) {
            m_leftOut.append(ZipText::tr("a broken entry"));
            return std::nullopt;
        }
        const QByteArray name(raw);
        if (name.endsWith('/'))
            return std::nullopt; // folders are made where a file needs one
        const bool sized = (info.valid & ZIP_STAT_SIZE) != 0
                           && info.size <= static_cast<zip_uint64_t>(mostFileBytes);
        if (!staysBelow(name) || isZippedLink(m_archive, index) || !sized) {
            m_leftOut.append(shownName(name));
            return std::nullopt;
        }
        const ZipFile file(zip_fopen_index(m_archive, index, ZIP_FL_UNCHANGED));
        QByteArray content(static_cast<qsizetype>(info.size), Qt::Uninitialized);
        const bool whole = file
                           && zip_fread(file.get(), content.data(), info.size)
                                  == static_cast<zip_int64_t>(info.size);
        m_bytes += content.size();
        if (m_bytes > mostBytes)
            return Error{ZipText::tr("it holds absurdly much")};
        if (!whole) {
            m_leftOut.append(shownName(name));
            return std::nullopt;
        }
        return write(name, content);
    }

    std::optional<Error> write(const QByteArray &name, const QByteArray &content)
    {
        const QByteArray path = m_place + '/' + name;
        for (auto slash = path.indexOf('/', m_place.size() + 1); slash > 0;
             slash = path.indexOf('/', slash + 1))
            ::mkdir(path.left(slash).constData(), 0700);
        const Descriptor file(
            ::open(path.constData(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
        if (!file && (errno == EEXIST || errno == ENOTDIR || errno == ENAMETOOLONG)) {
            m_leftOut.append(shownName(name)); // twice in it, or no name of a file
            return std::nullopt;
        }
        if (!file || !writeAll(file.number(), content))
            return Error{.message = wordsForFault(errno), .file = shownName(path)};
        return std::nullopt;
    }

    zip_t *m_archive;
    QByteArray m_place;
    QStringList m_leftOut{};
    qint64 m_bytes = 0;
};

} // namespace

bool isClassZip(const QByteArray &path)
{
    struct stat info {
    };
    return path.toLower().endsWith(".zip") && ::stat(path.constData(), &info) == 0
           && S_ISREG(info.st_mode);
}

Result<QStringList> unpackClass(const QByteArray &path, const QString &place)
{
    int code = 0;
    const ZipArchive archive(zip_open(path.constData(), ZIP_RDONLY, &code));
    if (!archive) {
        ZipError error;
        zip_error_init_with_code(error, code);
        return Error{.message =
                         ZipText::tr("this is no zip: %1").arg(QString::fromUtf8(error.text())),
                     .file = shownName(path)};
    }
    auto unpacked = ClassUnpacker(archive.get(), QFile::encodeName(place)).unpack();
    if (!unpacked && unpacked.error().file.isEmpty())
        return Error{.message = unpacked.error().message, .file = shownName(path)};
    return unpacked;
}

} // namespace cradle
