// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/momentum_inset.h"

#include "model/world/measurements.h"
#include "views/scene/free_corner.h"
#include "views/scene/scene_labels.h"
#include "views/theme.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr QSizeF drawingSize{144.0, 78.0};
constexpr double labelAside = 9.0;        ///< px from an arrow to the middle of its label
constexpr double shortestLabelled = 12.0; ///< px of an arrow
constexpr double labelRoom = 17.0;        ///< px that labels stand out from the arrows
constexpr double widestShare = 0.45;      ///< of the viewport, that the frame may take
constexpr double highestShare = 0.5;
constexpr double laneGap = 19.0;     ///< px between arrows that would lie on each other
constexpr double lanesShare = 0.8;   ///< of the room, that lanes may take
constexpr double labelledGap = 15.0; ///< px; nearer ones have no room for labels
constexpr double flat = 0.1; ///< a chain that is less wide than this, of its length, is a line
constexpr double longestBar = 48.0; ///< px
constexpr double scaleSteps = 8.0;  ///< of the scale in a decade, so that it seldom changes

/// An arrow of the chain, in kg m/s.
struct Link {
    Vec2 from{};
    Vec2 to{};
    int circle = -1; ///< −1: the sum
    int lane = 0;
};

std::vector<Link> chainOf(std::span<const Circle> circles)
{
    std::vector<Link> chain;
    Vec2 end;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        const Vec2 momentum = mass(circles[i]) * circles[i].velocity;
        if (momentum != Vec2{})
            chain.push_back({end, end + momentum, static_cast<int>(i)});
        end += momentum;
    }
    if (!chain.empty())
        chain.push_back({{}, end});
    return chain;
}

/// Where all arrows lie in about one line, those that would cover each other get lanes beside it.
/// \return the direction (unit vector) from lane to lane; zero if the arrows need none
Vec2 layLanes(std::vector<Link> &chain)
{
    const auto span = [](const Link &link) { return length(link.to - link.from); };
    const Link &longest =
        *std::max_element(chain.begin(), chain.end(),
                          [&](const Link &x, const Link &y) { return span(x) < span(y); });
    const Vec2 along = normalized(longest.to - longest.from);
    const bool isLine = std::all_of(chain.begin(), chain.end(), [&](const Link &link) {
        return std::abs(cross(along, link.to)) < flat * span(longest);
    });
    if (!isLine)
        return {};
    std::vector<std::pair<double, double>> taken; // of the newest lane
    int lane = 0;
    for (Link &link : chain) {
        const double begin = std::min(dot(along, link.from), dot(along, link.to));
        const double end = std::max(dot(along, link.from), dot(along, link.to));
        const double touch = 1e-6 * span(longest);
        const bool covered = std::any_of(taken.begin(), taken.end(), [&](const auto &other) {
            return begin < other.second - touch && other.first < end - touch;
        });
        if (covered || link.circle < 0) {
            ++lane;
            taken.clear();
        }
        taken.emplace_back(begin, end);
        link.lane = lane;
    }
    const Vec2 aside = perpendicular(along);
    const bool up = aside.y > 1e-9 || (aside.y > -1e-9 && aside.x > 0.0);
    return up ? aside : -aside;
}

double niceBelow(double value)
{
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double digit : {5.0, 2.0}) {
        if (digit * decade <= value)
            return digit * decade;
    }
    return decade;
}

/// Px per kg m/s with which \p chain fits into \p room beside its lanes.
double scaleFor(const std::vector<Link> &chain, Vec2 aside, double gap, QSizeF room)
{
    Vec2 low;
    Vec2 high;
    for (const Link &link : chain) {
        low = {std::min(low.x, link.to.x), std::min(low.y, link.to.y)};
        high = {std::max(high.x, link.to.x), std::max(high.y, link.to.y)};
    }
    const double depth = gap * chain.back().lane;
    const Vec2 size = high - low;
    const double byWidth = (room.width() - std::abs(aside.x) * depth) / size.x;
    const double byHeight = (room.height() - std::abs(aside.y) * depth) / size.y;
    const double largest = std::min(byWidth, byHeight); // infinite along an axis without extent
    return std::pow(10.0, std::floor(scaleSteps * std::log10(largest)) / scaleSteps);
}

