// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/contact_comparison.h"

#include "tasks/judging/response_laws.h"

#include <algorithm>
#include <numbers>

namespace cradle {

void ContactComparison::add(const QString &headline, const QString &body, const PairHit &hit,
                            Suspect suspect)
{
    m_found.push_back({Aspect::Contact,
                       headline + QStringLiteral("\n\n") + body,
                       {hit.stage, std::max<qint64>(hit.step, 1), {0, 1}, false},
                       suspect});
}

bool ContactComparison::answersAny(const std::vector<PairHit> &hits)
{
    return std::any_of(hits.begin(), hits.end(), [](const PairHit &h) { return h.answered; });
}

bool ContactComparison::meetsAny(const std::vector<PairHit> &hits)
{
    return std::any_of(hits.begin(), hits.end(), [](const PairHit &h) { return h.isMet(); });
}

bool ContactComparison::answersRightly() const
{
    return std::equal(m_own.equals.begin(), m_own.equals.end(), m_right.equals.begin(),
                      m_right.equals.end(), [](const PairHit &a, const PairHit &b) {
                          return a.isMet() == b.isMet()
                                 && (!a.isMet() || isSameAnswer(a.leftParts(), b.leftParts()));
                      });
}

bool ContactComparison::isDirectionWrong() const
{
    const auto isAskew = [](const PairHit &h) { return h.isInTime() && !h.isAlongCentres(); };
    const auto isInTime = [](const PairHit &h) { return h.isInTime(); };
    // Deep inside each other the line of centres turns fast.
    const bool areEqualsInTime = std::any_of(m_own.equals.begin(), m_own.equals.end(), isInTime);
    const std::vector<PairHit> &hits = areEqualsInTime ? m_own.equals : m_own.varied;
    return !answersRightly() && std::any_of(hits.begin(), hits.end(), isAskew)
           && arePushedAlong(m_right);
}

double ContactComparison::fastestThrown() const
{
    double fastest = 0.0;
    for (const PairHit &thrown : m_own.contacts)
        fastest = std::max(fastest, thrown.slowness * thrown.meeting.closing());
    return fastest;
}

PairHit ContactComparison::whereTheyTouch(PairHit hit)
{
    const Preset &preset = hit.stage.preset;
    const Vec2 d = preset.circles[1].body.position - preset.circles[0].body.position;
    const double angle = hit.meeting.degrees * std::numbers::pi / 180.0;
    const double gap = dot(d, {std::cos(angle), std::sin(angle)}) - hit.meeting.sum();
    hit.step = 1 + static_cast<qint64>(gap / (hit.meeting.closing() * preset.timestep));
    return hit;
}

} // namespace cradle
