// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/history.h"

#include "model/files/file_io.h"
#include "tasks/workspace/history_parts.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>

namespace cradle {

namespace {

/// What of the folder is the student's work; all else there is nobody's business.
constexpr std::pair<const char *, const char *> workFiles[] = {
    {"", "lab.lua"},    {"", "cradle.json"},   {"", "predictions.json"}, {"", "answers.json"},
    {"steps", "*.lua"}, {"presets", "*.json"}, {"notes", "*.md"}};

QStringList workPaths(const QString &folder)
{
    QStringList paths;
    for (const auto &[below, pattern] : workFiles) {
        const QString start = *below ? QLatin1String(below) + QLatin1Char('/') : QString();
        const QDir dir(folder + QLatin1Char('/') + QLatin1String(below));
        for (const QString &name : dir.entryList({QLatin1String(pattern)}, QDir::Files, QDir::Name))
            paths.append(start + name);
    }
    return paths;
}

/// Puts the files as they are into the index, and takes those out that are gone.
bool addAll(git_index *index, const QString &folder)
{
    const QStringList paths = workPaths(folder);
    for (std::size_t i = git_index_entrycount(index); i-- > 0;) {
        const QString path = QString::fromUtf8(git_index_get_byindex(index, i)->path);
        if (!paths.contains(path) && !QFile::exists(folder + QLatin1Char('/') + path)
            && git_index_remove_bypath(index, path.toUtf8().constData()) != 0)
            return false;
    }
    for (const QString &path : paths) {
        if (git_index_add_bypath(index, path.toUtf8().constData()) != 0)
            return false;
    }
    return true;
}

/// Contents that are not, or not as they are to be, on the disk.
bool addInstead(git_repository *repository, git_index *index,
                const QMap<QString, QByteArray> &contents)
{
    for (auto it = contents.begin(); it != contents.end(); ++it) {
        const QByteArray path = it.key().toUtf8();
        git_index_entry entry{};
        entry.mode = GIT_FILEMODE_BLOB;
        entry.path = path.constData();
        if (git_blob_create_from_buffer(&entry.id, repository, it->constData(),
                                        static_cast<std::size_t>(it->size()))
                != 0
            || git_index_add(index, &entry) != 0)
            return false;
    }
    return true;
}

/// Of all repositories: libgit2 knows no other way.
void setSyncing(bool on)
{
    git_libgit2_opts(GIT_OPT_ENABLE_FSYNC_GITDIR, on ? 1 : 0);
}

} // namespace

QByteArray versionsRef(const QString &taskId)
{
    return versionsFolder + taskId.toUtf8();
}

QString History::Parts::userName() const
{
    const auto config = makeGit<GitConfig>(git_repository_config_snapshot, repository.get());
    const char *name = nullptr;
    return config && git_config_get_string(&name, config.get(), "user.name") == 0
               ? QString::fromUtf8(name)
               : QString();
}

GitSignature History::Parts::signature(const QString &author) const
{
    if (auto own = makeGit<GitSignature>(git_signature_default, repository.get()))
        return own;
    const QString known = userName();
    // Git refuses some letters in names, and an empty one.
    QByteArray signing = (known.isEmpty() ? author.simplified() : known).toUtf8();
    signing.replace('<', "").replace('>', "");
    if (auto made =
            makeGit<GitSignature>(git_signature_now, signing.constData(), "student@localhost"))
        return made;
    return makeGit<GitSignature>(git_signature_now, "Student", "student@localhost");
}

GitCommit History::Parts::commitAt(const char *reference) const
{
    git_oid id;
    return git_reference_name_to_id(&id, repository.get(), reference) == 0
               ? makeGit<GitCommit>(git_commit_lookup, repository.get(), &id)
               : nullptr;
}

std::optional<QByteArray> History::Parts::textIn(const git_commit *commit,
                                                 const QString &path) const
{
    const auto tree = commit ? makeGit<GitTree>(git_commit_tree, commit) : nullptr;
    const auto entry =
        tree ? makeGit<GitTreeEntry>(git_tree_entry_bypath, tree.get(), path.toUtf8().constData())
             : nullptr;
    const auto blob =
        entry ? makeGit<GitBlob>(git_blob_lookup, repository.get(), git_tree_entry_id(entry.get()))
              : nullptr;
    if (!blob)
        return std::nullopt;
    const auto size = static_cast<qsizetype>(git_blob_rawsize(blob.get()));
    return QByteArray(static_cast<const char *>(git_blob_rawcontent(blob.get())), size);
}

History::History(std::unique_ptr<Parts> parts)
    : m_parts(std::move(parts))
{
}

History::~History()
{
    setSyncing(true);
}

Result<std::unique_ptr<History>> History::openExisting(const QString &folder)
{
    auto parts = std::make_unique<Parts>();
    parts->folder = folder;
    const QByteArray path = QFile::encodeName(folder);
    // The folder itself: one above it may be a repository of somebody else.
    parts->repository =
        makeGit<GitRepository>(git_repository_open_ext, path.constData(),
                               static_cast<unsigned>(GIT_REPOSITORY_OPEN_NO_SEARCH), nullptr);
    if (!parts->repository)
        return parts->fault();
    setSyncing(true);
    return std::unique_ptr<History>(new History(std::move(parts)));
}

Result<std::unique_ptr<History>> History::open(const QString &folder)
{
    if (QFile::exists(folder + QStringLiteral("/.git")))
        return openExisting(folder);
    if (const auto error = makeFolder(folder))
        return *error;
    const GitLibrary library;
    git_repository_init_options options{};
    git_repository_init_options_init(&options, GIT_REPOSITORY_INIT_OPTIONS_VERSION);
    options.flags = GIT_REPOSITORY_INIT_MKDIR | GIT_REPOSITORY_INIT_NO_REINIT;
    options.initial_head = "main";
    const auto made = makeGit<GitRepository>(git_repository_init_ext,
                                             QFile::encodeName(folder).constData(), &options);
    if (!made)
        return gitError(folder);
    const auto error = writeFile(folder + QStringLiteral("/.git/info/exclude"),
                                 QByteArray(unfinishedPrefix) + "*\n");
    if (error)
        return *error;
    return openExisting(folder);
}

Result<std::unique_ptr<History>> History::makeDerivable(const QString &folder)
{
    auto history = open(folder);
    setSyncing(false);
    return history;
}

QString History::gitFolder() const
{
    return QFile::decodeName(git_repository_path(m_parts->repository.get()));
}

void History::removeLocksSince(const QDateTime &since)
{
    const QString own = gitFolder();
    const auto removeIn = [&since](QDirIterator &files) {
        while (files.hasNext()) {
            files.next();
            if (files.fileInfo().lastModified() >= since)
                QFile::remove(files.filePath());
        }
    };
    const QStringList locks{QStringLiteral("*.lock")};
    QDirIterator files(own, locks, QDir::Files | QDir::Hidden);
    removeIn(files);
    QDirIterator references(own + QStringLiteral("refs"), locks, QDir::Files | QDir::Hidden,
                            QDirIterator::Subdirectories);
    removeIn(references);
}

bool History::isEmpty() const
{
    return !m_parts->commitAt("HEAD");
}

QString History::gitName() const
{
    return m_parts->userName();
}

std::optional<Error> History::commit(const QString &message, const QString &author,
                                     const QMap<QString, QByteArray> &instead)
{
    git_repository *repository = m_parts->repository.get();
    const auto index = makeGit<GitIndex>(git_repository_index, repository);
    git_oid treeId;
    if (!index || !addAll(index.get(), m_parts->folder)
        || !addInstead(repository, index.get(), instead) || git_index_write(index.get()) != 0
        || git_index_write_tree(&treeId, index.get()) != 0)
        return m_parts->fault();
    const auto tree = makeGit<GitTree>(git_tree_lookup, repository, &treeId);
    const GitSignature who = m_parts->signature(author);
    const GitCommit before = m_parts->commitAt("HEAD");
    const git_commit *parent = before.get();
    git_oid id;
    if (!tree || !who
        || git_commit_create(&id, repository, "HEAD", who.get(), who.get(), "UTF-8",
                             message.toUtf8().constData(), tree.get(), before ? 1 : 0, &parent)
               != 0)
        return m_parts->fault();
    return std::nullopt;
}

std::optional<Error> History::keep(const QString &taskId, const QByteArray &text,
                                   const VersionNote &note, const QString &author,
                                   const QDateTime &when)
{
    return keepFile(versionsRef(taskId), QStringLiteral("steps/%1.lua").arg(taskId), text,
                    versionMessage(taskId, note), author, when);
}

std::optional<Error> History::keepNote(const QString &taskId, const QByteArray &text,
                                       const QString &author)
{
    const QByteArray reference = notesFolder + taskId.toUtf8();
    const QString path = QStringLiteral("notes/%1.md").arg(taskId);
    if (m_parts->textIn(m_parts->commitAt(reference.constData()).get(), path) == text)
        return std::nullopt;
    return keepFile(reference, path, text,
                    QStringLiteral("%1: notes\n\nCradle-Step: %1\n").arg(taskId), author, {});
}

/// A commit that holds one file, after those of \p reference.
std::optional<Error> History::keepFile(const QByteArray &reference, const QString &path,
                                       const QByteArray &text, const QString &message,
                                       const QString &author, const QDateTime &when)
{
    git_repository *repository = m_parts->repository.get();
    const auto index = makeGit<GitIndex>(git_index_new);
    git_oid treeId;
    if (!index || !addInstead(repository, index.get(), {{path, text}})
        || git_index_write_tree_to(&treeId, index.get(), repository) != 0)
        return m_parts->fault();
    const auto tree = makeGit<GitTree>(git_tree_lookup, repository, &treeId);
    const GitSignature who = m_parts->signature(author);
    if (who && when.isValid())
        who->when = {when.toSecsSinceEpoch(), 0, '+'};
    const GitCommit before = m_parts->commitAt(reference.constData());
    const git_commit *parent = before.get();
    git_oid id;
    if (!tree || !who
        || git_commit_create(&id, repository, reference.constData(), who.get(), who.get(), "UTF-8",
                             message.toUtf8().constData(), tree.get(), before ? 1 : 0, &parent)
               != 0)
        return m_parts->fault();
    return std::nullopt;
}

} // namespace cradle
