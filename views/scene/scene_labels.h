// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/camera.h"
#include "views/scene/scene_draft.h"

#include <QFont>
#include <QFontMetricsF>
#include <QLineF>
#include <QRectF>

namespace cradle {

/// The font of labels in a scene whose widget has \p base.
[[nodiscard]] QFont labelFont(const QFont &base, bool strong = false);

/// The rectangle (px) that \p label covers.
[[nodiscard]] QRectF labelRect(const DrawList::Label &label, const Camera &camera,
                               const QFontMetricsF &metrics);

/// Finds places for labels beside what they name: never over another text, if possible not over
/// discs and arrows, and inside the viewport.
class SceneLabels
{
public:
    /// \param list  receives the labels; its discs and arrows are what labels avoid, so they
    ///     must be complete
    /// \param reserved  rectangles (px) that labels must not cover either
    SceneLabels(DrawList &list, const Camera &camera, const QFont &base,
                const std::vector<QRectF> &reserved = {});

    /// Puts \p label where its offset says, or not at all. \return whether it was put
    bool placeThere(const DrawList::Label &label);
    /// Puts the label of \p wish beside its anchor, preferably towards its direction, else turned
    /// away from that as little as needed, else beside its other anchor.
    /// \return false if every place would cover what it must not: then the label is left out
    bool placeBeside(const LabelWish &wish);

private:
    struct PixelDisc {
        QPointF centre; ///< px
        double radius;  ///< px
    };

    [[nodiscard]] bool coversText(const QRectF &rect) const;
    [[nodiscard]] int discsUnder(const QRectF &rect) const;
    [[nodiscard]] double cost(const QRectF &rect) const;

    DrawList &m_list;
    const Camera &m_camera;
    QFontMetricsF m_metrics;
    QFontMetricsF m_strongMetrics;
    std::vector<QRectF> m_taken;
    std::vector<PixelDisc> m_discs;
    std::vector<QLineF> m_shafts;
};

} // namespace cradle
