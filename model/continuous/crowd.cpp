// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/crowd.h"

#include "model/contacts/disc_grid.h"

#include <algorithm>
#include <limits>

namespace cradle {

namespace {

/// λ = A / (2 √2 N d), the mean free path (m) of hard discs of diameter d in a square \p width m
/// wide, while they are few.
double meanFreePath(std::span<const Circle> circles, double width)
{
    double diameters = 0.0;
    for (const Circle &c : circles)
        diameters += 2.0 * c.radius;
    return diameters > 0.0 ? width * width / (2.0 * std::sqrt(2.0) * diameters)
                           : std::numeric_limits<double>::infinity();
}

/// The wider side of the box around the centres, m.
double extentOf(std::span<const Circle> circles)
{
    Vec2 low = circles.empty() ? Vec2{} : circles[0].position;
    Vec2 high = low;
    for (const Circle &c : circles) {
        low = {std::min(low.x, c.position.x), std::min(low.y, c.position.y)};
        high = {std::max(high.x, c.position.x), std::max(high.y, c.position.y)};
    }
    return std::max(high.x - low.x, high.y - low.y);
}

/// Puts those that \p sorted has into its order; the others stay.
/// \param arranged  working memory
template <class Value>
void arrangeBy(std::span<const Crowd::Slot> sorted, std::vector<Value> &values,
               std::vector<Value> &arranged)
{
    arranged.clear();
    for (const Crowd::Slot slot : sorted)
        arranged.push_back(values[slot]);
    arranged.insert(arranged.end(), values.begin() + std::ssize(arranged), values.end());
    values.swap(arranged);
}

} // namespace

void Crowd::start(const Rules &ruled, std::span<const Circle> circles)
{
    rules = ruled;
    gravity = length(rules.gravity);
    const std::vector<Integrator> &all = rules.integrators;
    alike = std::adjacent_find(all.begin(), all.end(), std::not_equal_to<>()) == all.end();
    hasPiles = gravity > 0.0 && rules.restitution < 1.0 && rules.laws.circles == CircleLaw::Impulse;

    GiantsApart apart = giantsApart(circles);
    ids = std::move(apart.ids);
    small = static_cast<Slot>(apart.small);
    smallRadius = apart.smallRadius;
    width = rules.laws.walls == WallLaw::Reflect ? 2.0 * rules.halfWidth
                                                 : extentOf(circles) + smallRadius;
    freePath = meanFreePath(circles, width);

    motions.clear();
    radii.clear();
    for (const std::uint32_t id : ids) {
        motions.push_back({circles[id].position, circles[id].velocity});
        radii.push_back(circles[id].radius);
    }
    densities.clear();
    for (const Circle &c : circles)
        densities.push_back(c.density);
    sleep.start(circles.size());
    slotOf.assign(circles.size(), 0);
}

void Crowd::read(std::span<Circle> circles) const
{
    for (Slot slot = 0; slot < count(); ++slot) {
        circles[ids[slot]].position = motions[slot].position;
        circles[ids[slot]].velocity = motions[slot].velocity;
    }
}

void Crowd::arrange(std::span<const Slot> sorted)
{
    arrangeBy(sorted, motions, m_motions);
    arrangeBy(sorted, radii, m_radii);
    arrangeBy(sorted, ids, m_ids);
    for (Slot slot = 0; slot < count() && sleep.count() > 0; ++slot)
        slotOf[ids[slot]] = slot;
}

Path Crowd::path(Slot slot) const
{
    if (sleeps(slot))
        return {motions[slot].position, Vec2{}, Vec2{}};
    return {motions[slot].position, motions[slot].velocity,
            pathCurvature(integrator(slot)) * rules.gravity};
}

Motion Crowd::freely(Slot slot, double dt) const
{
    if (sleeps(slot))
        return motions[slot];
    return advance(integrator(slot), motions[slot], rules.gravity, dt);
}

void Crowd::flyFreely(double dt)
{
    if (alike && !rules.integrators.empty() && sleep.count() == 0) {
        const Integrator one = rules.integrators.front();
        for (Motion &motion : motions)
            motion = advance(one, motion, rules.gravity, dt);
        return;
    }
    for (Slot slot = 0; slot < count(); ++slot)
        motions[slot] = freely(slot, dt);
}

} // namespace cradle
