// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/handles.h"

#include "views/circle_edits.h"
#include "views/circle_name.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cradle {

namespace {

constexpr double usualScale = 3.0 / 16.0; ///< of the half width, m per m/s
constexpr double fallenArrow = 1.5;       ///< half widths, of what fell through the whole square
constexpr double longestArrow = 2.0;      ///< half widths
constexpr double gripReach = 9.0;         ///< px around a tip that take hold of it
constexpr double gripGap = 9.0;           ///< px from a circle's edge to the grip of a slow one
constexpr double smallestDisc = 8.0;      ///< px around a centre that take hold of a tiny circle

double distanceInPixels(QPointF pixel, Vec2 place, const Camera &camera)
{
    const QPointF d = camera.toPixels(place) - pixel;
    return std::hypot(d.x(), d.y());
}

double snapped(double value)
{
    return std::round(value / HandleDrag::snapStep) / std::round(1.0 / HandleDrag::snapStep);
}

/// Sums of tenths stay tenths.
Vec2 tidy(Vec2 value)
{
    return {std::round(value.x * 1e9) / 1e9, std::round(value.y * 1e9) / 1e9};
}

} // namespace

double arrowScale(const Preset &scene)
{
    const double height = 2.0 * scene.halfWidth;
    const double fallen = std::sqrt(2.0 * length(scene.gravity) * height); // m/s
    const double usual = usualScale * scene.halfWidth;
    const double longest = fallenArrow * scene.halfWidth;
    return usual * fallen > longest ? longest / fallen : usual;
}

Vec2 arrowTip(Vec2 from, Vec2 velocity, const Preset &scene)
{
    Vec2 shaft = arrowScale(scene) * velocity;
    const double longest = longestArrow * scene.halfWidth;
    if (const double l = length(shaft); l > longest)
        shaft = (longest / l) * shaft;
    return from + shaft;
}

Vec2 gripPosition(const Circle &circle, const Preset &scene, double pixelsPerMetre)
{
    const Vec2 shaft = arrowTip({}, circle.velocity, scene);
    const double shortest = circle.radius + gripGap / pixelsPerMetre;
    if (length(shaft) >= shortest)
        return circle.position + shaft;
    const Vec2 direction = normalized(shaft);
    return circle.position + shortest * (direction == Vec2{} ? Vec2{1.0, 0.0} : direction);
}

Handle handleAt(QPointF pixel, std::span<const Circle> circles, const Preset &scene,
                const Camera &camera, int selected, bool velocities)
{
    const double scale = camera.pixelsPerMetre();
    const auto onGrip = [&](int i) {
        const Circle &c = circles[static_cast<std::size_t>(i)];
        return velocities
               && distanceInPixels(pixel, gripPosition(c, scene, scale), camera) <= gripReach;
    };
    const auto onDisc = [&](int i) {
        const Circle &c = circles[static_cast<std::size_t>(i)];
        return distanceInPixels(pixel, c.position, camera)
               <= std::max(c.radius * scale, smallestDisc);
    };
    const int count = static_cast<int>(circles.size());
    if (selected >= 0 && selected < count) {
        if (onGrip(selected))
            return {Handle::Kind::Velocity, selected};
        if (onDisc(selected))
            return {Handle::Kind::Circle, selected};
    }
    // The last one lies on top.
    for (int i = count - 1; i >= 0; --i) {
        if (onDisc(i))
            return {Handle::Kind::Circle, i};
    }
    for (int i = count - 1; i >= 0; --i) {
        if (onGrip(i))
            return {Handle::Kind::Velocity, i};
    }
    return {};
}

QString pairText(Vec2 value)
{
    // + 0.0 makes −0 to 0; what rounds to zero has no sign either.
    const auto number = [](double v) {
        QString text = QString::number(v, 'f', 2);
        if (text == QLatin1String("-0.00"))
            text.remove(0, 1);
        return text.replace(QLatin1Char('-'), QChar(0x2212));
    };
    return QStringLiteral("(%1, %2)").arg(number(value.x), number(value.y));
}

