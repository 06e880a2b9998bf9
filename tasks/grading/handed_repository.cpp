// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/handed_repository.h"

#include "tasks/grading/raw_folder.h"

#include <QCoreApplication>

#include <sys/stat.h>

namespace cradle {

namespace {

struct RepositoryText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr qint64 mostRepositoryBytes = 32 * 1024 * 1024; ///< of all
constexpr std::size_t mostRepositoryFiles = 20'000;      ///< and folders
constexpr int deepestFolder = 8;

class RepositoryReader
{
public:
    RepositoryReader(const QByteArray &root, const QByteArray &folder)
        : m_root(root)
        , m_folder(folder)
    {
    }

    Result<RepositoryFiles> read()
    {
        if (!isFolder(m_folder))
            return RepositoryFiles();
        for (const char *file : {"HEAD", "packed-refs"})
            take(file);
        for (const char *folder : {"refs", "objects"}) {
            if (isFolder(m_folder + '/' + folder))
                walk(folder, 0);
        }
        if (m_left >= 0 && m_seen <= mostRepositoryFiles)
            return std::move(m_files);
        return Error{.message = RepositoryText::tr("the history is too large to be looked at")};
    }

private:
    void walk(const QByteArray &below, int depth)
    {
        const auto entries = entriesOf(m_folder + '/' + below, mostRepositoryFiles);
        if (!entries)
            return;
        for (const FolderEntry &entry : *entries) {
            const QByteArray path = below + '/' + entry.name;
            if (entry.kind == FolderEntry::Kind::Folder && depth < deepestFolder)
                walk(path, depth + 1);
            else if (entry.kind == FolderEntry::Kind::File && isOfHistory(path))
                take(path);
            if (m_left < 0 || ++m_seen > mostRepositoryFiles)
                return;
        }
    }

    /// And no link to one, behind which anything may be.
    static bool isFolder(const QByteArray &path)
    {
        struct stat info {
        };
        return lstat(path.constData(), &info) == 0 && S_ISDIR(info.st_mode);
    }

    /// Of a file that is too large a byte more is read, so that it is seen.
    void take(const QByteArray &path)
    {
        auto bytes = readBelow(m_root, m_folder + '/' + path, m_left + 1);
        if (!bytes)
            return;
        m_left -= bytes->size();
        m_files.insert(QString::fromUtf8(path), *bytes);
    }

    const QByteArray &m_root;
    const QByteArray &m_folder;
    RepositoryFiles m_files{};
    qint64 m_left = mostRepositoryBytes;
    std::size_t m_seen = 0;
};

} // namespace

bool isOfHistory(const QByteArray &path)
{
    if (path.startsWith("objects/pack/"))
        return path.endsWith(".idx") || path.endsWith(".pack");
    return path == "HEAD" || path == "packed-refs" || path.startsWith("refs/")
           || (path.startsWith("objects/") && !path.startsWith("objects/info/"));
}

Result<RepositoryFiles> readRepository(const QByteArray &root, const QByteArray &folder)
{
    return RepositoryReader(root, folder).read();
}

} // namespace cradle
