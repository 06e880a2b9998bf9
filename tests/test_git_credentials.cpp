// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/git_credentials.h"

#include "git_home.h"
#include "model/files/file_io.h"
#include "model/files/json_schema.h"

#include <QTest>

#include <memory>

using namespace cradle;

/// What a remote asks is answered by the user's agent and git's own helper, each once.
class TestGitCredentials : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { git_libgit2_init(); }
    void cleanupTestCase() { git_libgit2_shutdown(); }
    void helperIsAskedOnce();
    void helperThatKnowsNothingIsNoAnswer();
    void agentComesFirst();
    void nameAloneIsGiven();

private:
    /// What one that says \p words to every question makes of it.
    void answerWith(const QString &words);
    /// What the helper was asked.
    [[nodiscard]] QString asked() const;

    GitHome m_home{};
    QTemporaryDir m_folder{};
    QString m_refusal{};
};

namespace {

constexpr auto address = "https://ada@git.school.org:81/labs/one%0Aworld.git";

/// One credential, or none.
class Answer
{
public:
    Answer(CredentialAsker &asker, unsigned allowed, const char *user = nullptr)
    {
        git_credential *made = nullptr;
        code = CredentialAsker::ask(&made, address, user, allowed, &asker);
        m_made.reset(made);
    }
    [[nodiscard]] QByteArray user() const
    {
        return m_made ? QByteArray(git_credential_get_username(m_made.get())) : QByteArray();
    }
    int code = 0;

private:
    std::unique_ptr<git_credential, decltype(&git_credential_free)> m_made{nullptr,
                                                                           git_credential_free};
};

} // namespace

void TestGitCredentials::answerWith(const QString &words)
{
    const QString helper = m_folder.filePath(QStringLiteral("helper"));
    const QString script = QStringLiteral("#!/bin/sh\ncat > '%1'\nprintf '%2'\n")
                               .arg(m_folder.filePath(QStringLiteral("asked")), words);
    QVERIFY(!writeFile(helper, script.toUtf8()));
    QVERIFY(QFile::setPermissions(helper, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
    QVERIFY(!writeFile(qEnvironmentVariable("HOME") + QStringLiteral("/.gitconfig"),
                       QStringLiteral("[credential]\n  helper = %1\n  useHttpPath = true\n")
                           .arg(helper)
                           .toUtf8()));
}

QString TestGitCredentials::asked() const
{
    const auto bytes = readFile(m_folder.filePath(QStringLiteral("asked")), 10'000);
    return bytes ? QString::fromUtf8(*bytes) : QString();
}

/// A line end in an address stays a part of its path.
void TestGitCredentials::helperIsAskedOnce()
{
    answerWith(QStringLiteral("username=bob\\npassword=se=cret\\n"));
    CredentialAsker asker(m_refusal);
    const Answer answer(asker, GIT_CREDENTIAL_USERPASS_PLAINTEXT);
    QCOMPARE(answer.code, 0);
    QCOMPARE(answer.user(), QByteArray("bob"));
    const QString question = asked();
    for (const char *line : {"protocol=https\n", "host=git.school.org:81\n", "username=ada\n"})
        QVERIFY2(question.contains(QLatin1String(line)), qPrintable(question));
    QVERIFY2(question.contains(QStringLiteral("path=labs/one")), qPrintable(question));
    QVERIFY2(!question.contains(QStringLiteral("\nworld")), qPrintable(question));
    QCOMPARE(Answer(asker, GIT_CREDENTIAL_USERPASS_PLAINTEXT).code, int(GIT_EAUTH));
}

void TestGitCredentials::helperThatKnowsNothingIsNoAnswer()
{
    answerWith(QString());
    CredentialAsker asker(m_refusal);
    const Answer answer(asker, GIT_CREDENTIAL_USERPASS_PLAINTEXT);
    QCOMPARE(answer.code, int(GIT_EAUTH));
    QVERIFY(answer.user().isEmpty());
}

void TestGitCredentials::agentComesFirst()
{
    answerWith(QStringLiteral("username=bob\\npassword=secret\\n"));
    CredentialAsker asker(m_refusal);
    const unsigned both = GIT_CREDENTIAL_SSH_KEY | GIT_CREDENTIAL_USERPASS_PLAINTEXT;
    QCOMPARE(Answer(asker, both, "ada").user(), QByteArray("ada"));
    QCOMPARE(Answer(asker, both, "ada").user(), QByteArray("bob"));
    QCOMPARE(Answer(asker, both, "ada").code, int(GIT_EAUTH));
    CredentialAsker other(m_refusal);
    QCOMPARE(Answer(other, GIT_CREDENTIAL_SSH_KEY).user(), QByteArray("git"));
    QCOMPARE(Answer(other, GIT_CREDENTIAL_SSH_KEY).code, int(GIT_EAUTH));
}

void TestGitCredentials::nameAloneIsGiven()
{
    CredentialAsker asker(m_refusal);
    for (int i = 0; i < 2; ++i) {
        QCOMPARE(Answer(asker, GIT_CREDENTIAL_USERNAME, "ada").user(), QByteArray("ada"));
        QCOMPARE(Answer(asker, GIT_CREDENTIAL_USERNAME).user(), QByteArray("git"));
    }
    QCOMPARE(Answer(asker, 0).code, int(GIT_EAUTH));
}

QTEST_GUILESS_MAIN(TestGitCredentials)
#include "test_git_credentials.moc"
