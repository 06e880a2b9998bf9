// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/server_process.h"

#include "tasks/grading/worker_server.h"

#include <QFile>
#include <QLibraryInfo>
#include <QStandardPaths>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace cradle {

namespace {

/// Puts descriptors where the server looks for them, and nothing else; in a forked process.
void keepOnly(int control, int lab)
{
    // Above the places where they go, so that none is overwritten before it is moved.
    control = fcntl(control, F_DUPFD, 10);
    lab = lab < 0 ? -1 : fcntl(lab, F_DUPFD, 10);
    const int nowhere = open("/dev/null", O_RDWR);
    for (int standard = 0; standard < 3; ++standard)
        dup2(nowhere, standard);
    dup2(control, serverControl);
    if (lab >= 0)
        dup2(lab, serverLab);
    close_range(lab < 0 ? serverControl + 1 : serverLab + 1, ~0U, 0);
}

/// How bubblewrap starts the server: of the disk it sees the system's libraries, this program and
/// the Qt that it runs with, which an archive brings along.
std::vector<QByteArray> commandLine(const QByteArray &bubblewrap, const QByteArray &program,
                                    const QByteArray &language)
{
    const QByteArray libraries = QFile::encodeName(QLibraryInfo::path(QLibraryInfo::LibrariesPath));
    std::vector<QByteArray> line{bubblewrap,
                                 "--unshare-all",
                                 "--die-with-parent",
                                 "--new-session",
                                 "--cap-drop",
                                 "ALL",
                                 "--ro-bind",
                                 "/usr",
                                 "/usr",
                                 "--ro-bind-try",
                                 "/lib",
                                 "/lib",
                                 "--ro-bind-try",
                                 "/lib64",
                                 "/lib64",
                                 "--ro-bind-try",
                                 "/etc/ld.so.cache",
                                 "/etc/ld.so.cache",
                                 "--ro-bind-try",
                                 libraries,
                                 libraries,
                                 "--ro-bind",
                                 program,
                                 program,
                                 "--proc",
                                 "/proc",
                                 "--chdir",
                                 "/",
                                 program,
                                 "judge-server",
                                 language};
    return line;
}

/// Runs bubblewrap until it ends or the other end of \p serverControl is closed, and ends with it.
/// The process that bubblewrap starts waits for it for ever where bubblewrap is killed early. Until
/// it has said that it wants to die with bubblewrap, it is of this process's group, which is killed
/// whole: here, or by ServerProcess::end() where this process was killed.
[[noreturn]] void guard(const std::vector<char *> &arguments)
{
    sigset_t children;
    sigemptyset(&children);
    sigaddset(&children, SIGCHLD);
    sigprocmask(SIG_BLOCK, &children, nullptr);
    const int childEnds = signalfd(-1, &children, SFD_CLOEXEC);
    const pid_t parent = getpid();
    const pid_t child = childEnds < 0 ? -1 : fork();
    if (child < 0)
        _exit(1);
    if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != parent)
            _exit(1);
        sigprocmask(SIG_UNBLOCK, &children, nullptr);
        execv(arguments.front(), arguments.data());
        _exit(1);
    }
    close(serverLab);
    int status = 0;
    bool ended = false;
    while (!ended) {
        std::array<pollfd, 2> watched{pollfd{serverControl, 0, 0}, pollfd{childEnds, POLLIN, 0}};
        if (poll(watched.data(), watched.size(), -1) < 0 && errno != EINTR)
            break;
        if (watched[0].revents != 0)
            break; // who asked for it is gone
        signalfd_siginfo ignored{};
        if (watched[1].revents != 0)
            (void)!read(childEnds, &ignored, sizeof ignored);
        ended = waitpid(child, &status, WNOHANG) == child;
    }
    if (!ended) {
        kill(child, SIGKILL);
        waitpid(child, &status, 0);
    }
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL)
        kill(0, SIGKILL); // and this one with them, as bubblewrap was
    _exit(WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status));
}

