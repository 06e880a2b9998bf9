// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/encounter_log.h"

#include <algorithm>

namespace cradle {

namespace {

/// The same for the same two, whichever is named first.
quint64 keyOf(const Hit &hit)
{
    const bool isWall = hit.kind == Hit::Kind::Wall;
    const auto a = static_cast<quint64>(isWall ? hit.a : std::min(hit.a, hit.b));
    const auto b = static_cast<quint64>(isWall ? hit.b : std::max(hit.a, hit.b));
    return a << 33 | b << 1 | (isWall ? 1U : 0U);
}

} // namespace

bool EncounterLog::goesOn(const Encounter &contact, const Hit &hit,
                          std::span<const Circle> circles) const
{
    const double closing = dot(hit.beforeA - hit.beforeB, hit.normal);
    return hit.step - contact.endStep <= restingSteps
           && closing * (hit.time - contact.endTime)
                  <= circles[static_cast<std::size_t>(hit.a)].radius;
}

void EncounterLog::add(std::span<const Hit> hits, std::span<const Circle> circles, qint64 first)
{
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const Hit &hit = hits[i];
        const auto [latest, isNew] = m_latest.try_emplace(keyOf(hit), end());
        if (!isNew && latest->second >= m_dropped) {
            Encounter &before = m_encounters[static_cast<std::size_t>(latest->second - m_dropped)];
            if (goesOn(before, hit, circles)) {
                const bool lasted = before.lasts();
                before.endStep = hit.step;
                before.endTime = hit.time;
                if (!lasted && before.lasts())
                    m_lasting.push_back(latest->second);
                continue;
            }
        }
        latest->second = end();
        m_encounters.push_back(
            {hit.time, hit.step, hit.time, hit.step, first + static_cast<qint64>(i)});
    }
    if (m_latest.size() > m_tidyAt && !hits.empty())
        forgetOld(hits.back().step);
}

/// Of a crowd there would be more and more pairs that have met.
void EncounterLog::forgetOld(qint64 step)
{
    std::erase_if(m_latest, [&](const auto &entry) {
        return entry.second < m_dropped
               || m_encounters[static_cast<std::size_t>(entry.second - m_dropped)].endStep
                      < step - restingSteps;
    });
    m_tidyAt = std::max<std::size_t>(1024, 2 * m_latest.size());
}

void EncounterLog::truncateAfter(qint64 step, double time)
{
    while (!m_encounters.empty() && m_encounters.back().step > step)
        m_encounters.pop_back();
    std::erase_if(m_latest, [this](const auto &entry) { return entry.second >= end(); });
    for (const qint64 index : m_lasting) {
        if (index < m_dropped || index >= end())
            continue;
        Encounter &contact = m_encounters[static_cast<std::size_t>(index - m_dropped)];
        contact.endTime = std::min(contact.endTime, time);
        contact.endStep = std::min(contact.endStep, step);
    }
    std::erase_if(m_lasting, [this](qint64 index) {
        return index >= end()
               || (index >= m_dropped
                   && !m_encounters[static_cast<std::size_t>(index - m_dropped)].lasts());
    });
}

void EncounterLog::dropBefore(qint64 step)
{
    while (!m_encounters.empty() && m_encounters.front().step < step) {
        m_encounters.pop_front();
        ++m_dropped;
    }
    while (!m_lasting.empty() && m_lasting.front() < m_dropped)
        m_lasting.pop_front();
}

} // namespace cradle
