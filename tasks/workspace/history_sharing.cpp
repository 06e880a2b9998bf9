// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/history.h"

#include "tasks/workspace/git_credentials.h"
#include "tasks/workspace/history_parts.h"

#include <QFile>
#include <QFileInfo>

#include <vector>

namespace cradle {

// The work on other machines: a remote repository, or a bundle.

namespace {

constexpr char remoteName[] = "origin";

struct RemoteText {
    Q_DECLARE_TR_FUNCTIONS(Workspace)
};

using GitPackbuilder = std::unique_ptr<git_packbuilder, FreeGit<git_packbuilder_free>>;

/// A reference that the other side did not take.
int noteRefusal(const char *reference, const char *status, void *refusal)
{
    if (status)
        *static_cast<QString *>(refusal) =
            QStringLiteral("%1: %2").arg(QString::fromUtf8(reference), QString::fromUtf8(status));
    return 0;
}

/// The names of the references that are shared: the branch, and the versions.
std::vector<QByteArray> sharedRefs(git_repository *repository)
{
    std::vector<QByteArray> names;
    git_strarray all{};
    if (git_reference_list(&all, repository) != 0)
        return names;
    for (std::size_t i = 0; i < all.count; ++i) {
        const QByteArray name(all.strings[i]);
        if (name.startsWith("refs/heads/") || name.startsWith(versionsFolder)
            || name.startsWith(notesFolder))
            names.push_back(name);
    }
    git_strarray_dispose(&all);
    return names;
}

QByteArray hexOf(const git_oid &id)
{
    char hex[GIT_OID_HEXSZ + 1] = {};
    git_oid_fmt(hex, &id);
    return hex;
}

/// Why a push failed, in the words of this page where git's own say little.
QString wordsForPush(int result, const QString &url)
{
    const bool isLocal = url.startsWith(QLatin1Char('/')) || url.startsWith(QLatin1Char('.'));
    if (isLocal && !QFileInfo::exists(url))
        return RemoteText::tr("there is no git repository at this address");
    if (result == GIT_ENONFASTFORWARD)
        return RemoteText::tr("there is other work at this address, which yours does not go on "
                              "from; give another address");
    const git_error *last = git_error_last();
    const QString said = QString::fromUtf8(last ? last->message : "?");
    return said.contains(QLatin1String("unsupported URL protocol"))
               ? RemoteText::tr("this is no address of a git repository")
               : said;
}

} // namespace

QString History::remoteUrl() const
{
    const auto remote =
        makeGit<GitRemote>(git_remote_lookup, m_parts->repository.get(), remoteName);
    return remote ? QString::fromUtf8(git_remote_url(remote.get())) : QString();
}

std::optional<Error> History::setRemoteUrl(const QString &url)
{
    git_repository *repository = m_parts->repository.get();
    const QByteArray address = url.trimmed().toUtf8();
    const bool there = !remoteUrl().isEmpty();
    int result = 0;
    if (address.isEmpty())
        result = there ? git_remote_delete(repository, remoteName) : 0;
    else if (there)
        result = git_remote_set_url(repository, remoteName, address.constData());
    else
        result = makeGit<GitRemote>(git_remote_create, repository, remoteName, address.constData())
                     ? 0
                     : -1;
    return result == 0 ? std::nullopt : std::optional(m_parts->fault());
}

std::optional<Error> History::push()
{
    const auto remote =
        makeGit<GitRemote>(git_remote_lookup, m_parts->repository.get(), remoteName);
    if (!remote)
        return Error{.message = RemoteText::tr("there is no address to share with yet")};
    const QString url = QString::fromUtf8(git_remote_url(remote.get()));
    std::vector<QByteArray> specs;
    for (const QByteArray &name : sharedRefs(m_parts->repository.get()))
        specs.push_back(name + ':' + name);
    std::vector<char *> pointers;
    for (QByteArray &spec : specs)
        pointers.push_back(spec.data());
    const git_strarray all{pointers.data(), pointers.size()};
    git_push_options options{};
    git_push_options_init(&options, GIT_PUSH_OPTIONS_VERSION);
    QString refusal;
    CredentialAsker asker(refusal);
    options.callbacks.payload = &asker;
    options.callbacks.credentials = CredentialAsker::ask;
    options.callbacks.push_update_reference = [](const char *name, const char *status, void *data) {
        return noteRefusal(name, status, &static_cast<CredentialAsker *>(data)->refusal());
    };
    if (const int result = git_remote_push(remote.get(), &all, &options); result != 0)
        return Error{
            .message =
                RemoteText::tr("your work could not be sent: %1").arg(wordsForPush(result, url)),
            .file = url};
    if (!refusal.isEmpty())
        return Error{.message =
                         RemoteText::tr("the other side did not take your work: %1").arg(refusal),
                     .file = url};
    return std::nullopt;
}

QDateTime History::lastPush() const
{
    // Of the branch that is checked out; where the work was cloned from, it may have another name.
    const auto head = makeGit<GitReference>(git_repository_head, m_parts->repository.get());
    const QByteArray branch = head ? git_reference_shorthand(head.get()) : "main";
    const GitCommit sent = m_parts->commitAt(("refs/remotes/origin/" + branch).constData());
    return sent ? QDateTime::fromSecsSinceEpoch(git_commit_time(sent.get()), Qt::UTC) : QDateTime();
}

Result<QByteArray> History::bundle() const
{
    git_repository *repository = m_parts->repository.get();
    const auto pack = makeGit<GitPackbuilder>(git_packbuilder_new, repository);
    const auto walk = makeGit<GitRevwalk>(git_revwalk_new, repository);
    if (!pack || !walk)
        return m_parts->fault();
    QByteArray header = "# v2 git bundle\n";
    git_oid id;
    for (const QByteArray &name : sharedRefs(repository)) {
        if (git_reference_name_to_id(&id, repository, name.constData()) != 0
            || git_revwalk_push(walk.get(), &id) != 0)
            return m_parts->fault();
        header += hexOf(id) + ' ' + name + '\n';
    }
    // What a clone checks out.
    if (git_reference_name_to_id(&id, repository, "HEAD") == 0)
        header += hexOf(id) + " HEAD\n";
    git_buf packed = GIT_BUF_INIT;
    if (git_packbuilder_insert_walk(pack.get(), walk.get()) != 0
        || git_packbuilder_write_buf(&packed, pack.get()) != 0)
        return m_parts->fault();
    const QByteArray bytes(packed.ptr, static_cast<qsizetype>(packed.size));
    git_buf_dispose(&packed);
    return header + '\n' + bytes;
}

} // namespace cradle
