// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/raw_folder.h"

#include "tasks/text/plain_text.h"

#include "model/files/file_io.h"
#include "tasks/grading/descriptors.h"

#include <QCoreApplication>
#include <QStringDecoder>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <memory>

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace cradle {

namespace {

struct RawFolderText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

struct CloseFolder {
    void operator()(DIR *folder) const { closedir(folder); }
};
struct FreeText {
    void operator()(char *text) const { std::free(text); }
};

FolderEntry::Kind kindOf(int folder, const char *name)
{
    struct stat info {
    };
    if (fstatat(folder, name, &info, AT_SYMLINK_NOFOLLOW) != 0)
        return FolderEntry::Kind::Other;
    if (S_ISREG(info.st_mode))
        return FolderEntry::Kind::File;
    if (S_ISDIR(info.st_mode))
        return FolderEntry::Kind::Folder;
    return S_ISLNK(info.st_mode) ? FolderEntry::Kind::Link : FolderEntry::Kind::Other;
}

/// Without links; empty if there is nothing.
QByteArray realPath(const QByteArray &path)
{
    const std::unique_ptr<char, FreeText> real(::realpath(path.constData(), nullptr));
    return real ? QByteArray(real.get()) : QByteArray();
}

} // namespace

Result<std::vector<FolderEntry>> entriesOf(const QByteArray &path, std::size_t most)
{
    const std::unique_ptr<DIR, CloseFolder> folder(opendir(path.constData()));
    if (!folder)
        return Error{.message =
                         errno == ENOTDIR
                             ? RawFolderText::tr("this is no folder")
                             : RawFolderText::tr("cannot be read: %1").arg(qt_error_string(errno)),
                     .file = shownName(path)};
    std::vector<FolderEntry> entries;
    while (const dirent *entry = readdir(folder.get())) {
        const QByteArray name(entry->d_name);
        if (name == "." || name == "..")
            continue;
        if (entries.size() == most)
            return Error{.message =
                             RawFolderText::tr("there are more than %1 files in it").arg(most),
                         .file = shownName(path)};
        entries.push_back({name, kindOf(dirfd(folder.get()), entry->d_name)});
    }
    std::sort(entries.begin(), entries.end(),
              [](const FolderEntry &a, const FolderEntry &b) { return a.name < b.name; });
    return entries;
}

Result<QByteArray> readBelow(const QByteArray &root, const QByteArray &path, qint64 most)
{
    const auto fault = [&](const QString &message) {
        return Error{.message = message, .file = shownName(path)};
    };
    const QByteArray real = realPath(path);
    if (real.isEmpty())
        return fault(RawFolderText::tr("cannot be read: %1").arg(qt_error_string(errno)));
    QByteArray within = realPath(root);
    if (!within.endsWith('/'))
        within += '/';
    if (!real.startsWith(within))
        return fault(RawFolderText::tr("this is a link that leads elsewhere; it is not followed"));
    // Without waiting, should it be a pipe after all.
    const Descriptor file(
        ::open(real.constData(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY));
    struct stat info {
    };
    if (!file || fstat(file.number(), &info) != 0)
        return fault(RawFolderText::tr("cannot be read: %1").arg(qt_error_string(errno)));
    if (!S_ISREG(info.st_mode))
        return fault(RawFolderText::tr("this is no plain file"));
    QByteArray bytes(std::min<qint64>(most, info.st_size), Qt::Uninitialized);
    qsizetype got = 0;
    while (got < bytes.size()) {
        const ssize_t size = TEMP_FAILURE_RETRY(::read(
            file.number(), bytes.data() + got, static_cast<std::size_t>(bytes.size() - got)));
        if (size < 0)
            return fault(RawFolderText::tr("cannot be read: %1").arg(qt_error_string(errno)));
        if (size == 0)
            break;
        got += size;
    }
    bytes.truncate(got);
    return bytes;
}

QString shownName(const QByteArray &name)
{
    QStringDecoder decode(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    QString text = decode(name);
    if (decode.hasError())
        text = QString::fromLatin1(name);
    text = printable(text);
    text.replace(QLatin1Char('\n'), QLatin1Char(' '));
    text.replace(QLatin1Char('\t'), QLatin1Char(' '));
    return text;
}

QByteArray lastName(const QByteArray &path)
{
    QByteArray clean = path;
    while (clean.endsWith('/'))
        clean.chop(1);
    return clean.mid(clean.lastIndexOf('/') + 1);
}

} // namespace cradle
