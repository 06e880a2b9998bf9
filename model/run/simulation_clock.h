// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace cradle {

/// Turns wall time into equal steps; knows nothing of circles.
class SimulationClock final : public QObject
{
    Q_OBJECT
public:
    explicit SimulationClock(double stepSeconds, QObject *parent = nullptr);

    [[nodiscard]] bool isRunning() const { return m_timer.isActive(); }
    [[nodiscard]] double speed() const { return m_speed; }

    /// \param stepSeconds  length of a step, s, > 0
    void setStep(double stepSeconds);
    /// \param speed  simulated seconds per second of wall time, > 0
    void setSpeed(double speed);
    /// Instead of equal steps one step a frame, as long as the frame took.
    void setFrameTime(bool on);
    /// Lets \p wallSeconds pass, as the timer does at every frame; for tests without waiting.
    void tick(double wallSeconds);

public slots:
    void start();
    void pause();

signals:
    void stepDue(double dt); ///< advance the world by dt s
    void frameReady();       ///< all due steps are done: repaint once

private:
    void onTimeout();

    QTimer m_timer;
    QElapsedTimer m_wall;
    double m_step;
    double m_speed = 1.0;
    double m_backlog = 0.0; ///< s not yet simulated; capped after a stall
    bool m_frameTime = false;
};

} // namespace cradle
