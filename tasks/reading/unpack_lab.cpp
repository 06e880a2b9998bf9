// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/reading/lab_archive.h"

#include "tasks/lab_files/zip_handles.h"

#include <QCoreApplication>
#include <QLocale>
#include <QSet>
#include <QStringDecoder>

#include <sys/stat.h>

namespace cradle {

namespace {

struct UnpackText {
    Q_DECLARE_TR_FUNCTIONS(LabArchive)
};

/// Texts are packed to a third or a tenth; a hundred times more is made to fill a disk.
constexpr zip_uint64_t mostRatio = 200;
/// Below this size a ratio says nothing: a page of spaces packs as well.
constexpr zip_uint64_t ratioCounts = 1024 * 1024;

QString sizeText(qint64 bytes)
{
    return QLocale::c().formattedDataSize(bytes);
}

/// Reads an archive that anybody may have made.
class Unpacker
{
public:
    Unpacker(zip_t *archive, const QString &source, const QString &index)
        : m_archive(archive)
        , m_source(source)
        , m_index(index)
    {
    }

    Result<LabFiles> unpack()
    {
        const zip_int64_t count = zip_get_num_entries(m_archive, ZIP_FL_UNCHANGED);
        if (count > limits::labFiles)
            return fault({}, UnpackText::tr("there are %1 files in it; at most %2 are right")
                                 .arg(count)
                                 .arg(limits::labFiles));
        for (zip_int64_t i = 0; i < count; ++i) {
            if (const auto error = take(zip_uint64_t(i)))
                return *error;
        }
        return withoutTopFolder();
    }

private:
    [[nodiscard]] Error fault(const QString &entry, const QString &message) const
    {
        return {.message =
                    entry.isEmpty() ? message : entry.left(200) + QStringLiteral(": ") + message,
                .file = m_source};
    }

