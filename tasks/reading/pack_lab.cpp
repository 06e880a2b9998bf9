// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/reading/lab_archive.h"

#include "tasks/lab_files/zip_handles.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct PackText {
    Q_DECLARE_TR_FUNCTIONS(LabArchive)
};

/// 1980-01-01, the beginning of time for MS-DOS, in whose form archives tell it.
constexpr zip_uint16_t firstDay = (0 << 9) | (1 << 5) | 1;
/// A plain file that its owner may write and all may read.
constexpr zip_uint32_t plainFile = 0100644u << 16;

Error failed(const char *why)
{
    return {.message = PackText::tr("the lab cannot be packed: %1").arg(QString::fromUtf8(why))};
}

/// \return whether it could be added
bool addFile(zip_t *archive, const QString &path, const QByteArray &content)
{
    ZipSource source(
        zip_source_buffer(archive, content.constData(), zip_uint64_t(content.size()), 0));
    if (!source)
        return false;
    const zip_int64_t added =
        zip_file_add(archive, path.toUtf8().constData(), source.get(), ZIP_FL_ENC_UTF_8);
    if (added < 0)
        return false;
    (void)source.release(); // the archive owns it now
    const auto index = zip_uint64_t(added);
    return zip_set_file_compression(archive, index, ZIP_CM_DEFLATE, 9) == 0
           && zip_file_set_dostime(archive, index, 0, firstDay, 0) == 0
           && zip_file_set_external_attributes(archive, index, 0, ZIP_OPSYS_UNIX, plainFile) == 0;
}

Result<QByteArray> readAll(zip_source_t *source)
{
    zip_stat_t stat;
    if (zip_source_stat(source, &stat) != 0 || zip_source_open(source) != 0)
        return failed(zip_error_strerror(zip_source_error(source)));
    QByteArray bytes(qsizetype(stat.size), Qt::Uninitialized);
    const zip_int64_t read = zip_source_read(source, bytes.data(), stat.size);
    zip_source_close(source);
    if (read != zip_int64_t(stat.size))
        return failed(zip_error_strerror(zip_source_error(source)));
    return bytes;
}

} // namespace

Result<QByteArray> packLab(const LabFiles &files)
{
    if (!files.contents.contains(QStringLiteral("lab.json")))
        return Error{.message = PackText::tr("there is no lab.json")};
    return packFiles(files.contents);
}

Result<QByteArray> packFiles(const QMap<QString, QByteArray> &contents)
{
    for (auto it = contents.begin(); it != contents.end(); ++it) {
        if (const QString fault = faultOfLabPath(it.key()); !fault.isEmpty())
            return Error{.message = fault, .file = it.key()};
    }
    ZipError error;
    const ZipSource memory(zip_source_buffer_create(nullptr, 0, 0, error));
    if (!memory)
        return failed(error.text());
    ZipArchive archive(zip_open_from_source(memory.get(), ZIP_CREATE | ZIP_TRUNCATE, error));
    if (!archive)
        return failed(error.text());
    // The archive frees the source with itself; what it wrote is read afterwards.
    zip_source_keep(memory.get());
    for (auto it = contents.begin(); it != contents.end(); ++it) {
        if (!addFile(archive.get(), it.key(), *it))
            return failed(zip_strerror(archive.get()));
    }
    if (zip_close(archive.get()) != 0)
        return failed(zip_strerror(archive.get()));
    (void)archive.release(); // closed
    return readAll(memory.get());
}

} // namespace cradle
