// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"

#include <QLabel>
#include <QTimer>

namespace cradle {

/// Tells screen readers what happens where the focus is not: verdicts, and the hits of a run. Qt
/// before 6.8 knows no announcements, so this is an alert whose name is what there is to say; it
/// is shown, as only that is read, but nothing of it is seen.
class Announcer final : public QLabel
{
    Q_OBJECT
public:
    explicit Announcer(QWidget *window);

    /// Says the hits of \p simulation, which must outlive it: at once where the run stands at one,
    /// else at most one in a while, the newest.
    void follow(const Simulation &simulation);
    void setSaysHits(bool on) { m_saysHits = on; }
    [[nodiscard]] bool saysHits() const { return m_saysHits; }
    /// What was said last.
    [[nodiscard]] QString said() const { return accessibleName(); }

public slots:
    void say(const QString &text);

private:
    void sayHit();

    const Simulation *m_simulation = nullptr;
    qint64 m_step = 0; ///< up to which hits were said
    QString m_pending; ///< waits for its turn
    QTimer m_rest;     ///< after a hit of a run that goes on
    bool m_saysHits = true;
};

} // namespace cradle