    std::optional<Error> take(zip_uint64_t index)
    {
        zip_stat_t stat;
        zip_stat_init(&stat);
        const char *raw = zip_get_name(m_archive, index, ZIP_FL_ENC_RAW);
        if (!raw || zip_stat_index(m_archive, index, ZIP_FL_UNCHANGED, &stat) != 0)
            return fault({}, brokenText());
        QStringDecoder decode(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
        QString path = decode(QByteArrayView(raw));
        if (decode.hasError())
            return fault(path, UnpackText::tr("the name is not in UTF-8, which would be right"));
        const bool isFolder = path.endsWith(u'/');
        if (isFolder)
            path.chop(1);
        if (isHidden(path))
            return std::nullopt;
        if (auto error = faultOfEntry(index, path, stat, isFolder))
            return error;
        return isFolder ? std::nullopt : read(index, path, stat);
    }

    /// As in a folder, names that begin with a dot are not the lab's, but ".." is a trick,
    /// and so is a backslash.
    static bool isHidden(const QString &path)
    {
        if (path.contains(u'\\'))
            return false;
        bool hidden = false;
        for (const QString &name : path.split(u'/')) {
            if (name == u"." || name == u".." || name.isEmpty())
                return false;
            hidden = hidden || name.startsWith(u'.') || name == u"__MACOSX" || name.endsWith(u'~');
        }
        return hidden;
    }

    [[nodiscard]] std::optional<Error> faultOfEntry(zip_uint64_t index, const QString &path,
                                                    const zip_stat_t &stat, bool isFolder)
    {
        // One folder may be around the whole lab.
        const QString inner = path.count(u'/') == limits::labDepth ? path.section(u'/', 1) : path;
        if (const QString wrong = faultOfLabPath(inner); !wrong.isEmpty())
            return fault(path, wrong);
        if (const QString wrong = faultOfLabPath(path.section(u'/', 0, 0)); !wrong.isEmpty())
            return fault(path, wrong);
        zip_uint8_t system = 0;
        zip_uint32_t attributes = 0;
        zip_file_get_external_attributes(m_archive, index, ZIP_FL_UNCHANGED, &system, &attributes);
        const zip_uint32_t kind = system == ZIP_OPSYS_UNIX ? (attributes >> 16) & S_IFMT : 0;
        if (kind != 0 && kind != (isFolder ? S_IFDIR : S_IFREG))
            return fault(path, UnpackText::tr("this is a link or a special file; a plain file is "
                                              "right"));
        if (isFolder)
            return std::nullopt;
        if (stat.encryption_method != ZIP_EM_NONE)
            return fault(path, UnpackText::tr("this is encrypted; a file without a password is "
                                              "right"));
        if (stat.size > zip_uint64_t(limits::labFileBytes))
            return fault(path, UnpackText::tr("the file is too large; at most %1 are right")
                                   .arg(sizeText(limits::labFileBytes)));
        if (stat.size > ratioCounts && stat.size / mostRatio > stat.comp_size)
            return fault(path, UnpackText::tr("this unpacks to more than %1 times its size, as "
                                              "no honest file does")
                                   .arg(mostRatio));
        m_declared += stat.size;
        if (m_declared > zip_uint64_t(limits::labBytes))
            return fault(path, UnpackText::tr("all of it is too large; at most %1 are right")
                                   .arg(sizeText(limits::labBytes)));
        return faultOfName(path);
    }

    /// Names that are one name, or a file and a folder, on some file system.
    std::optional<Error> faultOfName(const QString &path)
    {
        const QString key = path.normalized(QString::NormalizationForm_C).toCaseFolded();
        bool clash = m_names.contains(key) || m_folders.contains(key);
        for (QString above = key.section(u'/', 0, -2); !above.isEmpty();
             above = above.section(u'/', 0, -2)) {
            clash = clash || m_names.contains(above);
            m_folders.insert(above);
        }
        m_names.insert(key);
        if (!clash)
            return std::nullopt;
        return fault(path, UnpackText::tr("the name is there twice (but for capital letters); a "
                                          "name of its own is right"));
    }

    std::optional<Error> read(zip_uint64_t index, const QString &path, const zip_stat_t &stat)
    {
        const ZipFile file(zip_fopen_index(m_archive, index, ZIP_FL_UNCHANGED));
        if (!file)
            return fault(path, brokenText());
        // One byte more than declared tells that it lied, and asks for the checksum.
        QByteArray content(qsizetype(stat.size) + 1, Qt::Uninitialized);
        qsizetype filled = 0;
        while (true) { // until there is no more, or no room for it
            const zip_int64_t more = zip_fread(file.get(), content.data() + filled,
                                               zip_uint64_t(content.size() - filled));
            if (more < 0)
                return fault(path, brokenText());
            if (more == 0)
                break;
            filled += qsizetype(more);
        }
        if (filled != qsizetype(stat.size))
            return fault(path, UnpackText::tr("this unpacks to another size than it says"));
        content.chop(1);
        m_files.contents.insert(path, content);
        return std::nullopt;
    }

    static QString brokenText()
    {
        return UnpackText::tr("this is broken or packed in an unknown way");
    }

    /// Archives of a folder hold "NAME/lab.json".
    [[nodiscard]] Result<LabFiles> withoutTopFolder() const
    {
        if (m_files.contents.contains(m_index))
            return withRightPaths(m_files);
        const QString top = m_files.contents.isEmpty()
                                ? QString()
                                : m_files.contents.firstKey().section(u'/', 0, 0) + u'/';
        LabFiles inner;
        for (auto it = m_files.contents.begin(); it != m_files.contents.end(); ++it) {
            if (it.key().startsWith(top))
                inner.contents.insert(it.key().mid(top.size()), *it);
        }
        if (inner.contents.size() != m_files.contents.size() || !inner.contents.contains(m_index))
            return fault({}, UnpackText::tr("there is no %1 in it").arg(m_index));
        return withRightPaths(inner);
    }

    [[nodiscard]] Result<LabFiles> withRightPaths(const LabFiles &files) const
    {
        for (auto it = files.contents.begin(); it != files.contents.end(); ++it) {
            if (const QString wrong = faultOfLabPath(it.key()); !wrong.isEmpty())
                return fault(it.key(), wrong);
        }
        return files;
    }

    zip_t *m_archive;
    QString m_source;
    QString m_index; ///< the file that there must be
    LabFiles m_files{};
    QSet<QString> m_names{};
    QSet<QString> m_folders{};
    zip_uint64_t m_declared = 0; ///< bytes
};

} // namespace

Result<LabFiles> unpackLab(const QByteArray &archive, const QString &source)
{
    return unpackFiles(archive, source, QStringLiteral("lab.json"));
}

Result<LabFiles> unpackFiles(const QByteArray &archive, const QString &source, const QString &index)
{
    ZipError error;
    const auto refuse = [&] {
        return Error{
            .message =
                UnpackText::tr("this is no archive: %1").arg(QString::fromUtf8(error.text())),
            .file = source};
    };
    ZipSource memory(
        zip_source_buffer_create(archive.constData(), zip_uint64_t(archive.size()), 0, error));
    if (!memory)
        return refuse();
    const ZipArchive opened(zip_open_from_source(memory.get(), ZIP_RDONLY | ZIP_CHECKCONS, error));
    if (!opened)
        return refuse();
    (void)memory.release(); // the archive owns it now
    return Unpacker(opened.get(), source, index).unpack();
}

} // namespace cradle
