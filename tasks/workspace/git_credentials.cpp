// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/git_credentials.h"

#include <QDir>
#include <QMap>
#include <QProcess>
#include <QStandardPaths>
#include <QUrl>

namespace cradle {

namespace {

constexpr int helperPatience = 120'000; ///< ms: it may open a window and wait for the user

/// What "git credential fill" says: "key=value" lines.
QMap<QByteArray, QByteArray> fill(const QUrl &url)
{
    QMap<QByteArray, QByteArray> answer;
    const QString git = QStandardPaths::findExecutable(QStringLiteral("git"));
    if (git.isEmpty())
        return answer;
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    // Nobody looks at a terminal.
    environment.insert(QStringLiteral("GIT_TERMINAL_PROMPT"), QStringLiteral("0"));
    process.setProcessEnvironment(environment);
    // Not where somebody else's repository could name a helper of its own.
    process.setWorkingDirectory(QDir::rootPath());
    process.start(git, {QStringLiteral("credential"), QStringLiteral("fill")});
    // Encoded: a line end in an address would ask for what is another's.
    QString question =
        QStringLiteral("protocol=%1\nhost=%2\npath=%3\n")
            .arg(url.scheme(), url.adjusted(QUrl::RemoveUserInfo).authority(QUrl::FullyEncoded),
                 url.path(QUrl::FullyEncoded).mid(1));
    if (!url.userName().isEmpty())
        question += QStringLiteral("username=%1\n").arg(url.userName(QUrl::FullyEncoded));
    process.write(question.toUtf8() + '\n');
    process.closeWriteChannel();
    if (!process.waitForFinished(helperPatience)) {
        process.kill();
        process.waitForFinished();
        return answer;
    }
    for (const QByteArray &line : process.readAllStandardOutput().split('\n')) {
        if (const auto equals = line.indexOf('='); equals > 0)
            answer.insert(line.left(equals), line.mid(equals + 1));
    }
    return answer;
}

} // namespace

int CredentialAsker::ask(git_credential **out, const char *url, const char *user, unsigned allowed,
                         void *payload)
{
    auto *asker = static_cast<CredentialAsker *>(payload);
    if ((allowed & GIT_CREDENTIAL_SSH_KEY) && !asker->m_agentAsked)
        return asker->askAgent(out, user);
    if ((allowed & GIT_CREDENTIAL_USERPASS_PLAINTEXT) && !asker->m_helperAsked)
        return asker->askHelper(out, url);
    if (allowed & GIT_CREDENTIAL_USERNAME)
        return git_credential_username_new(out, user ? user : "git");
    return GIT_EAUTH; // what was known is not right
}

int CredentialAsker::askAgent(git_credential **out, const char *user)
{
    m_agentAsked = true;
    return git_credential_ssh_key_from_agent(out, user ? user : "git");
}

int CredentialAsker::askHelper(git_credential **out, const char *url)
{
    m_helperAsked = true;
    const auto answer = fill(QUrl(QString::fromUtf8(url)));
    const QByteArray name = answer.value("username");
    const QByteArray password = answer.value("password");
    if (name.isEmpty() && password.isEmpty())
        return GIT_EAUTH;
    return git_credential_userpass_plaintext_new(out, name.constData(), password.constData());
}

} // namespace cradle
