// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>

#include <optional>

namespace cradle {

/// Who writes in a workspace.
struct LockHolder {
    QString host;
    qint64 process = 0; ///< its number on that host
    QDateTime since{};  ///< UTC
    QString token{};    ///< tells this holding from every other

    friend bool operator==(const LockHolder &, const LockHolder &) = default;
};

/// The right to write in a workspace, of one window at a time: a file in its folder. A window that
/// was killed holds it no more. Another machine's is believed to be alive: only the user can know.
class WorkspaceLock
{
public:
    WorkspaceLock() = default;
    /// \param folder  of the workspace; it must be there
    explicit WorkspaceLock(const QString &folder);
    ~WorkspaceLock();
    WorkspaceLock(WorkspaceLock &&other) noexcept;
    WorkspaceLock &operator=(WorkspaceLock &&other) noexcept;

    /// Takes the right. \return who has it, if another does; a folder that cannot be written has
    /// no holder and is not taken either
    std::optional<LockHolder> take();
    /// Takes it from whoever has it; they find out before they write next.
    void takeOver();
    /// Whether it is still ours: another may have taken it over.
    [[nodiscard]] bool isHeld() const;
    /// Who had it when it was taken, and was killed: since when; invalid if nobody was.
    [[nodiscard]] const QDateTime &killedSince() const { return m_killedSince; }

private:
    void release();

    QString m_path;
    QString m_token; ///< empty: not taken
    QDateTime m_killedSince{};
};

/// The name of the lock's file.
inline constexpr char lockFileName[] = ".cradle-lock";

} // namespace cradle
