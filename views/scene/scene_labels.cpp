// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/scene_labels.h"

#include "views/scene/slab_clip.h"

#include <QFontInfo>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace cradle {

namespace {

/// Annotations are a little smaller than the text of the window, but never too small to read.
constexpr double relativeSize = 0.92;
constexpr int smallestSize = 11; ///< px

// What a place costs: leaving the viewport is worst, turning away is best.
constexpr double outsideCost = 40.0;
constexpr double discCost = 10.0;
constexpr double shaftCost = 4.0;
constexpr double turnCost = 0.5;      ///< per eighth of a turn
constexpr double distanceCost = 1.5;  ///< per ring further away
constexpr double elsewhereCost = 3.0; ///< at the other anchor

/// Turns from the preferred direction, in eighths, in the order they are tried.
constexpr int eighths[] = {0, 1, -1, 2, -2, 3, -3, 4};
constexpr int rings = 3;

/// Whether a part of \p line lies in \p rect.
bool crosses(const QLineF &line, const QRectF &rect)
{
    return partInside({line.x1(), line.y1()}, {line.dx(), line.dy()}, {rect.left(), rect.top()},
                      {rect.right(), rect.bottom()})
        .has_value();
}

} // namespace

QFont labelFont(const QFont &base, bool strong)
{
    QFont font = base;
    const int size = QFontInfo(base).pixelSize();
    font.setPixelSize(std::max(smallestSize, static_cast<int>(std::lround(relativeSize * size))));
    font.setWeight(strong ? QFont::DemiBold : QFont::Normal);
    return font;
}

QRectF labelRect(const DrawList::Label &label, const Camera &camera, const QFontMetricsF &metrics)
{
    const QSizeF size(metrics.horizontalAdvance(label.text), metrics.height());
    QPointF corner = camera.toPixels(label.anchor) + label.offset;
    if (label.alignment & Qt::AlignRight)
        corner.rx() -= size.width();
    else if (label.alignment & Qt::AlignHCenter)
        corner.rx() -= size.width() / 2;
    if (label.alignment & Qt::AlignBottom)
        corner.ry() -= size.height();
    else if (label.alignment & Qt::AlignVCenter)
        corner.ry() -= size.height() / 2;
    return {corner, size};
}

SceneLabels::SceneLabels(DrawList &list, const Camera &camera, const QFont &base,
                         const std::vector<QRectF> &reserved)
    : m_list(list)
    , m_camera(camera)
    , m_metrics(labelFont(base))
    , m_strongMetrics(labelFont(base, true))
    , m_taken(reserved)
{
    for (const DrawList::Disc &disc : list.discs) {
        const double r = disc.radius * camera.pixelsPerMetre();
        m_discs.push_back({camera.toPixels(disc.centre), r});
    }
    for (const DrawList::Line &line : list.lines) {
        if (line.dash != DrawList::Dash{})
            m_shafts.emplace_back(camera.toPixels(line.from), camera.toPixels(line.to));
    }
    for (const DrawList::Arrow &arrow : list.arrows)
        m_shafts.emplace_back(camera.toPixels(arrow.from), camera.toPixels(arrow.to));
}

bool SceneLabels::placeThere(const DrawList::Label &label)
{
    // Figures have no descenders: discs that touch may both show their number.
    const double spare = label.plate ? 0.0 : 0.15 * m_metrics.height();
    const QRectF rect = labelRect(label, m_camera, label.strong ? m_strongMetrics : m_metrics)
                            .adjusted(0.0, spare, 0.0, -spare);
    if (coversText(rect))
        return false;
    m_taken.push_back(rect);
    m_list.labels.push_back(label);
    return true;
}

bool SceneLabels::placeBeside(const LabelWish &wish)
{
    DrawList::Label label = wish.label;
    const QFontMetricsF &metrics = label.strong ? m_strongMetrics : m_metrics;
    label.alignment = Qt::AlignCenter;
    std::optional<DrawList::Label> best;
    double bestCost = std::numeric_limits<double>::infinity();
    const auto tryBeside = [&](Vec2 anchor, double preferred, double handicap) {
        label.anchor = anchor;
        label.offset = {};
        const QRectF centred = labelRect(label, m_camera, metrics);
        for (int ring = 0; ring < rings; ++ring) {
            for (const int turn : eighths) {
                const double angle = preferred + turn * std::numbers::pi / 4.0;
                const double reach = wish.clearance + ring * 0.8 * centred.height();
                const QPointF offset(std::cos(angle) * (reach + centred.width() / 2),
                                     std::sin(angle) * (reach + centred.height() / 2));
                const QRectF rect = centred.translated(offset);
                const double price =
                    handicap + cost(rect) + std::abs(turn) * turnCost + ring * distanceCost;
                if (price >= bestCost || price > wish.mostCost || coversText(rect)
                    || (wish.clearOfDiscs && discsUnder(rect) > 0))
                    continue;
                bestCost = price;
                label.offset = offset;
                best = label;
            }
        }
    };
    const double preferred = std::atan2(-wish.direction.y, wish.direction.x);
    tryBeside(wish.label.anchor, preferred, 0.0);
    // Beside a shaft, not on it.
    if (wish.elsewhere)
        tryBeside(*wish.elsewhere, preferred + std::numbers::pi / 2.0, elsewhereCost);
    if (!best)
        return false;
    m_taken.push_back(labelRect(*best, m_camera, metrics));
    m_list.labels.push_back(*std::move(best));
    return true;
}

bool SceneLabels::coversText(const QRectF &rect) const
{
    const QRectF room = rect.adjusted(-2.0, 0.0, 2.0, 0.0);
    return std::any_of(m_taken.begin(), m_taken.end(),
                       [&](const QRectF &taken) { return taken.intersects(room); });
}

int SceneLabels::discsUnder(const QRectF &rect) const
{
    return static_cast<int>(
        std::count_if(m_discs.begin(), m_discs.end(), [&](const PixelDisc &disc) {
            const QPointF nearest(std::clamp(disc.centre.x(), rect.left(), rect.right()),
                                  std::clamp(disc.centre.y(), rect.top(), rect.bottom()));
            const QPointF apart = nearest - disc.centre;
            return std::hypot(apart.x(), apart.y()) < disc.radius;
        }));
}

double SceneLabels::cost(const QRectF &rect) const
{
    double sum = 0.0;
    if (!QRectF({}, m_camera.viewport()).contains(rect))
        sum += outsideCost;
    sum += discCost * discsUnder(rect);
    for (const QLineF &shaft : m_shafts)
        sum += crosses(shaft, rect) ? shaftCost : 0.0;
    return sum;
}

} // namespace cradle
