// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/circle_edits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cradle {

namespace {

/// Colours that colour-blind people can tell apart.
constexpr const char *palette[] = {"#1e90ff", "#e03131", "#f59f00", "#0ca678",
                                   "#7048e8", "#e64980", "#495057"};

constexpr double usualRadius = 0.05; ///< half widths: 0.2 m in the usual square

QString nextName(const Preset &preset)
{
    for (int n = static_cast<int>(preset.circles.size()) + 1;; ++n) {
        const QString name = QStringLiteral("circle %1").arg(n);
        if (std::none_of(preset.circles.begin(), preset.circles.end(),
                         [&](const PresetCircle &circle) { return circle.name == name; }))
            return name;
    }
}

/// The first colour of the palette that the fewest circles have.
QString nextColour(const Preset &preset)
{
    const auto uses = [&](const char *colour) {
        return std::count_if(
            preset.circles.begin(), preset.circles.end(), [colour](const PresetCircle &circle) {
                return circle.colour.compare(QLatin1String(colour), Qt::CaseInsensitive) == 0;
            });
    };
    const auto *rarest =
        std::min_element(std::begin(palette), std::end(palette),
                         [&](const char *a, const char *b) { return uses(a) < uses(b); });
    return QLatin1String(*rarest);
}

Vec2 insideSquare(Vec2 place, double halfWidth, double radius)
{
    const double room = std::max(halfWidth - radius, 0.0);
    return {std::clamp(place.x, -room, room), std::clamp(place.y, -room, room)};
}

} // namespace

Vec2 freePlace(const Preset &preset, Vec2 at, double radius)
{
    const Vec2 start = insideSquare(at, preset.halfWidth, radius);
    const auto isFree = [&](Vec2 place, double gap) {
        return insideSquare(place, preset.halfWidth, radius) == place
               && std::none_of(preset.circles.begin(), preset.circles.end(),
                               [&](const PresetCircle &other) {
                                   return length(other.body.position - place)
                                          < other.body.radius + radius + gap;
                               });
    };
    if (isFree(start, 0.0))
        return start;
    // Rings around the place until the square is left on every side; with some air if possible.
    const double ringStep = std::max(radius / 2, preset.halfWidth / 40);
    const int rings = static_cast<int>(3.0 * preset.halfWidth / ringStep);
    for (const double gap : {radius, 0.0}) {
        for (int ring = 1; ring <= rings; ++ring) {
            const int places = 8 * ring;
            for (int k = 0; k < places; ++k) {
                const double angle = 2.0 * std::numbers::pi * k / places;
                const Vec2 place = start + ring * ringStep * Vec2{std::cos(angle), std::sin(angle)};
                if (isFree(place, gap))
                    return place;
            }
        }
    }
    return start;
}

Preset withNewCircle(const Preset &preset, Vec2 at)
{
    Preset changed = preset;
    changed.fill.reset();
    PresetCircle circle{.name = nextName(preset), .colour = nextColour(preset)};
    if (!preset.circles.empty())
        circle.integrator = preset.circles.back().integrator;
    circle.body.radius = usualRadius * preset.halfWidth;
    circle.body.position = freePlace(preset, at, circle.body.radius);
    changed.circles.push_back(circle);
    return changed;
}

Preset withDuplicate(const Preset &preset, int index)
{
    Preset changed = preset;
    changed.fill.reset();
    PresetCircle copy = preset.circles[static_cast<std::size_t>(index)];
    copy.name = nextName(preset);
    copy.colour = nextColour(preset);
    if (preset.laws.circles != CircleLaw::None) {
        const double beside = 2.5 * copy.body.radius;
        copy.body.position =
            freePlace(preset, copy.body.position + Vec2{beside, 0.0}, copy.body.radius);
    }
    changed.circles.push_back(copy);
    return changed;
}

Preset withoutCircle(const Preset &preset, int index)
{
    Preset changed = preset;
    changed.fill.reset();
    changed.circles.erase(changed.circles.begin() + index);
    return changed;
}

} // namespace cradle
