// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/lockdown.h"

#include <QTest>

#include <csignal>
#include <cstdlib>
#include <functional>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace cradle;

/// What a process that runs a student's program can still do, by processes that try.
class TestLockdown : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void anythingElseKills_data();
    void anythingElseKills();
    void computingGoesOn();
    void memoryEnds();
    void processorTimeEnds_data();
    void processorTimeEnds();
    void lackingIsolationIsNamed();
};

namespace {

constexpr int done = 42;
constexpr qint64 moreBytes = 64 * 1024 * 1024;

/// How a process ends that goes into its cell and then does \p work.
int statusOf(const std::function<int()> &work, qint64 seconds = 5)
{
    const Lockdown lockdown(moreBytes);
    const pid_t child = fork();
    if (child == 0) {
        // Somewhere to write to, where there is room for it.
        dup2(open("/dev/null", O_WRONLY), Lockdown::outputDescriptor);
        (void)lockdown.enter(seconds);
        _exit(work());
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

Isolation isolationHere()
{
    const Lockdown lockdown(moreBytes);
    const pid_t child = fork();
    if (child == 0) {
        const Isolation isolation = lockdown.enter(5);
        _exit((isolation.limits ? 1 : 0) | (isolation.seccomp ? 2 : 0));
    }
    int status = 0;
    waitpid(child, &status, 0);
    const int flags = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    return {.limits = (flags & 1) != 0, .seccomp = (flags & 2) != 0};
}

} // namespace

void TestLockdown::initTestCase()
{
    const Isolation here = isolationHere();
    QVERIFY(here.limits);
    if (!here.seccomp)
        QSKIP("this kernel has no seccomp, or a sanitizer is at work");
}

void TestLockdown::anythingElseKills_data()
{
    QTest::addColumn<std::function<int()>>("work");
    const auto row = [](const char *name, std::function<int()> work) {
        QTest::newRow(name) << std::move(work);
    };
    row("open", [] { return int(syscall(SYS_openat, AT_FDCWD, "/etc/passwd", O_RDONLY)); });
    row("create", [] {
        return int(syscall(SYS_openat, AT_FDCWD, "/tmp/cradle-escaped", O_CREAT | O_WRONLY, 0600));
    });
    row("socket", [] { return int(syscall(SYS_socket, AF_INET, SOCK_STREAM, 0)); });
    row("connected pair",
        [] { return int(syscall(SYS_socketpair, AF_UNIX, SOCK_STREAM, 0, nullptr)); });
    row("exec", [] {
        char *const arguments[] = {nullptr};
        return int(syscall(SYS_execve, "/bin/true", arguments, arguments));
    });
    row("clone", [] { return int(syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0)); });
    row("signal to the parent", [] { return int(syscall(SYS_kill, getppid(), SIGTERM)); });
    row("trace", [] { return int(syscall(SYS_ptrace, PTRACE_TRACEME, 0, 0, 0)); });
    row("sleep", [] {
        const timespec while_{1, 0};
        return int(syscall(SYS_clock_nanosleep, CLOCK_MONOTONIC, 0, &while_, nullptr));
    });
    row("write elsewhere", [] { return int(syscall(SYS_write, STDERR_FILENO, "x", 1)); });
    row("read", [] {
        char letter = 0;
        return int(syscall(SYS_read, STDIN_FILENO, &letter, 1));
    });
    row("remove", [] { return int(syscall(SYS_unlinkat, AT_FDCWD, "/tmp/nothing", 0)); });
    row("executable memory, later", [] {
        void *page =
            mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        return mprotect(page, 4096, PROT_READ | PROT_EXEC);
    });
    row("more memory for itself",
        [] { return int(syscall(SYS_prlimit64, 0, RLIMIT_AS, nullptr, nullptr)); });
}

void TestLockdown::anythingElseKills()
{
    QFETCH(std::function<int()>, work);
    const int status = statusOf(work);
    QVERIFY(WIFSIGNALED(status));
    QCOMPARE(WTERMSIG(status), SIGSYS);
}

/// Memory, exceptions and the one output; code in memory is refused without a kill, since regular
/// expressions ask for it.
void TestLockdown::computingGoesOn()
{
    const int status = statusOf([] {
        int caught = 0;
        for (int i = 0; i < 100; ++i) {
            try {
                const std::vector<int> numbers(100'000, i);
                throw numbers.back();
            } catch (int number) {
                caught += number == i ? 1 : 0;
            }
        }
        void *code = mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC,
                          MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        const bool refused = code == MAP_FAILED;
        const bool wrote = write(Lockdown::outputDescriptor, "x", 1) == 1;
        Lockdown::allowSeconds(3);
        return caught == 100 && refused && wrote ? done : 1;
    });
    QVERIFY(WIFEXITED(status));
    QCOMPARE(WEXITSTATUS(status), done);
}

void TestLockdown::memoryEnds()
{
#if defined(CRADLE_SANITIZED)
    QSKIP("a sanitizer needs all addresses");
#endif
    const int status = statusOf([] {
        void *some = mmap(nullptr, moreBytes / 2, PROT_READ | PROT_WRITE,
                          MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        void *more =
            mmap(nullptr, moreBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        return some != MAP_FAILED && more == MAP_FAILED ? done : 1;
    });
    QVERIFY(WIFEXITED(status));
    QCOMPARE(WEXITSTATUS(status), done);
}

void TestLockdown::processorTimeEnds_data()
{
    QTest::addColumn<qint64>("entered");
    QTest::addColumn<qint64>("allowed"); // later; -1: nothing is said then
    QTest::newRow("from the start") << qint64(1) << qint64(-1);
    QTest::newRow("from later on") << qint64(60) << qint64(0);
}

void TestLockdown::processorTimeEnds()
{
    QFETCH(qint64, entered);
    QFETCH(qint64, allowed);
    const int status = statusOf(
        [allowed] {
            if (allowed >= 0)
                Lockdown::allowSeconds(allowed);
            const double begin = processorSeconds();
            while (processorSeconds() < begin + 6.0) {
            }
            return 1;
        },
        entered);
    QVERIFY(WIFSIGNALED(status));
    QCOMPARE(WTERMSIG(status), SIGXCPU);
}

void TestLockdown::lackingIsolationIsNamed()
{
    QCOMPARE(isolationText({.limits = true, .seccomp = true, .namespaces = true}),
             QStringLiteral("rlimits, seccomp, namespaces"));
    QCOMPARE(isolationText({.limits = true, .seccomp = true}),
             QStringLiteral("rlimits, seccomp; no namespaces"));
    QCOMPARE(isolationText({}), QStringLiteral("no rlimits, seccomp, namespaces"));
}

QTEST_GUILESS_MAIN(TestLockdown)
#include "test_lockdown.moc"
