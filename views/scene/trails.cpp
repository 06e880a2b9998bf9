// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/trails.h"

#include "model/world/measurements.h"
#include "views/scene/program_drawings.h"
#include "views/theme.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct TrailText {
    Q_DECLARE_TR_FUNCTIONS(Trails)
};

constexpr double trailOpacity = 0.5;
constexpr double trailOpacityInDark = 0.75; ///< a faded colour is darker there, not paler
constexpr double centreOpacity = 0.7;
constexpr double trailWidth = 2.0;          ///< px
constexpr double centreWidth = 1.5;         ///< px, of its way and its mark
constexpr double centreRadius = 6.0;        ///< px, of its mark
constexpr std::size_t trailSegments = 1000; ///< of all circles together: QPainter draws 80 a ms
constexpr std::size_t longestTrail = 90;    ///< segments
/// Circles that are summed up for the way of their centre; they take about a millisecond.
constexpr std::size_t summedCircles = 200'000;

/// At most about \p most frames of the last \p seconds, oldest first. Their steps are multiples of
/// a stride, so that a trail keeps its shape while it grows.
std::vector<qint64> framesBack(const SceneMoment &moment, double seconds, std::size_t most)
{
    const Recording &recording = moment.recording;
    const qint64 begin = recording.indexAt(recording.time(moment.current) - seconds);
    const qint64 count = moment.current - begin;
    if (count <= 0 || most == 0)
        return {};
    const auto segments = static_cast<qint64>(most);
    const qint64 stride = (count + segments - 1) / segments;
    std::vector<qint64> frames;
    for (qint64 i = (begin + stride - 1) / stride * stride; i < moment.current; i += stride)
        frames.push_back(i);
    frames.push_back(moment.current);
    return frames;
}

/// What is left of a trail that began with \p opacity after the time since frame \p index.
double opacityAt(const SceneMoment &moment, qint64 index, double seconds, double opacity)
{
    const double now = moment.recording.time(moment.current);
    const double age = (now - moment.recording.time(index)) / seconds;
    return opacity * std::clamp(1.0 - age, 0.0, 1.0);
}

void addCentreMark(SceneDraft &draft, Vec2 centre, double pixelsPerMetre)
{
    const double radius = centreRadius / pixelsPerMetre;
    const QColor colour = theme().text;
    draft.list.discs.push_back({centre, radius, faded(theme().scene, 0.6), colour, centreWidth});
    for (const Vec2 arm : {Vec2{radius, 0.0}, Vec2{0.0, radius}})
        addLineAbove(draft.list, centre - arm, centre + arm, colour, centreWidth);
    draft.wishes.push_back({.label = {.anchor = centre,
                                      .text = TrailText::tr("centre of mass"),
                                      .colour = theme().mutedText},
                            .direction = {0.0, 1.0},
                            .clearance = centreRadius + 3.0});
}

} // namespace

void addTrails(DrawList &list, const SceneMoment &moment, const std::vector<QColor> &colours,
               const SceneLook &look)
{
    const bool crowd = moment.preset.circles.size() > crowdSize;
    std::vector<int> drawn;
    for (int i = 0; i < static_cast<int>(colours.size()); ++i) {
        if (!crowd || i == look.selected || i == look.hovered)
            drawn.push_back(i);
    }
    if (drawn.empty())
        return;
    const std::vector<qint64> frames =
        framesBack(moment, trailSeconds, std::min(longestTrail, trailSegments / drawn.size()));
    const double newest = theme().dark ? trailOpacityInDark : trailOpacity;
    for (std::size_t k = 1; k < frames.size(); ++k) {
        const auto from = moment.recording.circles(frames[k - 1]);
        const auto to = moment.recording.circles(frames[k]);
        const double opacity = opacityAt(moment, frames[k], trailSeconds, newest);
        for (const int index : drawn) {
            const auto i = static_cast<std::size_t>(index);
            if (from[i].position == to[i].position)
                continue;
            list.lines.push_back(
                {from[i].position, to[i].position, faded(colours[i], opacity), trailWidth, {}});
        }
    }
}

void addCentreOfMass(SceneDraft &draft, const SceneMoment &moment, double pixelsPerMetre)
{
    const auto circles = moment.recording.circles(moment.current);
    if (circles.empty())
        return;
    const std::size_t most =
        std::clamp(summedCircles / circles.size(), std::size_t{2}, longestTrail);
    const std::vector<qint64> frames = framesBack(moment, centreSeconds, most);
    for (std::size_t k = 1; k < frames.size(); ++k) {
        const Vec2 from = centreOfMass(moment.recording.circles(frames[k - 1]));
        const Vec2 to = centreOfMass(moment.recording.circles(frames[k]));
        const double opacity = opacityAt(moment, frames[k], centreSeconds, centreOpacity);
        if (from != to)
            draft.list.lines.push_back({from, to, faded(theme().text, opacity), centreWidth, {}});
    }
    addCentreMark(draft, centreOfMass(circles), pixelsPerMetre);
}

} // namespace cradle