QString circleName(const Preset &preset, int index)
{
    const QString name = preset.circles[static_cast<std::size_t>(index)].name;
    return name.isEmpty() ? QString::number(index + 1) : shownCircleName(name);
}

Vec2 withinWalls(const Preset &preset, int index)
{
    const Circle &circle = preset.circles[static_cast<std::size_t>(index)].body;
    if (preset.laws.walls == WallLaw::None)
        return circle.position;
    const double room = std::max(preset.halfWidth - circle.radius, 0.0);
    return {std::clamp(circle.position.x, -room, room), std::clamp(circle.position.y, -room, room)};
}

HandleDrag::HandleDrag(Handle handle, const Preset &start, Vec2 pressed, std::vector<int> together,
                       double scale)
    : m_handle(handle)
    , m_dragged(std::move(together))
    , m_start(start)
    , m_pressed(pressed)
    , m_scale(scale)
{
    static int serial = 0;
    m_serial = ++serial;
    if (std::find(m_dragged.begin(), m_dragged.end(), handle.index) == m_dragged.end())
        m_dragged = {handle.index};
}

Preset HandleDrag::candidate(Vec2 pointer, bool snap) const
{
    Preset changed = m_start;
    changed.fill.reset();
    const Circle &body = m_start.circles[static_cast<std::size_t>(m_handle.index)].body;
    const bool moves = m_handle.kind == Handle::Kind::Circle;
    const Vec2 way = pointer - m_pressed;
    Vec2 value = moves ? body.position + way : body.velocity + way / m_scale;
    if (snap)
        value = {snapped(value.x), snapped(value.y)};
    if (moves) {
        moveTo(changed, value);
        return changed;
    }
    for (const int index : m_dragged) {
        Vec2 &velocity = changed.circles[static_cast<std::size_t>(index)].body.velocity;
        velocity = index == m_handle.index ? value : tidy(velocity + (value - body.velocity));
    }
    return changed;
}

/// Brings the circle that is held to \p target (m) and the others as far.
void HandleDrag::moveTo(Preset &changed, Vec2 target) const
{
    const Vec2 from = m_start.circles[static_cast<std::size_t>(m_handle.index)].body.position;
    const Vec2 way = withinReach(m_start, m_dragged, target - from);
    for (const int index : m_dragged) {
        Vec2 &position = changed.circles[static_cast<std::size_t>(index)].body.position;
        position = tidy(position + way);
        if (index == m_handle.index && m_dragged.size() == 1)
            position = target;
        position = withinWalls(changed, index);
    }
}

std::vector<Circle> HandleDrag::dragged(const Preset &candidate) const
{
    std::vector<Circle> circles;
    for (const int index : m_dragged)
        circles.push_back(candidate.circles[static_cast<std::size_t>(index)].body);
    return circles;
}

QString HandleDrag::editText() const
{
    const QString name = circleName(m_start, m_handle.index);
    const auto count = static_cast<int>(m_dragged.size());
    if (m_handle.kind == Handle::Kind::Circle)
        return count > 1 ? tr("Move %n circles", nullptr, count) : tr("Move %1").arg(name);
    return count > 1 ? tr("Change velocities of %n circles", nullptr, count)
                     : tr("Change velocity of %1").arg(name);
}

QString HandleDrag::mergeKey() const
{
    return QStringLiteral("scene drag %1").arg(m_serial);
}

QString HandleDrag::valueText(const Preset &candidate) const
{
    const auto index = static_cast<std::size_t>(m_handle.index);
    const Circle &body = candidate.circles[index].body;
    const bool several = m_dragged.size() > 1;
    if (m_handle.kind == Handle::Kind::Velocity && several)
        return tr("changed by %1 m/s")
            .arg(pairText(body.velocity - m_start.circles[index].body.velocity));
    if (m_handle.kind == Handle::Kind::Velocity)
        return tr("%1 m/s, speed %2 m/s")
            .arg(pairText(body.velocity), QString::number(length(body.velocity), 'f', 2));
    if (several)
        return tr("moved by %1 m")
            .arg(pairText(body.position - m_start.circles[index].body.position));
    return tr("%1 m").arg(pairText(body.position));
}

} // namespace cradle
