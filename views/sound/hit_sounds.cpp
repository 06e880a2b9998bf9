// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sound/hit_sounds.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace cradle {

namespace {

/// More tones in one frame would be noise.
constexpr std::size_t mostTones = 6;

} // namespace

HitSounds::HitSounds(const Simulation &simulation, QObject *parent)
    : QObject(parent)
    , m_simulation(simulation)
{
    connect(&simulation, &Simulation::frameReady, this, &HitSounds::listen);
}

/// A contact that lasts is one hit, as it is everywhere else.
void HitSounds::listen()
{
    const Recording &recording = m_simulation.recording();
    const qint64 step = recording.step(m_simulation.current());
    const qint64 before = m_simulation.isRunning() && m_step < step ? m_step : step - 1;
    const bool moved = std::exchange(m_step, step) != step;
    if (!m_on || !moved)
        return;
    const auto &contacts = recording.encounters();
    const auto after =
        std::partition_point(contacts.begin(), contacts.end(),
                             [step](const Encounter &each) { return each.step <= step; });
    std::vector<Tone> tones;
    World world;
    for (auto each = after; each != contacts.begin() && std::prev(each)->step > before; --each) {
        const Hit &hit = recording.hitOf(*std::prev(each));
        if (world.circles.empty())
            world = recording.world(m_simulation.current());
        const auto add = [&](int circle) {
            tones.push_back(
                toneOf(mass(world.circles[static_cast<std::size_t>(circle)]), hit.impulse));
        };
        add(hit.a);
        if (hit.kind == Hit::Kind::Circle)
            add(hit.b);
    }
    if (tones.empty())
        return;
    std::stable_sort(tones.begin(), tones.end(),
                     [](const Tone &a, const Tone &b) { return a.amplitude > b.amplitude; });
    tones.resize(std::min(tones.size(), mostTones));
    emit struck(tones);
}

} // namespace cradle
