// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workbench.h"

#include <QTimer>

namespace cradle {

class NotesPane;
class VersionsPane;

/// Joins the panes of versions and notes to the workspace of the open step.
class KeepingDesk final : public QObject
{
    Q_OBJECT
public:
    /// \param versions, notes  live in the window
    KeepingDesk(Workbench &workbench, VersionsPane &versions, NotesPane &notes,
                QObject *parent = nullptr);
    ~KeepingDesk() override;

    void saveNote(); ///< now, if there is something to save
    void keepNote(); ///< the same, and a version of it

private:
    [[nodiscard]] bool mayReplace() const;
    void showVersions();
    void showPresent();
    void openNote();

    Workbench &m_workbench;
    VersionsPane &m_versions;
    NotesPane &m_notes;
    QString m_noteTask; ///< whose note is shown
    bool m_noteEdited = false;
    QTimer m_saveSoon;
    QTimer m_keepSoon; ///< a version of what was noted
};

} // namespace cradle
