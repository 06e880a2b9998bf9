// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QSettings;

namespace cradle {

class Room;
class Workbench;
struct Panes;

/// Joins the instructions of the open step to what the student works on.
class StepDesk final : public QObject
{
    Q_OBJECT
public:
    /// \param settings  keeps the mode
    StepDesk(Workbench &workbench, Panes &panes, Room &room, QSettings &settings);

public slots:
    void chooseMode(int index); ///< 0 Explore, 1 Code
    void focusCode();           ///< in Code mode, the editor

private:
    void wireTaskPane();
    void showTask();
    void showInstructions();
    void showProgress();
    void showLooseScene();
    void showMode();
    void showRoom();
    void showGuess();

    Workbench &m_workbench;
    Panes &m_panes;
    Room &m_room;
    QSettings &m_settings;
};

} // namespace cradle
