// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

class QMainWindow;
class QWidget;

namespace cradle {

struct Panes;

/// The keyboard's ways through the window.
class FocusRounds final
{
public:
    FocusRounds(QMainWindow &window, const Panes &panes);

    /// Moves the keyboard's focus to the next pane that is seen. \param direction 1 or −1
    void focusNextPane(int direction);
    /// Moves it by Tab or Shift+Tab. \return whether it was at a control of the window
    bool focusNextControl(bool next);

private:
    [[nodiscard]] std::vector<QWidget *> paneRound() const;
    [[nodiscard]] std::vector<QWidget *> controlRound() const;

    QMainWindow &m_window;
    const Panes &m_panes;
};

} // namespace cradle
