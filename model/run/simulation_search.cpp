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
/// seekNextHit() answers at once for so many steps of single circles, then on another thread.
constexpr double stepsAtOnce = 30'000.0;
/// A step of a program takes so many times as long.
constexpr double weightOfProgram = 20.0;
/// So much of a program is done at once, about 20 ms.
constexpr qint64 instructionsAtOnce = 1'000'000;
constexpr qint64 partOfFrame = 25; ///< ms, for what the other thread has made

/// The contacts that may go on after the newest step.
EncounterLog latestContacts(const Recording &run)
{
    EncounterLog contacts;
    const qint64 since = run.step(run.last()) - EncounterLog::restingSteps;
    for (const Hit &hit : run.hits()) {
        if (hit.step >= since)
            contacts.add({&hit, 1}, run.circles(run.last()), 0);
    }
    return contacts;
}

} // namespace

void Simulation::seekNextHit()
{
    pause();
    m_search = Search{m_current, time(), time() + longestSearch};
    const double weight = static_cast<double>(m_run.world().circles.size())
                          * (isProgrammed() ? weightOfProgram : 1.0);
    const qint64 mostInstructions = m_run.instructions() + instructionsAtOnce;
    // What is recorded is no work.
    for (double work = 0.0; m_current < m_recording.last()
                            || (work < stepsAtOnce && m_run.instructions() < mostInstructions);
         work += weight) {
        if (!searchStep())
            return;
        if (m_run.isUnfinished()) // it has worked for a frame
            break;
    }
    m_run.setRecording(nullptr);
    m_ahead.start(m_run, m_program, latestContacts(m_recording), m_search->end);
    m_searchTimer.start();
    emit searchingChanged(true);
    emit frameReady();
}

/// What the other thread has made, as far as a frame allows.
void Simulation::searchOn()
{
    QElapsedTimer timer;
    timer.start();
    const bool isDone = m_ahead.isDone();
    bool isEmpty = false;
    while (!isEmpty && timer.elapsed() < partOfFrame) {
        const std::optional<RunAhead::Step> step = m_ahead.take();
        isEmpty = !step;
        if (step)
            takeAhead(*step);
    }
    if (!isDone || !isEmpty) {
        emit frameReady();
        return;
    }
    stopAhead();
    if (m_run.error())
        appendStep(m_preset.timestep); // which tells
    if (m_search)                      // who hears of a program's error may have ended it
        endSearchUnless(showsHit());
}

void Simulation::takeAhead(const RunAhead::Step &step)
{
    m_recording.append(step.world, step.hits);
    if (isProgrammed())
        m_notes.add(step.world.step, step.world.time, step.output);
    m_mergedFrom = step.mergedFrom;
    if (m_shadow)
        m_shadow->follow(m_recording);
    m_current = m_recording.last();
}

/// The run is at the end of the recording again.
void Simulation::stopAhead()
{
    m_ahead.stop();
    while (const std::optional<RunAhead::Step> step = m_ahead.take())
        takeAhead(*step);
    m_run.setRecording(&m_recording);
}

/// A step that is done at once. \return whether the search goes on
bool Simulation::searchStep()
{
    advance(m_preset.timestep);
    if (!m_search) // who hears of a program's error may have ended it
        return false;
    const bool found = !m_run.isUnfinished() && showsHit();
    if (!found && time() < m_search->end && !m_error)
        return true;
    endSearchUnless(found);
    return false;
}

/// Where nothing was found it is as if nobody had looked.
void Simulation::endSearchUnless(bool found)
{
    if (found)
        endSearch();
    else
        endSearchAt(m_search->begin);
    if (!found)
        emit noHitFound();
    emit frameReady();
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
    stopAhead();
    m_search.reset();
    if (!m_searchTimer.isActive())
        return;
    m_searchTimer.stop();
    emit searchingChanged(false);
}

/// Shows the moment \p index again, or the first if it is no longer kept.
void Simulation::endSearchAt(qint64 index)
{
    stopAhead();
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
