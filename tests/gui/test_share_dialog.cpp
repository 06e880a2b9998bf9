// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/share_dialog.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/workspace/workspace.h"
#include "tests/git_home.h"
#include "tests/patience.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

using namespace cradle;

/// Sending the work to a repository elsewhere, and what the dialog says of it.
class TestShareDialog final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void whatIsSentIsSaid();
    void whatKeepsItFromBeingSentIsSaid();
    void serverThatDoesNotAnswerHoldsNobodyUp();

private:
    [[nodiscard]] QString path(const char *name) const
    {
        return m_folder->filePath(QLatin1String(name));
    }

    GitHome m_home;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Workspace> m_workspace;
};

namespace {

void send(ShareDialog &dialog, const QString &address)
{
    dialog.findChild<QLineEdit *>()->setText(address);
    for (QPushButton *button : dialog.findChildren<QPushButton *>()) {
        if (button->text() == QStringLiteral("&Send"))
            button->click();
    }
}

QString said(const ShareDialog &dialog)
{
    QStringList words;
    for (const QLabel *label : dialog.findChildren<QLabel *>())
        words.append(label->text());
    return words.join(QLatin1Char('\n'));
}

/// Takes connections on this machine, and says nothing.
class SilentServer
{
public:
    SilentServer()
    {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        auto *general = reinterpret_cast<sockaddr *>(&address);
        if (bind(m_socket, general, size) == 0 && listen(m_socket, 4) == 0
            && getsockname(m_socket, general, &size) == 0)
            m_port = ntohs(address.sin_port);
    }
    ~SilentServer() { close(m_socket); }
    SilentServer(const SilentServer &) = delete;
    SilentServer &operator=(const SilentServer &) = delete;

    [[nodiscard]] int port() const { return m_port; }

private:
    int m_socket = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    int m_port = 0;
};

} // namespace

void TestShareDialog::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_workspace = std::make_unique<Workspace>(path("work"));
    QVERIFY(!m_workspace->begin(*readLab(QLatin1String(shippedLab))));
}

void TestShareDialog::whatIsSentIsSaid()
{
    GitHome::git(m_folder->path(), {QStringLiteral("init"), QStringLiteral("-q"),
                                    QStringLiteral("--bare"), QStringLiteral("b.git")});
    ShareDialog dialog(*m_workspace);
    QVERIFY2(said(dialog).contains(QStringLiteral("nothing yet")), qPrintable(said(dialog)));
    send(dialog, path("b.git"));
    QTRY_VERIFY(said(dialog).contains(QStringLiteral("All is sent.")));
    QVERIFY2(said(dialog).contains(QStringLiteral("up to the commit of")),
             qPrintable(said(dialog)));
    QVERIFY(GitHome::git(path("b.git"), {QStringLiteral("log"), QStringLiteral("--format=%s"),
                                         QStringLiteral("main")})
                .contains(QStringLiteral("Begin lab-4.2")));
}

void TestShareDialog::whatKeepsItFromBeingSentIsSaid()
{
    ShareDialog dialog(*m_workspace);
    send(dialog, path("nowhere.git"));
    QTRY_VERIFY(
        said(dialog).contains(QStringLiteral("there is no git repository at this address")));
    QVERIFY(said(dialog).contains(QStringLiteral("nothing yet")));
}

/// The dialog closes at once; that the test ends shows it.
void TestShareDialog::serverThatDoesNotAnswerHoldsNobodyUp()
{
    const SilentServer server;
    QVERIFY(server.port() > 0);
    {
        ShareDialog dialog(*m_workspace);
        send(dialog, QStringLiteral("git://127.0.0.1:%1/lab.git").arg(server.port()));
        QVERIFY(said(dialog).contains(QStringLiteral("Sending…")));
    }
    QVERIFY(!m_workspace->save(QStringLiteral("L42T1"), QStringLiteral("-- going on\n")));
}

QTEST_MAIN(TestShareDialog)
#include "test_share_dialog.moc"
