// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/room_plan.h"

#include <QObject>

#include <optional>
#include <vector>

QT_BEGIN_NAMESPACE
class QDockWidget;
class QSettings;
QT_END_NAMESPACE

namespace cradle {

/// What the student makes of the arrangement of panes, which is kept for each mode.
class Room final : public QObject
{
    Q_OBJECT
public:
    /// Nothing that happens to panes is the student's doing before open().
    Room(QMainWindow &window, Panes &panes, QSettings &settings, Mode mode);

    /// Shows what was kept of the mode, in a window that has its size.
    void open();
    /// What was arranged for a mode comes back with it.
    void showMode(Mode mode);
    void keep();
    /// Puts the panes anew after what changes their sizes, unless the student has arranged them.
    void refit();
    [[nodiscard]] bool isUnlocked() const { return m_unlocked; }
    [[nodiscard]] bool isSceneAlone() const { return m_beforeAlone.has_value(); }

public slots:
    void unlockPanes(bool unlocked); ///< gives the panes title bars to move them by
    void resetLayout();
    /// Without panes, as for a projector. They come back as they were; meanwhile nothing of this
    /// is kept as an arrangement.
    void showSceneAlone(bool alone);

signals:
    void sceneAloneChanged();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    [[nodiscard]] QString key() const;
    void watch(QDockWidget *pane);
    void put();

    QMainWindow &m_window;
    Panes &m_panes;
    QSettings &m_settings;
    RoomPlan m_plan;
    Mode m_mode;               ///< whose arrangement is shown
    bool m_unlocked = false;   ///< panes can be moved
    bool m_keepsSizes = false; ///< the student has moved a border or a pane
    bool m_arranging = true;   ///< what happens to panes is not the student's doing
    std::optional<std::vector<QDockWidget *>> m_beforeAlone; ///< the panes that were seen
};

} // namespace cradle
