// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sounds.h"

#include "app/notice_bar.h"
#include "views/sound/sound_output.h"

#include <utility>

namespace cradle {

Sounds::Sounds(const Simulation &simulation, NoticeBar &notice)
    : m_hits(simulation)
    , m_notice(notice)
{
    connect(&m_hits, &HitSounds::struck, this,
            [this](const std::vector<Tone> &tones) { play(samplesOf(tones)); });
}

void Sounds::play(std::vector<float> samples)
{
    if (!m_output) {
        m_output = new SoundOutput(this);
        connect(m_output, &SoundOutput::failed, this, [this] {
            m_notice.warn(tr("There is no sound here: no sound server (PulseAudio or PipeWire) "
                             "could be reached. Everything else goes on."));
        });
    }
    m_output->play(std::move(samples));
}

} // namespace cradle
