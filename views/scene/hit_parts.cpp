// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/hit_parts.h"

#include "views/scene/handles.h"
#include "views/theme.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct HitText {
    Q_DECLARE_TR_FUNCTIONS(HitParts)
};

constexpr std::size_t mostShown = 6; ///< more would cover each other

/// Slower parts would be dots; m/s in the usual square.
constexpr double smallestPart = 0.005;

constexpr double beforeOpacity = 0.4;
constexpr double normalReach = 0.15; ///< of the half width, beyond the discs

/// The frame at whose end \p hit shows, if it is kept.
std::optional<qint64> frameOf(const SceneMoment &moment, const Hit &hit)
{
    const qint64 index = moment.current - (moment.recording.step(moment.current) - hit.step);
    if (index < moment.recording.first() || index > moment.recording.last())
        return std::nullopt;
    return index;
}

/// Circle \p index where it was hit: from the end of the step back along its new velocity.
Circle circleAtHit(const SceneMoment &moment, qint64 frame, const Hit &hit, int index, Vec2 after)
{
    Circle circle = moment.recording.circles(frame)[static_cast<std::size_t>(index)];
    circle.position -= (moment.recording.time(frame) - hit.time) * after;
    return circle;
}

QString speedText(double speed)
{
    return QString::number(speed, 'f', 2);
}

/// Text needs more contrast than arrows do.
QColor textColour(const QColor &colour)
{
    return theme().dark ? colour : colour.darker(140);
}

void addPart(SceneDraft &draft, Vec2 from, Vec2 part, double halfWidth, const QColor &colour,
             const QString &text)
{
    const Vec2 tip = arrowTip(from, part, halfWidth);
    draft.list.arrows.push_back(
        {.from = from, .to = tip, .colour = colour, .width = 2.5, .head = 12.0});
    draft.wishes.push_back({.label = {.anchor = tip, .text = text, .colour = textColour(colour)},
                            .direction = part,
                            .clearance = 6.0});
}

void addSplitVelocity(SceneDraft &draft, const SceneMoment &moment, const Circle &circle,
                      Vec2 before, Vec2 normal, const QColor &colour, double opacity)
{
    const double halfWidth = moment.preset.halfWidth;
    const Vec2 along = dot(before, normal) * normal;
    const Vec2 across = before - along;
    const bool hasAlong = length(along) > smallestPart;
    const bool hasAcross = length(across) > smallestPart;
    // If there is one part only, it lies on the velocity itself and says it all.
    if (hasAlong && hasAcross) {
        addPart(draft, circle.position, before, halfWidth, faded(colour, beforeOpacity * opacity),
                HitText::tr("before %1").arg(speedText(length(before))));
        draft.wishes.back().label.colour = textColour(faded(colour, opacity));
    }
    if (hasAlong)
        addPart(draft, circle.position, along, halfWidth, faded(theme().along, opacity),
                HitText::tr("along %1").arg(speedText(length(along))));
    if (hasAcross)
        addPart(draft, circle.position, across, halfWidth, faded(theme().across, opacity),
                HitText::tr("across %1").arg(speedText(length(across))));
}

bool samePair(const Hit &x, const Hit &y)
{
    return x.kind == y.kind && x.a == y.a && x.b == y.b;
}

} // namespace

std::vector<ShownHit> shownHits(const SceneMoment &moment, int selected)
{
    const auto &hits = moment.recording.hits();
    const qint64 step = moment.recording.step(moment.current);
    const double time = moment.recording.time(moment.current);
    const bool crowd = moment.preset.circles.size() > crowdSize;
    std::vector<ShownHit> shown;
    auto next = std::upper_bound(hits.begin(), hits.end(), step,
                                 [](qint64 s, const Hit &hit) { return s < hit.step; });
    while (next != hits.begin() && shown.size() < mostShown) {
        const Hit &hit = *--next;
        if (moment.running ? time - hit.time >= hitSeconds : hit.step != step)
            break;
        const bool concerns =
            hit.a == selected || (hit.kind == Hit::Kind::Circle && hit.b == selected);
        if (crowd && !concerns)
            continue;
        if (std::any_of(shown.begin(), shown.end(),
                        [&](const ShownHit &other) { return samePair(*other.hit, hit); }))
            continue;
        shown.push_back({&hit, moment.running ? 1.0 - (time - hit.time) / hitSeconds : 1.0});
    }
    return shown;
}

void addHitParts(SceneDraft &draft, const SceneMoment &moment, const ShownHit &shown)
{
    const Hit &hit = *shown.hit;
    const std::optional<qint64> frame = frameOf(moment, hit);
    if (!frame || hit.normal == Vec2{})
        return;
    const auto colour = [&](int index) {
        return circleColour(moment.preset.circles[static_cast<std::size_t>(index)].colour);
    };
    const double reach = normalReach * moment.preset.halfWidth;
    const Circle a = circleAtHit(moment, *frame, hit, hit.a, hit.afterA);
    const Vec2 start = a.position - (a.radius + reach) * hit.normal;
    Vec2 end = a.position + (a.radius + reach) * hit.normal;
    if (hit.kind == Hit::Kind::Circle) {
        const Circle b = circleAtHit(moment, *frame, hit, hit.b, hit.afterB);
        end = b.position + (b.radius + reach) * hit.normal;
        addSplitVelocity(draft, moment, b, hit.beforeB, hit.normal, colour(hit.b), shown.opacity);
    }
    const QColor normalColour = faded(theme().along, shown.opacity);
    draft.list.lines.push_back(
        {.from = start, .to = end, .colour = normalColour, .width = 1.5, .dash = {5.0, 4.0}});
    draft.wishes.push_back({.label = {.anchor = start,
                                      .text = HitText::tr("n", "the normal vector"),
                                      .colour = textColour(normalColour)},
                            .direction = -hit.normal,
                            .clearance = 4.0});
    addSplitVelocity(draft, moment, a, hit.beforeA, hit.normal, colour(hit.a), shown.opacity);
}

} // namespace cradle
