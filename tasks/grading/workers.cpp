// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/workers.h"

#include "tasks/grading/student_result_json.h"
#include "tasks/grading/worker_server.h"

#include <QCoreApplication>
#include <QtEndian>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace cradle {

namespace {

struct WorkersText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

/// Above anything that a worker takes for a step, on however busy a machine: it was stopped.
constexpr double patience = 3600.0;
constexpr int mostStarts = 5; ///< of a server that is killed before it says anything

double now()
{
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

} // namespace

Result<std::unique_ptr<Workers>> Workers::start(const Lab &lab, const LabFiles &files,
                                                const QString &folder, const QString &language,
                                                const QString &program, ServerProcess begun)
{
    std::unique_ptr<Workers> workers(new Workers);
    if (!program.isEmpty()
        && workers->startInNamespaces(cradle::bytesOf(files, folder), language, program,
                                      std::move(begun)))
        return workers;
    for (int attempt = 0; attempt < mostStarts; ++attempt) {
        if (workers->connect(ServerProcess::forked(lab)))
            return workers;
    }
    return Error{.message = WorkersText::tr("no process to judge in can be started: %1")
                                .arg(QString::fromLocal8Bit(std::strerror(errno)))};
}

/// \return false where that is not to be had; a server that somebody killed is started anew
bool Workers::startInNamespaces(const QByteArray &lab, const QString &language,
                                const QString &program, ServerProcess begun)
{
    for (int attempt = 0; attempt < mostStarts; ++attempt) {
        ServerProcess server = std::exchange(begun, {});
        if (!server)
            server = ServerProcess::bubblewrapped(program, language);
        if (!server)
            return false;
        server.sendLab(lab);
        if (connect(std::move(server)))
            return true;
        // What is not allowed says so by itself.
        const int status = m_endOfServer;
        const bool killed = (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL)
                            || (WIFEXITED(status) && WEXITSTATUS(status) == 128 + SIGKILL);
        if (!killed)
            return false;
    }
    return false;
}

/// \return whether the server says that it is there
bool Workers::connect(ServerProcess server)
{
    if (!server)
        return false;
    const auto hello = server.hasSpoken() ? receiveMessage(server.control()) : std::nullopt;
    m_alive = hello && hello->message.kind == ServerMessage::Kind::Hello;
    if (!m_alive) {
        m_endOfServer = server.end();
        return false;
    }
    m_server = std::move(server);
    const int flags = hello->message.value;
    m_isolation = {
        .limits = (flags & 1) != 0, .seccomp = (flags & 2) != 0, .namespaces = (flags & 4) != 0};
    return true;
}

void Workers::stop()
{
    m_alive = false;
    m_server.end();
}

void Workers::judge(int worker, const JudgingRequest &request)
{
    Running &running = m_running[worker];
    running.seed = request.seed;
    running.expected = request.steps;
    running.since = now();
    auto pipe = openPipe();
    auto stream = openStream();
    const bool sent =
        pipe && stream && m_alive
        && sendMessage(m_server.control(), {.kind = ServerMessage::Kind::Judge, .worker = worker},
                       {stream->first.number(), pipe->second.number()});
    if (sent) {
        stream->first.close();
        sendAll(stream->second.number(), cradle::bytesOf(request));
    }
    if (pipe)
        running.results = std::move(pipe->first);
    // Else the server tells how it ended, or its end does.
    if (!pipe || !stream || !m_alive) {
        running.results.close();
        running.status = W_EXITCODE(0, SIGKILL);
    }
}

std::vector<WorkerEvent> Workers::wait(int milliseconds)
{
    std::vector<WorkerEvent> events;
    std::vector<pollfd> watched{pollfd{m_alive ? m_server.control() : -1, POLLIN, 0}};
    std::vector<int> numbers;
    for (auto &[worker, running] : m_running) {
        watched.push_back({running.results.number(), POLLIN, 0});
        numbers.push_back(worker);
        if (!running.results && running.status)
            milliseconds = 0;
    }
    if (poll(watched.data(), watched.size(), milliseconds) < 0)
        return events;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        Running &running = m_running[numbers[i]];
        if (watched[i + 1].revents)
            readResults(numbers[i], running, events);
        else if (m_alive && now() - running.since > patience)
            sendMessage(m_server.control(),
                        {.kind = ServerMessage::Kind::Kill, .worker = numbers[i]});
    }
    if (watched.front().revents)
        readControl(events);
    for (const int worker : numbers) {
        const auto running = m_running.find(worker);
        if (running->second.status && !running->second.results) {
            end(worker, running->second, events);
            m_running.erase(running);
        }
    }
    return events;
}

