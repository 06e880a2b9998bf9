// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/sound/hit_sounds.h"

#include <QObject>

#include <vector>

namespace cradle {

class NoticeBar;
class SoundOutput;

/// What is heard of the window.
class Sounds final : public QObject
{
    Q_OBJECT
public:
    /// \param notice  says that there is no device
    Sounds(const Simulation &simulation, NoticeBar &notice);

    [[nodiscard]] HitSounds &hits() { return m_hits; }
    /// The device is asked for with the first sound; a machine without one is told of once.
    void play(std::vector<float> samples);

private:
    HitSounds m_hits;
    NoticeBar &m_notice;
    SoundOutput *m_output = nullptr; ///< once something sounded
};

} // namespace cradle