/// Waits until \p line is ready for \p what. \return false if the process \p server has ended
/// instead: what it left behind may hold the other end, and never read or write.
bool isReady(pid_t server, int line, short what)
{
    for (;;) {
        pollfd watched{line, what, 0};
        if (poll(&watched, 1, 200) > 0)
            return true;
        siginfo_t ended{};
        if (waitid(P_PID, static_cast<id_t>(server), &ended, WEXITED | WNOHANG | WNOWAIT) == 0
            && ended.si_pid == server)
            return false;
    }
}

} // namespace

ServerProcess ServerProcess::bubblewrapped(const QString &program, const QString &language)
{
    ServerProcess server;
    const QString found = QStandardPaths::findExecutable(QStringLiteral("bwrap"));
    auto control = connectedPair();
    auto lab = openStream();
    if (found.isEmpty() || !control || !lab)
        return server;
    std::vector<QByteArray> line =
        commandLine(QFile::encodeName(found), QFile::encodeName(program), language.toUtf8());
    std::vector<char *> arguments;
    for (QByteArray &part : line)
        arguments.push_back(part.data());
    arguments.push_back(nullptr);
    server.m_id = fork();
    if (server.m_id == 0) {
        setsid(); // what is typed at a terminal is for the parent
        keepOnly(control->second.number(), lab->first.number());
        guard(arguments);
    }
    server.m_endsByItself = true;
    server.m_control = std::move(control->first);
    server.m_lab = std::move(lab->second);
    return server;
}

ServerProcess ServerProcess::forked(const Lab &lab)
{
    ServerProcess server;
    auto control = connectedPair();
    if (!control)
        return server;
    server.m_id = fork();
    if (server.m_id == 0) {
        // Where the parent has ended before this, the other end of control is closed, and serving
        // ends.
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        setsid(); // what is typed at a terminal is for the parent
        std::signal(SIGINT, SIG_DFL);
        std::signal(SIGTERM, SIG_DFL);
        keepOnly(control->second.number(), -1);
        serveJudging(serverControl, lab);
        _exit(0);
    }
    server.m_control = std::move(control->first);
    return server;
}

ServerProcess::ServerProcess(ServerProcess &&other) noexcept
    : m_id(std::exchange(other.m_id, -1))
    , m_endsByItself(other.m_endsByItself)
    , m_control(std::move(other.m_control))
    , m_lab(std::move(other.m_lab))
{
}

ServerProcess &ServerProcess::operator=(ServerProcess &&other) noexcept
{
    std::swap(m_id, other.m_id);
    std::swap(m_endsByItself, other.m_endsByItself);
    std::swap(m_control, other.m_control);
    std::swap(m_lab, other.m_lab);
    return *this;
}

void ServerProcess::sendLab(const QByteArray &bytes)
{
    for (qsizetype at = 0; at < bytes.size() && isReady(m_id, m_lab.number(), POLLOUT);) {
        const ssize_t size =
            ::send(m_lab.number(), bytes.constData() + at,
                   static_cast<std::size_t>(bytes.size() - at), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (size < 0 && errno != EINTR && errno != EAGAIN)
            break; // its end says the rest
        at += std::max<ssize_t>(size, 0);
    }
    m_lab.close();
}

bool ServerProcess::hasSpoken() const
{
    return isReady(m_id, m_control.number(), POLLIN);
}

int ServerProcess::end()
{
    m_control.close();
    m_lab.close();
    int status = 0;
    if (m_id > 0) {
        if (!m_endsByItself)
            kill(m_id, SIGKILL);
        siginfo_t ended{};
        TEMP_FAILURE_RETRY(waitid(P_PID, static_cast<id_t>(m_id), &ended, WEXITED | WNOWAIT));
        kill(-m_id, SIGKILL); // until it is collected no other group has its number
        waitpid(m_id, &status, 0);
    }
    m_id = -1;
    return status;
}

} // namespace cradle
