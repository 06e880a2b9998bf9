// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/lockdown.h"

#include <QCoreApplication>
#include <QStringList>

#include <array>
#include <cerrno>
#include <cstdio>
#include <ctime>

#include <fcntl.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace cradle {

namespace {

struct LockdownText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

// A sanitizer's shadow takes terabytes of addresses, it looks through a pipe whether memory is
// there, and calls what judging does not.
#if defined(CRADLE_SANITIZED)
constexpr bool isSanitized = true;
#else
constexpr bool isSanitized = false;
#endif

/// What computing, allocating, throwing and ending need; what these ask of is not told by names.
constexpr std::array plainCalls{SCMP_SYS(brk),
                                SCMP_SYS(munmap),
                                SCMP_SYS(mremap),
                                SCMP_SYS(madvise),
                                SCMP_SYS(futex),
                                SCMP_SYS(clock_gettime),
                                SCMP_SYS(gettimeofday),
                                SCMP_SYS(time),
                                SCMP_SYS(rt_sigreturn),
                                SCMP_SYS(rt_sigprocmask),
                                SCMP_SYS(sched_yield),
                                SCMP_SYS(getrandom),
                                SCMP_SYS(exit),
                                SCMP_SYS(exit_group),
                                SCMP_SYS(restart_syscall),
                                SCMP_SYS(getpid),
                                SCMP_SYS(gettid),
                                SCMP_SYS(getrusage)};

bool setLimit(__rlimit_resource what, rlim_t soft, rlim_t hard)
{
    const rlimit limit{soft, hard};
    return setrlimit(what, &limit) == 0;
}

/// The addresses that this process has mapped, in bytes; 0 if the system does not say.
qint64 mappedBytes()
{
    const int file = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return 0;
    std::array<char, 64> text{};
    const auto size = ::read(file, text.data(), text.size() - 1);
    ::close(file);
    long long pages = 0;
    return size > 0 && std::sscanf(text.data(), "%lld", &pages) == 1 ? pages * sysconf(_SC_PAGESIZE)
                                                                     : 0;
}

/// The macros of the library are C, which not every compiler of C++ takes.
constexpr scmp_arg_cmp equals(unsigned argument, scmp_datum_t value)
{
    return {argument, SCMP_CMP_EQ, value, 0};
}
constexpr scmp_arg_cmp masked(unsigned argument, scmp_datum_t mask, scmp_datum_t value)
{
    return {argument, SCMP_CMP_MASKED_EQ, mask, value};
}

bool addRules(scmp_filter_ctx filter)
{
    bool right = true;
    const auto allow = [&](int call, std::initializer_list<scmp_arg_cmp> when = {}) {
        right = seccomp_rule_add_array(filter, SCMP_ACT_ALLOW, call,
                                       static_cast<unsigned>(when.size()), when.begin())
                    == 0
                && right;
    };
    for (const int call : plainCalls)
        allow(call);
    allow(SCMP_SYS(write), {equals(0, Lockdown::outputDescriptor)});
    // Memory, but none that could hold code, and none of a file.
    constexpr scmp_datum_t noFile = MAP_ANONYMOUS;
    allow(SCMP_SYS(mmap), {masked(2, PROT_EXEC, 0), masked(3, noFile, noFile)});
    allow(SCMP_SYS(mprotect), {masked(2, PROT_EXEC, 0)});
    // Regular expressions would like to become code; refused that, they do without.
    const scmp_arg_cmp code = masked(2, PROT_EXEC, PROT_EXEC);
    right = seccomp_rule_add_array(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(mmap), 1, &code) == 0
            && right;
    // Its own share of processor time, below what it may take at all.
    allow(SCMP_SYS(prlimit64), {equals(0, 0), equals(1, RLIMIT_CPU)});
    return right;
}

} // namespace

struct Lockdown::Filter {
    Filter()
        : context(seccomp_init(SCMP_ACT_KILL_PROCESS))
    {
    }
    ~Filter()
    {
        if (context)
            seccomp_release(context);
    }
    Filter(const Filter &) = delete;
    Filter &operator=(const Filter &) = delete;

    scmp_filter_ctx context;
};

QString isolationText(const Isolation &isolation)
{
    QStringList there;
    QStringList lacking;
    (isolation.limits ? there : lacking).append(QStringLiteral("rlimits"));
    (isolation.seccomp ? there : lacking).append(QStringLiteral("seccomp"));
    (isolation.namespaces ? there : lacking).append(QStringLiteral("namespaces"));
    const QString comma = QStringLiteral(", ");
    if (lacking.isEmpty())
        return there.join(comma);
    const QString without = LockdownText::tr("no %1").arg(lacking.join(comma));
    return there.isEmpty() ? without : there.join(comma) + QStringLiteral("; ") + without;
}

double processorSeconds()
{
    timespec taken{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &taken);
    return static_cast<double>(taken.tv_sec) + static_cast<double>(taken.tv_nsec) * 1e-9;
}

Lockdown::Lockdown(qint64 moreBytes)
    : m_moreBytes(moreBytes)
    , m_filter(std::make_unique<Filter>())
{
    if (isSanitized || !m_filter->context || !addRules(m_filter->context))
        m_filter.reset();
}

Lockdown::~Lockdown() = default;

Isolation Lockdown::enter(qint64 seconds) const
{
    Isolation isolation;
    const qint64 mapped = mappedBytes();
    bool limited =
        setLimit(RLIMIT_CORE, 0, 0) && setLimit(RLIMIT_FSIZE, 0, 0) && setLimit(RLIMIT_NPROC, 0, 0);
    if (!isSanitized) {
        const auto most = static_cast<rlim_t>(mapped + m_moreBytes);
        limited = mapped > 0 && setLimit(RLIMIT_AS, most, most) && setLimit(RLIMIT_NOFILE, 0, 0)
                  && limited;
    }
    const auto time = static_cast<rlim_t>(processorSeconds() + 1.0) + static_cast<rlim_t>(seconds);
    isolation.limits = setLimit(RLIMIT_CPU, time, time + 1) && limited;
    isolation.seccomp = prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && m_filter
                        && seccomp_load(m_filter->context) == 0;
    return isolation;
}

void Lockdown::allowSeconds(qint64 seconds)
{
    rlimit limit{};
    if (getrlimit(RLIMIT_CPU, &limit) != 0)
        return;
    limit.rlim_cur = std::min(limit.rlim_max, static_cast<rlim_t>(processorSeconds() + 1.0)
                                                  + static_cast<rlim_t>(seconds));
    setrlimit(RLIMIT_CPU, &limit);
}

} // namespace cradle
