// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

QT_BEGIN_NAMESPACE
class QMainWindow;
QT_END_NAMESPACE

namespace cradle {

class MarkdownView;
class Room;
class Workbench;
struct Panes;

/// Answers what is asked about the window.
class HelpDesk final : public QObject
{
    Q_OBJECT
public:
    HelpDesk(Workbench &workbench, Panes &panes, Room &room, QMainWindow &window);

public slots:
    void showTour();        ///< of the window
    void showCSharpSheet(); ///< what is different in Lua
    void showShortcuts();
    void showAbout();

private:
    Workbench &m_workbench;
    Panes &m_panes;
    Room &m_room;
    QMainWindow &m_window;
    QPointer<MarkdownView> m_sheet;
};

} // namespace cradle
