// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/hit_parts.h"

#include "views/scene/arrow_lanes.h"
#include "views/scene/handles.h"
#include "views/scene/leaving_arrow.h"
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

constexpr double beforeWidth = 1.25; ///< px: what was is drawn thinner, not paler
constexpr double normalReach = 0.15; ///< of the half width, beyond the disc or the wall
constexpr double normalHead = 8.0;   ///< px
/// What a place costs that lies on two other arrows: there the label of one that leaves the picture
/// would hide more than it tells.
constexpr double coveringCost = 7.5;
constexpr double normalGap = 6.0; ///< px that arrows keep from the normal

// Which labels find a place first; names come after all of them.
constexpr int normalRank = 0;
constexpr int partRank = 1;
constexpr int beforeRank = 2;

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
    QColor opaque = theme().dark ? colour : colour.darker(140);
    opaque.setAlphaF(1.0f);
    QColor readable = readableOn(opaque, theme().scene);
    readable.setAlphaF(colour.alphaF());
    return readable;
}

/// One circle of the hit, where it was then.
struct HitCircle {
    Circle body;
    Vec2 before; ///< velocity, m/s
    Vec2 after;
    QColor colour;
};

/// The arrows of one hit on their way into a draft.
class HitArrows
{
public:
    HitArrows(SceneDraft &draft, ArrowLanes &lanes, const Preset &scene, double opacity,
              const Camera &camera)
        : m_draft(draft)
        , m_lanes(lanes)
        , m_scene(scene)
        , m_opacity(opacity)
        , m_camera(camera)
    {
    }

    void addBefore(const HitCircle &circle)
    {
        addArrow(circle, circle.before, circle.colour, circle.colour, beforeRank,
                 HitText::tr("before %1").arg(speedText(length(circle.before))));
    }

    void addAfter(const HitCircle &circle)
    {
        if (length(circle.after - circle.before) <= smallestPart)
            return;
        const QString text = HitText::tr("after %1").arg(speedText(length(circle.after)));
        if (length(circle.after) > smallestPart) {
            addArrow(circle, circle.after, circle.colour, circle.colour, partRank, text);
            return;
        }
        const QColor colour = textColour(faded(circle.colour, m_opacity));
        m_draft.wishes.push_back(
            {.label = {.anchor = circle.body.position, .text = text, .colour = colour},
             .direction = -circle.before,
             .clearance = circle.body.radius * m_camera.pixelsPerMetre() + 5.0,
             .rank = partRank,
             .clearOfDiscs = true});
    }

    void addPart(const HitCircle &circle, Vec2 part, const QColor &colour, const QString &text)
    {
        addArrow(circle, part, colour, colour, partRank, text.arg(speedText(length(part))));
    }

private:
    void addArrow(const HitCircle &circle, Vec2 velocity, const QColor &colour,
                  const QColor &labelColour, int rank, const QString &text)
    {
        const Stretch place = m_lanes.place(circle.body, arrowTip({}, velocity, m_scene));
        cradle::addArrow(m_draft.list,
                         {.from = place.from,
                          .to = place.to,
                          .colour = faded(colour, m_opacity),
                          .width = rank == beforeRank ? beforeWidth : 2.5,
                          .head = rank == beforeRank ? 9.0 : 12.0},
                         m_camera);
        const Stretch seen = visiblePart(place, m_camera);
        m_draft.wishes.push_back({.label = {.anchor = seen.to,
                                            .text = text,
                                            .colour = textColour(faded(labelColour, m_opacity))},
                                  .direction = velocity,
                                  .clearance = 6.0,
                                  .elsewhere = 0.5 * (seen.from + seen.to),
                                  .rank = rank,
                                  .clearOfDiscs = true});
        if (rank == beforeRank)
            m_draft.wishes.back().mostCost = crampedCost;
        else if (seen.to != place.to)
            m_draft.wishes.back().mostCost = coveringCost;
    }