void Workers::readControl(std::vector<WorkerEvent> &events)
{
    const auto received = receiveMessage(m_server.control());
    if (!received) {
        stop();
        for (auto &[worker, running] : m_running) {
            running.results.close();
            running.status = running.status.value_or(W_EXITCODE(0, SIGKILL));
        }
        return;
    }
    const auto running = m_running.find(received->message.worker);
    if (received->message.kind != ServerMessage::Kind::Ended || running == m_running.end())
        return;
    running->second.status = received->message.value;
    // Its end of the pipe is closed: what is left can be read without waiting.
    while (running->second.results)
        readResults(running->first, running->second, events);
}

void Workers::readResults(int worker, Running &running, std::vector<WorkerEvent> &events)
{
    char part[64 * 1024];
    const ssize_t size = TEMP_FAILURE_RETRY(read(running.results.number(), part, sizeof part));
    if (size <= 0) {
        running.results.close();
        return;
    }
    running.since = now();
    running.received += size;
    running.unread.append(part, size);
    if (running.received > mostWorkerBytes)
        running.fault = WorkersText::tr("it has sent too much");
    if (running.fault.isEmpty())
        takeFrames(worker, running, events);
    if (!running.fault.isEmpty()) {
        running.results.close();
        sendMessage(m_server.control(), {.kind = ServerMessage::Kind::Kill, .worker = worker});
    }
}

void Workers::takeFrames(int worker, Running &running, std::vector<WorkerEvent> &events)
{
    constexpr auto head = static_cast<qsizetype>(sizeof(quint32));
    while (running.unread.size() >= head) {
        const auto size = qFromLittleEndian<quint32>(running.unread.constData());
        if (size > mostResultBytes) {
            running.fault = WorkersText::tr("it has sent too much");
            return;
        }
        const auto whole = head + static_cast<qsizetype>(size);
        if (running.unread.size() < whole)
            return;
        auto result = readStudentResult(running.unread.mid(head, size), {});
        running.unread.remove(0, whole);
        const bool fits = result && result->steps.size() == 1 && !running.expected.isEmpty()
                          && result->steps.front().taskId == running.expected.first();
        if (!fits) {
            running.fault = result ? WorkersText::tr("it has sent what it was not asked for")
                                   : result.error().toString();
            return;
        }
        running.expected.removeFirst();
        if (result->steps.front().report)
            result->steps.front().report->seed = running.seed;
        events.push_back({.worker = worker, .step = std::move(result->steps.front())});
    }
}

void Workers::end(int worker, Running &running, std::vector<WorkerEvent> &events)
{
    WorkerEvent event{.worker = worker};
    const int status = *running.status;
    if (!running.fault.isEmpty())
        event.fault = running.fault;
    else if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        event.fault =
            WorkersText::tr("judging took more than %1 s of processor time").arg(secondsPerStep);
    else if (WIFSIGNALED(status) && WTERMSIG(status) == SIGSYS)
        event.fault = WorkersText::tr("it tried what no judgement needs, and was stopped");
    else if (WIFSIGNALED(status))
        event.fault = WorkersText::tr("it was ended by signal %1").arg(WTERMSIG(status));
    else if (WEXITSTATUS(status) != 0 || !running.expected.isEmpty())
        event.fault = WorkersText::tr("it broke down");
    event.killed = running.fault.isEmpty() && WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
    event.done = event.fault.isEmpty();
    events.push_back(std::move(event));
}

} // namespace cradle
