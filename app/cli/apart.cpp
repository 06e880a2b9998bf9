// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/apart.h"

#include "app/cli/subcommand.h"

#include <csignal>
#include <cstdio>
#include <thread>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace cradle::cli {

namespace {

using namespace std::chrono_literals;

constexpr auto look = 1ms; ///< between two looks at the child; a verdict takes a hundred

[[noreturn]] void beChild(const std::function<int()> &work, pid_t parent)
{
    // It must not go on, and write, after who waits for it was killed.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
        _exit(Defect);
    int code = Defect;
    try {
        code = work();
    } catch (const std::exception &e) {
        std::fprintf(stderr, "cradle-cli: this is a defect of ours: %s\n", e.what());
    }
    std::fflush(nullptr);
    // What is to be cleaned up belongs to the parent.
    _exit(code);
}

} // namespace

std::variant<int, Killed, Crashed> runApart(const std::function<int()> &work,
                                            std::chrono::milliseconds most)
{
    std::fflush(nullptr);
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child < 0) // No process to be had: do it here.
        return work();
    if (child == 0)
        beChild(work, parent);
    const auto deadline = std::chrono::steady_clock::now() + most;
    int status = 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > deadline) {
            kill(child, SIGKILL);
            waitpid(child, &status, 0);
            return Killed{};
        }
        std::this_thread::sleep_for(look);
    }
    if (WIFSIGNALED(status))
        return Crashed{WTERMSIG(status)};
    return WEXITSTATUS(status);
}

} // namespace cradle::cli
