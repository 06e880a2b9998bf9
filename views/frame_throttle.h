// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

namespace cradle {

/// Says when a view of a simulation is to be brought up to date: at most about 30 times a second
/// while it runs (60 while the student drags), always once more for the last state, and never while
/// the view is hidden.
class FrameThrottle final : public QObject
{
    Q_OBJECT
public:
    /// \param view  whose visibility counts; also the parent
    FrameThrottle(const Simulation &simulation, QWidget *view);

    void request(); ///< something changed; due() comes at once or soon
    /// Whether due() is still to come.
    [[nodiscard]] bool isHoldingBack() const { return m_dirty && m_view->isVisible(); }

signals:
    void due();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void fire();

    const Simulation &m_simulation;
    QWidget *m_view;
    QTimer m_timer;
    QElapsedTimer m_sinceLast;
    bool m_dirty = true;
};

} // namespace cradle
