// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/ghost.h"

#include "views/scene/program_drawings.h"
#include "views/theme.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cradle {

namespace {

struct GhostText {
    Q_DECLARE_TR_FUNCTIONS(Ghost)
};

constexpr double timeSlack = 1e-9;    ///< s; times of equal steps differ by rounding only
constexpr double leastApart = 1.0;    ///< px; a nearer ghost is the circle itself to the eye
constexpr double leastLink = 2.0;     ///< px between the centres that are joined by a line
constexpr double outlineWidth = 1.75; ///< px
constexpr double linkWidth = 1.0;     ///< px
constexpr double leastNamed = 14.0;   ///< px off, so that the word has an outline to itself
constexpr int leastDashes = 8;
constexpr int mostDashes = 48;
constexpr int allDashes = 1200; ///< of all circles together: each is a stroke to draw

/// How a broken outline is drawn.
struct Dashes {
    double period; ///< px along the outline
    double part;   ///< of the period that is drawn
};

Dashes dashesOf(Outline outline)
{
    return outline == Outline::Dashed ? Dashes{9.0, 0.58} : Dashes{5.0, 0.4};
}

/// Where it crosses its own disc it must stand out from it.
QColor ghostColour(const QColor &colour)
{
    return theme().dark ? colour.lighter(135) : colour.darker(135);
}

void addOutline(DrawList &list, const Circle &circle, const QColor &colour, int dashes, double part)
{
    const double period = 2.0 * std::numbers::pi / dashes;
    const auto at = [&](double angle) {
        return circle.position + circle.radius * Vec2{std::cos(angle), std::sin(angle)};
    };
    for (int i = 0; i < dashes; ++i)
        addLineAbove(list, at(i * period), at((i + part) * period), colour, outlineWidth);
}

/// A word beside the outline that is farthest from its circle, if it can be told from that.
void addWord(SceneDraft &draft, std::span<const Circle> circles, std::span<const Circle> ghost,
             const QString &word, const Camera &camera)
{
    std::size_t farthest = 0;
    double apart = 0.0; // m
    for (std::size_t i = 0; i < std::min(circles.size(), ghost.size()); ++i) {
        const double distance = length(circles[i].position - ghost[i].position);
        if (distance > apart) {
            apart = distance;
            farthest = i;
        }
    }
    const double scale = camera.pixelsPerMetre();
    if (word.isEmpty() || apart * scale < leastNamed)
        return;
    const Circle &named = ghost[farthest];
    draft.wishes.push_back(
        {.label = {.anchor = named.position, .text = word, .colour = theme().mutedText},
         .direction = named.position - circles[farthest].position,
         .clearance = named.radius * scale + 3.0});
}

} // namespace

std::vector<Circle> circlesAt(const Recording &recording, double time)
{
    if (recording.isEmpty() || time < recording.time(recording.first()) - timeSlack
        || time > recording.time(recording.last()) + timeSlack)
        return {};
    const qint64 index = recording.indexAt(time);
    const auto frame = recording.circles(index);
    std::vector<Circle> circles(frame.begin(), frame.end());
    if (index == recording.last())
        return circles;
    const double start = recording.time(index);
    const double span = recording.time(index + 1) - start;
    const double part = span > 0.0 ? (time - start) / span : 0.0;
    if (part * span < timeSlack)
        return circles;
    const auto next = recording.circles(index + 1);
    for (std::size_t i = 0; i < circles.size(); ++i)
        circles[i].position += part * (next[i].position - circles[i].position);
    return circles;
}

void addGhost(DrawList &list, std::span<const Circle> circles, std::span<const Circle> ghost,
              const std::vector<QColor> &colours, const Camera &camera, Outline outline)
{
    const Dashes dashes = dashesOf(outline);
    const double scale = camera.pixelsPerMetre();
    const std::size_t count = std::min({circles.size(), ghost.size(), colours.size()});
    const QRectF seen({}, camera.viewport());
    for (std::size_t i = 0; i < count; ++i) {
        const double apart = length(circles[i].position - ghost[i].position) * scale;
        const double radius = ghost[i].radius * scale;
        const QPointF centre = camera.toPixels(ghost[i].position);
        if (apart < leastApart || !seen.adjusted(-radius, -radius, radius, radius).contains(centre))
            continue;
        const QColor colour = ghostColour(colours[i]);
        const int room =
            std::clamp(static_cast<int>(2.0 * std::numbers::pi * radius / dashes.period),
                       leastDashes, mostDashes);
        const int share = allDashes / static_cast<int>(count);
        if (share >= leastDashes)
            addOutline(list, ghost[i], colour, std::min(room, share), dashes.part);
        else
            list.discs.push_back({ghost[i].position, ghost[i].radius, {}, colour, linkWidth});
        const QPointF own = camera.toPixels(circles[i].position);
        if (apart > leastLink && seen.contains(own))
            addLineAbove(list, circles[i].position, ghost[i].position, colour, linkWidth);
    }
}

void addGhosts(SceneDraft &draft, const SceneMoment &moment, const std::vector<QColor> &colours,
               const Camera &camera)
{
    const auto circles = moment.recording.circles(moment.current);
    addGhost(draft.list, circles, moment.exact, colours, camera, Outline::Dotted);
    addGhost(draft.list, circles, moment.ghost, colours, camera);
    addWord(draft, circles, moment.exact, GhostText::tr("exact"), camera);
    addWord(draft, circles, moment.ghost, moment.ghostLabel, camera);
}

} // namespace cradle
