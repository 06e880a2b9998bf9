// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/hit_at_moment.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Of what is wrong with a velocity, across the line of centres; where two touch is known to some
/// degrees.
constexpr double acrossShare = 0.15;

/// Of the circle that is most wrong: a place is set anew by every way of parting two.
constexpr double wrongVelocity = 0.05;
constexpr double wrongPlace = 0.5;

constexpr double factorBlur = 0.02; ///< of a push: the line of centres turns a little in a step

} // namespace

HitAtMoment::HitAtMoment(const QString &program, const QString &reference, const Moment &moment)
    : m_moment(moment)
    , m_before(worldAfter(program, moment.stage, moment.step - 1))
    , m_own(worldAfter(program, moment.stage, moment.step))
    , m_right(reference.isEmpty() ? std::nullopt : worldAfter(reference, moment.stage, moment.step))
{
}

Vec2 HitAtMoment::offOf(int circle) const
{
    const auto at = static_cast<std::size_t>(circle);
    const Circle &own = m_own->circles[at];
    const Circle &right = m_right->circles[at];
    return m_moment.isPosition ? own.position - right.position : own.velocity - right.velocity;
}

std::vector<int> HitAtMoment::wrongCircles() const
{
    if (!m_own || !m_right)
        return m_moment.circles;
    double most = 0.0;
    for (const int circle : m_moment.circles)
        most = std::max(most, length(offOf(circle)));
    const double least = (m_moment.isPosition ? wrongPlace : wrongVelocity) * most;
    std::vector<int> wrong;
    std::copy_if(m_moment.circles.begin(), m_moment.circles.end(), std::back_inserter(wrong),
                 [&](int circle) { return length(offOf(circle)) > least; });
    // Whose velocity stays as it was has no line of its own: one is missing.
    const bool isLeft =
        !m_moment.isPosition && m_before
        && std::any_of(wrong.begin(), wrong.end(), [&](int circle) {
               const auto at = static_cast<std::size_t>(circle);
               return length(m_own->circles[at].velocity - m_before->circles[at].velocity)
                      < wrongVelocity * most;
           });
    return wrong.empty() || isLeft ? m_moment.circles : wrong;
}

bool HitAtMoment::isSizeWrong() const
{
    if (!m_own || !m_right || m_right->circles.size() < 2)
        return false;
    const Vec2 between = m_right->circles[1].position - m_right->circles[0].position;
    const double away = length(between);
    return away > 0.0 && std::all_of(m_moment.circles.begin(), m_moment.circles.end(), [&](int i) {
               const auto at = static_cast<std::size_t>(i);
               const Vec2 off = m_own->circles[at].velocity - m_right->circles[at].velocity;
               return std::abs(cross(off, between)) / away <= acrossShare * length(off);
           });
}

std::optional<double> HitAtMoment::timesRight() const
{
    if (!m_before || !m_own || !m_right || m_right->circles.size() < 2)
        return std::nullopt;
    std::optional<double> times;
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec2 own = m_own->circles[i].velocity - m_before->circles[i].velocity;
        const Vec2 right = m_right->circles[i].velocity - m_before->circles[i].velocity;
        if (length(right) == 0.0)
            return std::nullopt;
        const double here = dot(own, right) / dot(right, right);
        const double blur = factorBlur * length(right) * std::max(1.0, std::abs(here));
        if (length(own - here * right) > blur || std::abs(times.value_or(here) - here) > factorBlur)
            return std::nullopt;
        times = here;
    }
    return times;
}

} // namespace cradle
