// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/circle_edits.h"

#include "model/collision_detection.h"
#include "views/circle_name.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace cradle {

namespace {

constexpr double gapShare = 0.1; ///< of the radius, left between a circle and its copy
constexpr int searchRings = 60;  ///< rings of places that are tried around a centre
constexpr int directions = 8;    ///< the first ring's places; each further ring has more

bool isFree(const Preset &preset, const Circle &circle)
{
    const double room = preset.halfWidth - circle.radius;
    if (std::abs(circle.position.x) > room || std::abs(circle.position.y) > room)
        return false;
    return std::none_of(preset.circles.begin(), preset.circles.end(),
                        [&](const PresetCircle &other) { return overlap(other.body, circle); });
}

/// The free place nearest to \p centre, found on rings; \p centre itself if there is none.
Vec2 freePlace(const Preset &preset, Circle circle, Vec2 centre)
{
    circle.position = centre;
    if (isFree(preset, circle))
        return centre;
    const double pitch = (2.0 + gapShare) * circle.radius;
    for (int ring = 1; ring <= searchRings; ++ring) {
        for (int k = 0; k < ring * directions; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / (ring * directions);
            const double r = ring * pitch;
            if (r > 2.0 * std::numbers::sqrt2 * preset.halfWidth)
                return centre;
            const Vec2 offset{r * std::cos(angle), r * std::sin(angle)};
            // Numbers that can be read: a thousandth of a millimetre is near enough.
            circle.position = {std::round((centre.x + offset.x) * 1e6) / 1e6,
                               std::round((centre.y + offset.y) * 1e6) / 1e6};
            if (isFree(preset, circle))
                return circle.position;
        }
    }
    return centre;
}

QString freeName(const Preset &preset)
{
    std::set<QString> taken;
    for (const PresetCircle &circle : preset.circles)
        taken.insert(circle.name);
    for (std::size_t n = preset.circles.size() + 1;; ++n) {
        const QString name = plainCircleName(n);
        if (!taken.contains(name))
            return name;
    }
}

QString freeColour(const Preset &preset)
{
    const QStringList &colours = circleColours();
    for (const QString &colour : colours) {
        if (std::none_of(preset.circles.begin(), preset.circles.end(), [&](const PresetCircle &c) {
                return c.colour.compare(colour, Qt::CaseInsensitive) == 0;
            }))
            return colour;
    }
    return colours[static_cast<qsizetype>(preset.circles.size()) % colours.size()];
}

bool isIndex(const Preset &preset, int index)
{
    return index >= 0 && static_cast<std::size_t>(index) < preset.circles.size();
}

} // namespace

const QStringList &circleColours()
{
    // Dodger blue and red of the lab, then Okabe and Ito's palette without their likes.
    static const QStringList colours{QStringLiteral("#1e90ff"), QStringLiteral("#e03131"),
                                     QStringLiteral("#e69f00"), QStringLiteral("#009e73"),
                                     QStringLiteral("#cc79a7"), QStringLiteral("#6741d9"),
                                     QStringLiteral("#8c5a2b"), QStringLiteral("#5c6b7a")};
    return colours;
}

Preset withAddedCircle(const Preset &preset, std::optional<Vec2> at)
{
    Preset changed = preset;
    PresetCircle circle = preset.circles.empty() ? PresetCircle{} : preset.circles.back();
    circle.name = freeName(preset);
    circle.colour = freeColour(preset);
    circle.body.velocity = {};
    const double room = std::max(0.0, preset.halfWidth - circle.body.radius);
    const Vec2 wish = at.value_or(Vec2{});
    circle.body.position = freePlace(
        preset, circle.body, {std::clamp(wish.x, -room, room), std::clamp(wish.y, -room, room)});
    changed.circles.push_back(circle);
    changed.fill.reset();
    return changed;
}

Preset withDuplicate(const Preset &preset, int index)
{
    if (!isIndex(preset, index))
        return preset;
    Preset changed = preset;
    PresetCircle copy = preset.circles[static_cast<std::size_t>(index)];
    copy.name = freeName(preset);
    copy.colour = freeColour(preset);
    if (preset.laws.circles != CircleLaw::None)
        copy.body.position = freePlace(preset, copy.body, copy.body.position);
    changed.circles.push_back(copy);
    changed.fill.reset();
    return changed;
}

Preset withoutCircle(const Preset &preset, int index)
{
    if (!isIndex(preset, index))
        return preset;
    Preset changed = preset;
    changed.circles.erase(changed.circles.begin() + index);
    changed.fill.reset();
    return changed;
}

} // namespace cradle
