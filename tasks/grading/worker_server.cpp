// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/worker_server.h"

#include "tasks/grading/descriptors.h"
#include "tasks/grading/judging_request.h"
#include "tasks/grading/student_result_json.h"
#include "tasks/reading/lab_reader.h"

#include <QDataStream>
#include <QIODevice>
#include <QtEndian>

#include <array>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <map>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

namespace cradle {

namespace {

constexpr qint64 mostRequestBytes = 256 * 1024 * 1024;
/// Above what a worker ends a step by itself with.
constexpr qint64 spareSeconds = 10;
/// For fewer it is not worth while to measure beforehand.
constexpr int fewStudents = 4;
/// Steps that are measured between two students, some 50 ms each: all of a lab after five.
constexpr int stepsAtOnce = 4;

QByteArray contentOf(const StepResult &step, const Lab &lab, qint64 seed)
{
    StudentResult one{.id = QStringLiteral("worker"), .seed = seed};
    one.steps.push_back(step);
    return writeStudentResult(one, lab);
}

/// A length and so many bytes: one step, as a file of a student would hold it. Programs may lead to
/// scenes that are no file's to hold; a verdict does without them.
QByteArray frameOf(StepResult step, const Lab &lab, qint64 seed)
{
    QByteArray content = contentOf(step, lab, seed);
    if (!readStudentResult(content, {})) {
        step.moments.clear();
        if (step.report) {
            for (CheckOutcome &check : step.report->checks)
                check.scene.reset();
        }
        content = contentOf(step, lab, seed);
    }
    QByteArray frame(sizeof(quint32), Qt::Uninitialized);
    qToLittleEndian(static_cast<quint32>(content.size()), frame.data());
    return frame + content;
}

int flagsOf(const Isolation &isolation)
{
    return (isolation.limits ? 1 : 0) | (isolation.seccomp ? 2 : 0)
           | (isolation.namespaces ? 4 : 0);
}

/// What isolation a worker really gets, as flags, by one that does nothing else.
int probedIsolation(const Lockdown &lockdown, bool inNamespaces)
{
    const int here = flagsOf({.namespaces = inNamespaces});
    int status = 0;
    do { // somebody may kill that one, too
        const pid_t child = fork();
        if (child == 0)
            _exit(flagsOf(lockdown.enter(secondsPerStep)));
        if (child < 0 || waitpid(child, &status, 0) != child)
            return here;
    } while (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    return WIFEXITED(status) ? WEXITSTATUS(status) | here : here;
}

class Server
{
public:
    /// \param isolation  that workers get by \p lockdown, see probedIsolation()
    Server(int control, const Lab &lab, const Lockdown &lockdown, int isolation)
        : m_control(control)
        , m_lab(lab)
        , m_lockdown(lockdown)
        , m_isolation(isolation)
    {
        // Who unpacks an archive asks for the time zone: without a file, and everywhere the same.
        setenv("TZ", "UTC0", 1);
        tzset();
        sigset_t children;
        sigemptyset(&children);
        sigaddset(&children, SIGCHLD);
        sigprocmask(SIG_BLOCK, &children, nullptr);
        m_signals = Descriptor(signalfd(-1, &children, SFD_CLOEXEC | SFD_NONBLOCK));
    }

    void serve()
    {
        if (!sendMessage(m_control, {.kind = ServerMessage::Kind::Hello, .value = m_isolation}))
            return;
        for (;;) {
            std::array<pollfd, 2> watched{pollfd{m_control, POLLIN, 0},
                                          pollfd{m_signals.number(), POLLIN, 0}};
            if (poll(watched.data(), watched.size(), -1) < 0 && errno != EINTR)
                return;
            if (watched[1].revents && !tellEnded())
                return;
            if (watched[0].revents && !takeMessage())
                return;
        }
    }

private:
    bool takeMessage()
    {
        auto received = receiveMessage(m_control);
        if (!received)
            return false;
        const ServerMessage &message = received->message;
        if (message.kind == ServerMessage::Kind::Kill) {
            for (const auto &[pid, worker] : m_workers) {
                if (worker == message.worker)
                    kill(pid, SIGKILL);
            }
            return true;
        }
        if (message.kind != ServerMessage::Kind::Judge || received->descriptors.size() != 2)
            return false;
        const pid_t parent = getpid();
        const pid_t child = fork();
        if (child == 0)
            beWorker(parent, received->descriptors[0].number(), received->descriptors[1].number());
        if (child > 0)
            m_workers[child] = message.worker;
        else
            return sendMessage(
                m_control, {ServerMessage::Kind::Ended, message.worker, W_EXITCODE(0, SIGKILL)});
        if (++m_judged >= fewStudents)
            prepareSteps();
        return true;
    }

    /// Measures what judging a step needs that is the same for all students, so that those who are
    /// still to come find it done. A few steps at a time: the others wait for it.
    void prepareSteps()
    {
        for (int i = 0; i < stepsAtOnce && m_prepared < m_lab.tasks.size() && !m_lab.drawsValues;
             ++i)
            prepareJudging(m_lab.tasks[m_prepared++]);
    }

    /// Tells of all workers that have ended.
    bool tellEnded()
    {
        signalfd_siginfo ignored{};
        while (read(m_signals.number(), &ignored, sizeof ignored) > 0) {
        }
        int status = 0;
        for (pid_t pid = 0; (pid = waitpid(-1, &status, WNOHANG)) > 0;) {
            const auto worker = m_workers.find(pid);
            if (worker == m_workers.end())
                continue;
            const int number = worker->second;
            m_workers.erase(worker);
            if (!sendMessage(m_control, {ServerMessage::Kind::Ended, number, status}))
                return false;
        }
        return true;
    }

    [[noreturn]] void beWorker(pid_t parent, int request, int results)
    {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != parent) // It was gone before that.
            _exit(1);
        sigset_t none;
        sigemptyset(&none);
        sigprocmask(SIG_SETMASK, &none, nullptr);
        // The kernel takes it first where memory is short, not the process that grades.
        if (const int file = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC); file >= 0) {
            (void)!write(file, "1000", 4);
            close(file);
        }
        const auto asked = readAll(request, mostRequestBytes);
        const auto wanted = asked ? requestFrom(*asked) : std::nullopt;
        if (!wanted || dup2(results, Lockdown::outputDescriptor) < 0)
            _exit(1);
        close_range(Lockdown::outputDescriptor + 1, ~0U, 0);
        const auto steps = static_cast<qint64>(wanted->steps.size());
        (void)m_lockdown.enter((steps + 1) * (secondsPerStep + spareSeconds));
        int code = 0;
        try {
            judgeWork(
                m_lab, *wanted, [] { Lockdown::allowSeconds(secondsPerStep + spareSeconds); },
                [&](const StepResult &step) {
                    if (!writeAll(Lockdown::outputDescriptor, frameOf(step, m_lab, wanted->seed)))
                        _exit(1);
                });
        } catch (const std::exception &) {
            code = 1;
        }
        _exit(code);
    }

