// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"
#include "views/sound/tone.h"

#include <QObject>

#include <vector>

namespace cradle {

/// Makes the hits of a run heard, as they are shown: while it runs all that are new, and where it
/// stands at a hit that one. Silent unless it is turned on.
class HitSounds final : public QObject
{
    Q_OBJECT
public:
    /// \p simulation must outlive it.
    explicit HitSounds(const Simulation &simulation, QObject *parent = nullptr);

    void setOn(bool on) { m_on = on; }
    [[nodiscard]] bool isOn() const { return m_on; }

signals:
    /// A frame shows new hits; the loudest of their tones, loudest first.
    void struck(const std::vector<cradle::Tone> &tones);

private:
    void listen();

    const Simulation &m_simulation;
    qint64 m_step = 0; ///< up to which hits were heard
    bool m_on = false;
};

} // namespace cradle