    SceneDraft &m_draft;
    ArrowLanes &m_lanes;
    const Preset &m_scene;
    double m_opacity;
    const Camera &m_camera;
};

/// The normal as a dashed line from the centre of a through the contact to \p end.
void addNormal(SceneDraft &draft, Vec2 from, Vec2 end, Vec2 normal, double opacity, double scale)
{
    const QColor colour = faded(theme().along, opacity);
    const Vec2 neck = end - (normalHead / scale) * normal;
    draft.list.lines.push_back(
        {.from = from, .to = neck, .colour = colour, .width = 1.5, .dash = {5.0, 4.0}});
    draft.list.arrows.push_back(
        {.from = neck, .to = end, .colour = colour, .width = 1.5, .head = normalHead});
    draft.wishes.push_back({.label = {.anchor = end,
                                      .text = HitText::tr("n", "the normal vector"),
                                      .colour = textColour(colour)},
                            .direction = normal,
                            .clearance = 4.0,
                            .rank = normalRank,
                            .clearOfDiscs = true});
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

std::optional<Vec2> contactOf(const SceneMoment &moment, const Hit &hit)
{
    const std::optional<qint64> frame = frameOf(moment, hit);
    if (!frame || hit.normal == Vec2{})
        return std::nullopt;
    const Circle circle = circleAtHit(moment, *frame, hit, hit.a, hit.afterA);
    return circle.position + circle.radius * hit.normal;
}

void addHitParts(SceneDraft &draft, const SceneMoment &moment, const ShownHit &shown,
                 const Camera &camera)
{
    const double pixelsPerMetre = camera.pixelsPerMetre();
    const Hit &hit = *shown.hit;
    const std::optional<qint64> frame = frameOf(moment, hit);
    if (!frame || hit.normal == Vec2{})
        return;
    const auto circleOf = [&](int index, Vec2 before, Vec2 after) {
        const QString &colour = moment.preset.circles[static_cast<std::size_t>(index)].colour;
        return HitCircle{circleAtHit(moment, *frame, hit, index, after), before, after,
                         circleColour(colour)};
    };
    std::vector<HitCircle> circles{circleOf(hit.a, hit.beforeA, hit.afterA)};
    if (hit.kind == Hit::Kind::Circle)
        circles.push_back(circleOf(hit.b, hit.beforeB, hit.afterB));
    std::vector<Circle> discs;
    for (const HitCircle &circle : circles)
        discs.push_back(circle.body);
    ArrowLanes lanes(discs, pixelsPerMetre);
    HitArrows arrows(draft, lanes, moment.preset, shown.opacity, camera);

    const Circle &last = discs.back();
    const double reach = last.radius + normalReach * moment.preset.halfWidth;
    const Vec2 end = last.position + reach * hit.normal;
    const Circle &first = discs.front();
    lanes.occupy({first.position + first.radius * hit.normal, end}, normalGap);
    // If there is one part only, it lies on the velocity itself and says it all.
    const auto along = [&](const HitCircle &circle) {
        return dot(circle.before, hit.normal) * hit.normal;
    };
    const auto across = [&](const HitCircle &circle) { return circle.before - along(circle); };
    const auto matters = [](Vec2 part) { return length(part) > smallestPart; };
    for (const HitCircle &circle : circles) {
        if (matters(along(circle)) && matters(across(circle)))
            arrows.addBefore(circle);
    }
    for (const HitCircle &circle : circles) {
        if (matters(across(circle)))
            arrows.addPart(circle, across(circle), theme().across, HitText::tr("across %1"));
    }
    // While running the circles' own arrows tell it.
    for (const HitCircle &circle : circles) {
        if (!moment.running)
            arrows.addAfter(circle);
    }
    for (const HitCircle &circle : circles) {
        if (matters(along(circle)))
            arrows.addPart(circle, along(circle), theme().along, HitText::tr("along %1"));
    }
    addNormal(draft, first.position, end, hit.normal, shown.opacity, pixelsPerMetre);
}

} // namespace cradle
