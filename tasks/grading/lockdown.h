// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <memory>

namespace cradle {

/// What keeps a process that runs a student's program from anything but judging it.
struct Isolation {
    bool limits = false;     ///< rlimits: processor time, memory, no files, no processes
    bool seccomp = false;    ///< the kernel kills it for a system call that judging does not need
    bool namespaces = false; ///< bubblewrap: no network, no files of others, no other processes

    [[nodiscard]] bool isWhole() const { return limits && seccomp && namespaces; }
    friend bool operator==(const Isolation &, const Isolation &) = default;
};

/// "rlimits, seccomp; no namespaces".
[[nodiscard]] QString isolationText(const Isolation &isolation);

/// The processor time that this process has taken, s.
[[nodiscard]] double processorSeconds();

/// The way of a process into its cell. Made before it is needed, and by the process that forks, so
/// that going there takes no time; a fork inherits it.
class Lockdown
{
public:
    /// The descriptor that a process in the cell may write to, and the only one that it has.
    static constexpr int outputDescriptor = 3;

    /// \param moreBytes  of memory that a process may take beyond what it has when it enters
    explicit Lockdown(qint64 moreBytes);
    ~Lockdown();
    Lockdown(const Lockdown &) = delete;
    Lockdown &operator=(const Lockdown &) = delete;

    /// Gives up everything, for good: from here on this process can compute, write to
    /// outputDescriptor and end. Any other system call kills it by SIGSYS.
    /// \param seconds  of processor time that it may take at all
    /// \return what of it this machine could do
    [[nodiscard]] Isolation enter(qint64 seconds) const;

    /// Within a cell: after \p seconds more of processor time the kernel ends this process by
    /// SIGXCPU.
    static void allowSeconds(qint64 seconds);

private:
    struct Filter;
    qint64 m_moreBytes;
    std::unique_ptr<Filter> m_filter; ///< null where there is no seccomp
};

} // namespace cradle
