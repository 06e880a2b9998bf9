// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/server_start.h"

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
std::vector<QByteArray> bubblewrapped(const QByteArray &bubblewrap, const QByteArray &program,
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
/// whole: here, or by collectServer() where this process was killed.
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

} // namespace

pid_t startBubblewrapped(const QString &program, const QString &language, int control, int lab)
{
    const QString found = QStandardPaths::findExecutable(QStringLiteral("bwrap"));
    if (found.isEmpty())
        return -1;
    std::vector<QByteArray> line =
        bubblewrapped(QFile::encodeName(found), QFile::encodeName(program), language.toUtf8());
    std::vector<char *> arguments;
    for (QByteArray &part : line)
        arguments.push_back(part.data());
    arguments.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0)
        return child;
    setsid(); // what is typed at a terminal is for the parent
    keepOnly(control, lab);
    guard(arguments);
}

pid_t startForked(const Lab &lab, int control)
{
    const pid_t child = fork();
    if (child != 0)
        return child;
    // Where the parent has ended before this, the other end of control is closed, and serving ends.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    setsid(); // what is typed at a terminal is for the parent
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    keepOnly(control, -1);
    serveJudging(serverControl, lab, false);
    _exit(0);
}

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

void sendToServer(pid_t server, int stream, const QByteArray &bytes)
{
    for (qsizetype at = 0; at < bytes.size() && isReady(server, stream, POLLOUT);) {
        const ssize_t size =
            ::send(stream, bytes.constData() + at, static_cast<std::size_t>(bytes.size() - at),
                   MSG_NOSIGNAL | MSG_DONTWAIT);
        if (size < 0 && errno != EINTR && errno != EAGAIN)
            return; // its end says the rest
        at += std::max<ssize_t>(size, 0);
    }
}

int collectServer(pid_t server)
{
    siginfo_t ended{};
    TEMP_FAILURE_RETRY(waitid(P_PID, static_cast<id_t>(server), &ended, WEXITED | WNOWAIT));
    kill(-server, SIGKILL); // until it is collected no other group has its number
    int status = 0;
    waitpid(server, &status, 0);
    return status;
}

} // namespace cradle