QSizeF frameSize(const QFont &font)
{
    const double row = QFontMetricsF(labelFont(font)).height();
    return drawingSize * textScale()
           + QSizeF(2.0 * MomentumInset::padding, 2.0 * MomentumInset::padding + 2.0 * row);
}

/// Labels stand beside the middles of their arrows, away from \p inside.
void placeLabels(MomentumInset &inset, const std::vector<Link> &chain, Vec2 aside, double gap,
                 QPointF inside)
{
    for (std::size_t i = 0; i < inset.arrows.size(); ++i) {
        MomentumInset::Arrow &arrow = inset.arrows[i];
        const QLineF line(arrow.from, arrow.to);
        if (arrow.isSum && line.length() < MomentumInset::shortest) {
            arrow.label = QStringLiteral("Σ = 0");
            arrow.labelAt = arrow.from - QPointF(0.0, labelAside * textScale());
            continue;
        }
        if (line.length() < shortestLabelled
            || (aside != Vec2{} && gap < labelledGap * textScale()))
            continue;
        arrow.label = arrow.isSum ? QStringLiteral("Σ") : QString::number(chain[i].circle + 1);
        QPointF away(aside.x, -aside.y);
        if (aside == Vec2{}) {
            away = QPointF(-line.dy(), line.dx()) / line.length();
            if (QPointF::dotProduct(away, line.center() - inside) < 0.0)
                away = -away;
        }
        arrow.labelAt = line.center() + labelAside * textScale() * away;
    }
}

} // namespace

std::optional<MomentumInset> momentumInset(const SceneMoment &moment, const Camera &camera,
                                           const QFont &font, const std::vector<QRectF> &reserved)
{
    const auto circles = moment.recording.circles(moment.current);
    const QSizeF size = frameSize(font);
    const QSizeF viewport = camera.viewport();
    if (circles.size() < 2 || circles.size() > mostMomenta
        || size.width() > widestShare * viewport.width()
        || size.height() > highestShare * viewport.height())
        return std::nullopt;
    std::vector<Link> chain = chainOf(circles);
    if (chain.empty())
        return std::nullopt;
    const Vec2 aside = layLanes(chain);
    const QSizeF room = drawingSize * textScale()
                        - QSizeF(2.0 * labelRoom * textScale(), 2.0 * labelRoom * textScale());
    const double gap = std::min(laneGap * textScale(),
                                lanesShare * room.height() / std::max(1, chain.back().lane));
    const double scale = scaleFor(chain, aside, gap, room);

    MomentumInset inset;
    inset.frame = freeCorner(moment, camera, size, reserved).frame;
    QPolygonF joints;
    for (const Link &link : chain) {
        const Vec2 shift = (gap * link.lane) * aside;
        const auto pixel = [&](Vec2 momentum) {
            const Vec2 place = scale * momentum + shift;
            return QPointF(place.x, -place.y);
        };
        const bool isSum = link.circle < 0;
        const QColor colour =
            isSum
                ? theme().text
                : circleColour(moment.preset.circles[static_cast<std::size_t>(link.circle)].colour);
        inset.arrows.push_back({pixel(link.from), pixel(link.to), colour, {}, {}, isSum});
        joints << pixel(link.from) << pixel(link.to);
    }
    const double row = QFontMetricsF(labelFont(font)).height();
    const QPointF middle =
        inset.frame.topLeft()
        + QPointF(MomentumInset::padding + drawingSize.width() * textScale() / 2,
                  MomentumInset::padding + row + drawingSize.height() * textScale() / 2);
    const QPointF move = middle - joints.boundingRect().center();
    QPointF inside; // the mean of the ends lies within the chain, however narrow that is
    for (MomentumInset::Arrow &arrow : inset.arrows) {
        arrow.from += move;
        arrow.to += move;
        inside += (arrow.from + arrow.to) / (2.0 * static_cast<double>(chain.size()));
    }
    placeLabels(inset, chain, aside, gap, inside);
    inset.scaleMomentum = niceBelow(longestBar / scale);
    inset.scaleLength = scale * inset.scaleMomentum;
    return inset;
}

} // namespace cradle