    int m_control;
    const Lab &m_lab;
    const Lockdown &m_lockdown;
    int m_isolation;
    Descriptor m_signals{};
    std::map<pid_t, int> m_workers{};
    int m_judged = 0;           ///< students whose judging has begun
    std::size_t m_prepared = 0; ///< steps
};

} // namespace

void serveJudging(int control, const Lab &lab)
{
    const Lockdown lockdown(mostWorkerMemory);
    Server(control, lab, lockdown, probedIsolation(lockdown, false)).serve();
}

QByteArray bytesOf(const LabFiles &files, const QString &folder)
{
    QByteArray bytes;
    QDataStream out(&bytes, QIODevice::WriteOnly);
    out.setVersion(QDataStream::Qt_6_4);
    out << folder << files.contents;
    return bytes;
}

int runJudgingServer(const QString &language)
{
    // Before the lab, which who asks for this process may still be reading.
    const Lockdown lockdown(mostWorkerMemory);
    const int isolation = probedIsolation(lockdown, true);
    const auto bytes = readAll(serverLab, 2 * limits::labBytes);
    if (!bytes)
        return 2;
    ::close(serverLab);
    QString folder;
    LabFiles files;
    QDataStream in(*bytes);
    in.setVersion(QDataStream::Qt_6_4);
    in >> folder >> files.contents;
    if (in.status() != QDataStream::Ok)
        return 2;
    const auto lab = readLab(files, folder, language);
    if (!lab)
        return 2;
    Server(serverControl, *lab, lockdown, isolation).serve();
    return 0;
}

} // namespace cradle
