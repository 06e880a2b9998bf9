// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/simulation.h"

#include <QElapsedTimer>

#include <algorithm>

namespace cradle {

// The way to the next hit, and to the one before.

namespace {

/// How far seekNextHit() looks ahead, s of the scene.
constexpr double longestSearch = 60.0;
/// seekNextHit() answers at once for so many steps of single circles, then it works in parts.
constexpr double stepsAtOnce = 30'000.0;
/// A step of a program takes so many times as long.
constexpr double weightOfProgram = 20.0;
constexpr qint64 partOfSearch = 25; ///< ms

} // namespace

void Simulation::seekNextHit()
{
    pause();
    m_search = Search{m_current, time(), time() + longestSearch};
    const double weight =
        static_cast<double>(m_world.circles.size()) * (isProgrammed() ? weightOfProgram : 1.0);
    for (double work = 0.0; work < stepsAtOnce; work += weight) {
        if (!searchStep())
            return;
        if (m_unfinished) // it has worked for a frame
            break;
    }
    m_searchTimer.start();
    emit searchingChanged(true);
    emit frameReady();
}

/// A part of the search, not longer than a frame may work.
void Simulation::searchOn()
{
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < partOfSearch) {
        if (!searchStep())
            return;
    }
    emit frameReady();
}

/// \return whether the search goes on
bool Simulation::searchStep()
{
    advance(m_preset.timestep);
    if (!m_search) // who hears of a program's error may have ended it
        return false;
    const bool found = !m_unfinished && showsHit();
    if (!found && time() < m_search->end && !m_error)
        return true;
    const qint64 begin = m_search->begin;
    if (found)
        endSearch();
    else
        endSearchAt(begin);
    if (!found)
        emit noHitFound();
    emit frameReady();
    return false;
}

double Simulation::searchedShare() const
{
    if (!m_search)
        return 0.0;
    const double share = (time() - m_search->beginTime) / (m_search->end - m_search->beginTime);
    return std::clamp(share, 0.0, 1.0);
}

void Simulation::endSearch()
{
    m_search.reset();
    if (!m_searchTimer.isActive())
        return;
    m_searchTimer.stop();
    emit searchingChanged(false);
}

/// Shows the moment \p index again, or the first if it is no longer kept.
void Simulation::endSearchAt(qint64 index)
{
    m_current = std::max(index, m_recording.first());
    endSearch();
}

void Simulation::seekPreviousHit()
{
    const auto &hits = m_recording.encounters();
    const qint64 step = m_recording.step(m_current);
    const auto here = std::partition_point(
        hits.begin(), hits.end(), [step](const Encounter &hit) { return hit.step < step; });
    if (here == hits.begin())
        seek(m_recording.first());
    else
        seek(m_current - (step - std::prev(here)->step));
}

bool Simulation::isNearHit() const
{
    const auto &hits = m_recording.encounters();
    const auto timeOf = [this](const Encounter &hit) { return m_recording.hitOf(hit).time; };
    const auto near = std::partition_point(hits.begin(), hits.end(), [&](const Encounter &hit) {
        return timeOf(hit) < time() - slowReach;
    });
    return near != hits.end() && timeOf(*near) <= time() + slowReach;
}

bool Simulation::showsHit() const
{
    const auto &hits = m_recording.encounters();
    const qint64 step = m_recording.step(m_current);
    const auto here = std::partition_point(
        hits.begin(), hits.end(), [step](const Encounter &hit) { return hit.step < step; });
    return here != hits.end() && here->step == step;
}

} // namespace cradle
