// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/mode.h"

#include <QSize>

QT_BEGIN_NAMESPACE
class QMainWindow;
QT_END_NAMESPACE

namespace cradle {

struct Panes;

/// Where the panes stand at first: each mode has its own, made to the size of the window.
class RoomPlan final
{
public:
    RoomPlan(QMainWindow &window, const Panes &panes);

    /// Puts every pane where \p mode has it.
    void put(Mode mode);
    /// Fits the parts to the window, which may have another size now.
    void fit();

private:
    enum class Height { Low, Middling, High };
    [[nodiscard]] Height height() const; ///< of the window, as its texts are large
    [[nodiscard]] QSize body() const;    ///< px between the bars
    void putCode();
    void putExplore();
    void share();
    void shareCode(QSize room, int task);
    void shareExplore(QSize room, int task);

    QMainWindow &m_window;
    const Panes &m_panes;
    Mode m_mode = Mode::Explore;
    Height m_height = Height::High; ///< that it was put for
};

} // namespace cradle
