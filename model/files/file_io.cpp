// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/file_io.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRandomGenerator>

#include <cerrno>
#include <cstdio>
#include <cstdlib>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace cradle {

namespace {

struct FileText {
    Q_DECLARE_TR_FUNCTIONS(FileIo)
};

constexpr mode_t allMayWrite = 0666; ///< less the umask
constexpr int mostAttempts = 100;    ///< to find a name that nobody has

Error errorOf(int number, const QString &path)
{
    return {.message = wordsForFault(number), .file = path};
}

/// \return errno, or 0 if all was written
int writeAll(int descriptor, const char *data, qsizetype size)
{
    while (size > 0) {
        const ssize_t written =
            TEMP_FAILURE_RETRY(::write(descriptor, data, static_cast<std::size_t>(size)));
        if (written < 0)
            return errno;
        if (written == 0)
            return ENOSPC;
        data += written;
        size -= written;
    }
    return 0;
}

/// Whether there is something that must not be replaced: a device, a pipe, or what only stands
/// for a file that is open already.
bool isWrittenTo(const QByteArray &path, const struct stat &there)
{
    return (!S_ISREG(there.st_mode) && !S_ISDIR(there.st_mode)) || path == "/dev/stdout"
           || path == "/dev/stderr" || path.startsWith("/dev/fd/") || path.startsWith("/proc/");
}

/// A new file beside the one that is to be replaced; \p path becomes its name.
/// \return its descriptor, or -1 and errno
int openUnfinished(QByteArray &path)
{
    const QByteArray start = path + unfinishedPrefix;
    for (int attempt = 0; attempt < mostAttempts; ++attempt) {
        path = start + QByteArray::number(QRandomGenerator::global()->generate64(), 36);
        const int descriptor =
            ::open(path.constData(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, allMayWrite);
        if (descriptor >= 0 || errno != EEXIST)
            return descriptor;
    }
    return -1;
}

} // namespace

QString wordsForFault(int number)
{
    switch (number) {
    case ENOSPC:
        return FileText::tr("the disk is full");
    case EDQUOT:
        return FileText::tr("your share of the disk is full");
    case EFBIG:
        return FileText::tr("a file may not be so large here");
    case EROFS:
        return FileText::tr("the disk is read-only");
    case EACCES:
    case EPERM:
        return FileText::tr("you may not write here");
    case ENOENT:
        return FileText::tr("there is no such folder");
    case ENOTDIR:
    case EEXIST:
        return FileText::tr("a file is where a folder should be");
    case EISDIR:
        return FileText::tr("this is a folder; the name of a file is right");
    case ENAMETOOLONG:
        return FileText::tr("the name is too long");
    case EBADF:
        return FileText::tr("it is closed");
    case EIO:
        return FileText::tr("the disk has a fault");
    default:
        return qt_error_string(number);
    }
}

WholeFile::WholeFile(const QString &path)
    : m_path(path)
{
    open();
}

WholeFile::~WholeFile()
{
    giveUp();
}

void WholeFile::open()
{
    m_target = QFile::encodeName(m_path);
    struct stat there {
    };
    const bool exists = ::stat(m_target.constData(), &there) == 0;
    if (exists && isWrittenTo(m_target, there)) {
        m_descriptor = ::open(m_target.constData(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
        if (m_descriptor < 0)
            fail(errno);
        return;
    }
    if (exists && S_ISDIR(there.st_mode))
        return fail(EISDIR);
    if (m_path.isEmpty())
        return fail(ENOENT);
    if (exists) {
        // Who may not write the file must not replace it, even if the folder would let them.
        if (::access(m_target.constData(), W_OK) != 0)
            return fail(errno);
        if (char *real = ::realpath(m_target.constData(), nullptr)) {
            m_target = real;
            std::free(real);
        }
    }
    const auto slash = m_target.lastIndexOf('/');
    m_unfinished = m_target.left(slash + 1);
    m_descriptor = openUnfinished(m_unfinished);
    if (m_descriptor < 0) {
        m_unfinished.clear();
        return fail(errno);
    }
    // On some disks there are no permissions, and then none to keep.
    if (exists && ::fchmod(m_descriptor, there.st_mode & 07777) != 0 && errno == EIO)
        fail(errno);
}

void WholeFile::append(const QByteArray &part)
{
    if (m_fault != 0)
        return;
    if (const int fault = writeAll(m_descriptor, part.constData(), part.size()))
        fail(fault);
}

std::optional<Error> WholeFile::commit(Keeping keeping)
{
    const bool replaces = !m_unfinished.isEmpty();
    const bool syncs = replaces && keeping == Keeping::Synced;
    if (m_fault == 0 && syncs && ::fsync(m_descriptor) != 0 && errno != EINVAL)
        fail(errno);
    if (m_fault == 0) {
        const int descriptor = m_descriptor;
        m_descriptor = -1;
        if (::close(descriptor) != 0 && errno != EINTR)
            fail(errno);
    }
    if (m_fault == 0 && replaces) {
        if (::rename(m_unfinished.constData(), m_target.constData()) == 0)
            m_unfinished.clear();
        else
            fail(errno);
    }
    return m_fault == 0 ? std::nullopt : std::optional(errorOf(m_fault, m_path));
}

void WholeFile::fail(int number)
{
    m_fault = number;
    giveUp();
}

void WholeFile::giveUp()
{
    if (m_descriptor >= 0)
        ::close(m_descriptor);
    m_descriptor = -1;
    if (!m_unfinished.isEmpty())
        ::unlink(m_unfinished.constData());
    m_unfinished.clear();
}

std::optional<Error> writeFile(const QString &path, const QByteArray &content, Keeping keeping)
{
    WholeFile file(path);
    file.append(content);
    return file.commit(keeping);
}

std::optional<Error> writeStandardOutput(const QByteArray &content)
{
    std::fflush(stdout);
    if (const int fault = writeAll(STDOUT_FILENO, content.constData(), content.size()))
        return errorOf(fault, QStringLiteral("-"));
    return std::nullopt;
}

std::optional<Error> makeFolder(const QString &path)
{
    const QString clean = QDir::cleanPath(path);
    if (QFileInfo(clean).isDir())
        return std::nullopt;
    const QString parent = QFileInfo(clean).path();
    if (parent != clean) {
        if (auto error = makeFolder(parent))
            return error;
    }
    if (::mkdir(QFile::encodeName(clean).constData(), 0777) == 0)
        return std::nullopt;
    const int fault = errno; // before the next question to the disk answers it
    if (QFileInfo(clean).isDir())
        return std::nullopt;
    // What is there above: /proc says so of a name that it does not want.
    return errorOf(fault == ENOENT ? EACCES : fault, path);
}

void removeUnfinished(const QString &folder)
{
    QDir dir(folder);
    const QString pattern = QLatin1String(unfinishedPrefix) + QLatin1Char('*');
    for (const QString &name : dir.entryList({pattern}, QDir::Files | QDir::Hidden))
        dir.remove(name);
}

} // namespace cradle
