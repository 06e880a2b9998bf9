// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/circle_edits.h"

#include "model/contacts/collision_detection.h"
#include "views/circle_name.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace cradle {

namespace {

constexpr double gapShare = 0.1; ///< of the radius, left between a circle and its copy
constexpr int searchRings = 60;  ///< rings of places that are tried around a centre
constexpr int directions = 8;    ///< the first ring's places; each further ring has more
/// Comparisons of two circles that a search for places may cost: about a tenth of a second.
constexpr std::size_t mostTests = 10'000'000;
constexpr std::size_t fewCircles = 20; ///< are placed one by one where all together find no room

Vec2 rounded(Vec2 place)
{
    // Numbers that can be read: a thousandth of a millimetre is near enough.
    return {std::round(place.x * 1e6) / 1e6, std::round(place.y * 1e6) / 1e6};
}

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
            circle.position = rounded(centre + offset);
            if (isFree(preset, circle))
                return circle.position;
        }
    }
    return centre;
}

/// Gives circles names and colours that no other has.
class Identities
{
public:
    explicit Identities(const Preset &preset)
        : m_count(preset.circles.size())
    {
        for (const PresetCircle &circle : preset.circles) {
            m_names.insert(circle.name);
            m_colours.insert(circle.colour.toLower());
        }
    }

    /// Takes those of \p circle where they are free, else others.
    void settle(PresetCircle &circle)
    {
        ++m_count;
        if (circle.name.isEmpty() || m_names.count(circle.name) > 0)
            circle.name = freeName();
        if (m_colours.count(circle.colour.toLower()) > 0)
            circle.colour = freeColour();
        m_names.insert(circle.name);
        m_colours.insert(circle.colour.toLower());
    }

private:
    [[nodiscard]] QString freeName() const
    {
        for (std::size_t n = m_count;; ++n) {
            const QString name = plainCircleName(n);
            if (m_names.count(name) == 0)
                return name;
        }
    }

    [[nodiscard]] QString freeColour() const
    {
        const QStringList &colours = circleColours();
        for (const QString &colour : colours) {
            if (m_colours.count(colour) == 0)
                return colour;
        }
        return colours[static_cast<qsizetype>(m_count - 1) % colours.size()];
    }

    std::set<QString> m_names;
    std::set<QString> m_colours; ///< lower case
    std::size_t m_count;         ///< of circles
};

/// Moves \p circles alike to the nearest places that are free in \p preset.
/// \return false if there are none or it would take too long to find them
bool moveToFreePlaces(const Preset &preset, std::vector<PresetCircle> &circles)
{
    const std::size_t tests = std::max<std::size_t>(1, circles.size() * preset.circles.size());
    const std::size_t most = mostTests / tests + 1;
    double pitch = 0.0;
    for (const PresetCircle &circle : circles)
        pitch = std::max(pitch, (2.0 + gapShare) * circle.body.radius);
    std::size_t tried = 0;
    const auto tryOffset = [&](Vec2 offset) {
        ++tried;
        std::vector<PresetCircle> moved = circles;
        for (PresetCircle &circle : moved) {
            if (offset != Vec2{})
                circle.body.position = rounded(circle.body.position + offset);
            if (!isFree(preset, circle.body))
                return false;
        }
        circles = std::move(moved);
        return true;
    };
    if (tryOffset({}))
        return true;
    for (int ring = 1; ring <= searchRings; ++ring) {
        for (int k = 0; k < ring * directions && tried < most; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / (ring * directions);
            if (tryOffset(ring * pitch * Vec2{std::cos(angle), std::sin(angle)}))
                return true;
        }
    }
    return false;
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
    Identities(preset).settle(circle);
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
    return withDuplicates(preset, {index});
}

Preset withDuplicates(const Preset &preset, const std::vector<int> &indices)
{
    std::vector<PresetCircle> copies;
    for (const int index : indices) {
        if (isIndex(preset, index))
            copies.push_back(preset.circles[static_cast<std::size_t>(index)]);
    }
    if (preset.laws.circles != CircleLaw::None)
        return withPasted(preset, std::move(copies));
    Preset changed = preset;
    Identities identities(preset);
    for (PresetCircle &copy : copies) {
        identities.settle(copy);
        changed.circles.push_back(copy);
    }
    if (!copies.empty())
        changed.fill.reset();
    return changed;
}

Preset withPasted(const Preset &preset, std::vector<PresetCircle> circles)
{
    Preset changed = preset;
    if (circles.empty())
        return changed;
    const bool together = moveToFreePlaces(preset, circles);
    Identities identities(preset);
    for (PresetCircle &circle : circles) {
        identities.settle(circle);
        if (!together && circles.size() <= fewCircles) {
            const double room = std::max(0.0, preset.halfWidth - circle.body.radius);
            const Vec2 wish = circle.body.position;
            circle.body.position =
                freePlace(changed, circle.body,
                          {std::clamp(wish.x, -room, room), std::clamp(wish.y, -room, room)});
        }
        changed.circles.push_back(circle);
    }
    changed.fill.reset();
    return changed;
}

Preset withoutCircle(const Preset &preset, int index)
{
    return withoutCircles(preset, {index});
}

Preset withoutCircles(const Preset &preset, const std::vector<int> &indices)
{
    std::vector<bool> removed(preset.circles.size(), false);
    bool any = false;
    for (const int index : indices) {
        if (isIndex(preset, index))
            any = removed[static_cast<std::size_t>(index)] = true;
    }
    if (!any)
        return preset;
    Preset changed = preset;
    changed.circles.clear();
    for (std::size_t i = 0; i < removed.size(); ++i) {
        if (!removed[i])
            changed.circles.push_back(preset.circles[i]);
    }
    changed.fill.reset();
    return changed;
}

Vec2 withinReach(const Preset &preset, const std::vector<int> &indices, Vec2 by)
{
    if (preset.laws.walls == WallLaw::None)
        return by;
    const auto limited = [](double way, double place, double room) {
        return std::clamp(way, std::min(0.0, -room - place), std::max(0.0, room - place));
    };
    for (const int index : indices) {
        const Circle &circle = preset.circles[static_cast<std::size_t>(index)].body;
        const double room = std::max(preset.halfWidth - circle.radius, 0.0);
        by = {limited(by.x, circle.position.x, room), limited(by.y, circle.position.y, room)};
    }
    return by;
}

} // namespace cradle
