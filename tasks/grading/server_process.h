// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/descriptors.h"
#include "tasks/lab/lab.h"

#include <sys/types.h>

namespace cradle {

/// A process that forks workers, see serveJudging(), and the lines to it. Of the files that are
/// open here it has only its own ends of these. It dies with this process, or with this object.
class ServerProcess
{
public:
    /// None.
    ServerProcess() = default;

    /// By bubblewrap, as the program \p program with the arguments judge-server and \p language;
    /// the lab's files are to be sent to it. None where bubblewrap is not to be had.
    static ServerProcess bubblewrapped(const QString &program, const QString &language);

    /// As a fork of this process, which has the lab. None where the system forks no more.
    static ServerProcess forked(const Lab &lab);

    ServerProcess(ServerProcess &&other) noexcept;
    ServerProcess &operator=(ServerProcess &&other) noexcept;
    ~ServerProcess() { end(); }

    explicit operator bool() const { return m_id > 0; }
    /// The line on which it is asked, and answers.
    [[nodiscard]] int control() const { return m_control.number(); }

    /// Writes \p bytes to where it reads the lab, and closes that, unless it ends before.
    void sendLab(const QByteArray &bytes);

    /// Waits until it says something. \return false if it has ended instead
    [[nodiscard]] bool hasSpoken() const;

    /// Closes the lines, waits for its end, and ends what it left behind.
    /// \return how it ended, as wait() tells it; 0 if there is none
    int end();

private:
    pid_t m_id = -1;             ///< of bubblewrapped(), one that watches bubblewrap
    bool m_endsByItself = false; ///< as the other end of its line is closed
    Descriptor m_control{};
    Descriptor m_lab{};
};

} // namespace cradle
