// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/proof/hit_answer.h"

#include "tasks/checks/contacts.h"

#include <cmath>

namespace cradle {

namespace {

std::optional<HitAnswer> pairAnswer(const CheckSpec &check, const Observation &run)
{
    const int a = check.circles[0];
    const int b = check.circles[1];
    const auto contacts = motion::contactsOf(run, a, b, run.variant.preset.gravity);
    if (contacts.empty())
        return std::nullopt;
    const motion::Contact &hit = contacts.front();
    const Vec2 normal = normalized(hit.afterA - hit.beforeA);
    const double approach = dot(hit.beforeB - hit.beforeA, normal);
    if (approach <= 0.0)
        return std::nullopt;
    const Circle &ca = run.circle(a, hit.step);
    const Circle &cb = run.circle(b, hit.step);
    return HitAnswer{.after = hit.step + 1,
                     .a = a,
                     .b = b,
                     .normal = normal,
                     .approach = approach,
                     .restitution = dot(hit.afterA - hit.afterB, normal) / approach,
                     .massRatio = mass(cb) / mass(ca),
                     .radiusRatio = cb.radius / ca.radius};
}

} // namespace

std::vector<Vec2> HitAnswer::shifts(std::size_t circles, double restitutionBy,
                                    double exponentBy) const
{
    std::vector<Vec2> shifts(circles);
    const auto put = [&](int circle, Vec2 shift) {
        shifts[static_cast<std::size_t>(circle)] = shift;
    };
    if (b < 0) {
        put(a, restitutionBy * approach * normal);
        return shifts;
    }
    // v_a = u_a + (1 + e) m_b/(m_a + m_b) (u_b - u_a)·n n, and so for b with the roles exchanged.
    const auto parts = [&](double e, double ratio) {
        const double impulse = (1.0 + e) * approach;
        return std::pair(impulse * ratio / (1.0 + ratio), -impulse / (1.0 + ratio));
    };
    const auto right = parts(restitution, massRatio);
    const auto wrong =
        parts(restitution + restitutionBy, massRatio * std::pow(radiusRatio, exponentBy));
    put(a, (wrong.first - right.first) * normal);
    put(b, (wrong.second - right.second) * normal);
    return shifts;
}

std::optional<HitAnswer> answerIn(const CheckSpec &check, const Observation &run, qint64 wallHit)
{
    if (check.circles.size() > 1) {
        if (auto pair = pairAnswer(check, run))
            return pair;
    }
    if (wallHit < 1)
        return std::nullopt;
    const int circle = check.circles.front();
    const Vec2 before =
        run.circle(circle, wallHit - 1).velocity + run.timestep() * run.variant.preset.gravity;
    const Vec2 normal = normalized(run.circle(circle, wallHit).velocity - before);
    const double approach = -dot(before, normal);
    if (approach <= 0.0)
        return std::nullopt;
    return HitAnswer{.after = wallHit, .a = circle, .normal = normal, .approach = approach};
}

} // namespace cradle
