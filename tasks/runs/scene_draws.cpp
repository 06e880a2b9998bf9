// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/runs/scene_draws.h"

#include "tasks/runs/meeting_scene.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr double halfWidth = 4.0; ///< of the square of pinned scenes, m

/// What item \p i of a list is when the list is gone through again and again.
double cycle(const std::vector<double> &list, int i)
{
    return list[static_cast<std::size_t>(i) % list.size()];
}

} // namespace

SceneDraws::SceneDraws(const Preset &submission, const CheckSpec &check, qint64 seed)
    : m_submission(submission)
    , m_spec(check, submission.timestep)
    , m_random(check.scene.value(QStringLiteral("seed")).toInteger(seed))
{
}

double SceneDraws::spread(double place) const
{
    return m_spec.angles.x + (m_spec.angles.y - m_spec.angles.x) * place / m_spec.count;
}

double SceneDraws::angleOf(int i)
{
    const double drawn = spread(i + m_random.between(0.0, 1.0));
    const double end = spread(i + 1.0);
    return std::fmod(end, 90.0) == 0.0 ? std::fmod(end, 360.0) : drawn;
}

std::size_t SceneDraws::needed() const
{
    return static_cast<std::size_t>(*std::max_element(m_spec.circles.begin(), m_spec.circles.end()))
           + 1;
}

Preset SceneDraws::stage(int i, std::size_t circles)
{
    Preset preset = m_submission;
    preset.fill.reset();
    preset.halfWidth = halfWidth;
    preset.gravity = m_spec.gravity;
    preset.restitution = cycle(m_spec.restitutions, i);
    // Offset, so that restitutions and timesteps do not go in step.
    preset.timestep = cycle(m_spec.timesteps, i + i / static_cast<int>(m_spec.timesteps.size()));
    preset.circles.resize(std::max(circles, needed()));
    for (PresetCircle &circle : preset.circles) {
        circle.body = {.radius = range(m_spec.radii), .density = range(m_spec.densities)};
    }
    return preset;
}

bool SceneDraws::doesCreep(int i) const
{
    constexpr int many = 12;
    const int count = m_spec.count;
    return i == count / 2 || i == count / 4 || i == count - 1
           || (count >= many && i == 3 * count / 4);
}

void SceneDraws::partRadii(Preset &preset, std::size_t shot, bool isLarge) const
{
    const Vec2 ends = m_spec.radii;
    for (std::size_t k = 0; k < preset.circles.size(); ++k) {
        double &radius = preset.circles[k].body.radius;
        const double end = (k == shot) == isLarge ? ends.y : ends.x;
        radius = end + 0.25 * (radius - end);
    }
}

bool SceneDraws::meetsAgain(int i, double e) const
{
    // Straight on they meet again on the same line: that is a rally.
    if (!m_spec.again || e < leastRestitution || m_spec.offset == 0.0)
        return false;
    const auto all = static_cast<int>(m_spec.restitutions.size());
    if (all == 1)
        return i % 8 == 4;
    return e == 1.0 ? (i / all) % 2 == 0 : (i / all + i % all) % 4 == 0;
}

} // namespace cradle
