// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"

#include <QPointF>
#include <QSizeF>

namespace cradle {

/// Where the scene is looked at from: maps metres (y up) to logical pixels (y down). A plain
/// value; a smaller or larger viewport shows the same part of the scene.
class Camera
{
public:
    /// Metres that the shorter side of the viewport shows after fit(), per half width of the
    /// square: a quarter of the half width stays free on each side.
    static constexpr double extentPerHalfWidth = 2.5;

    /// Shows the whole square of \p halfWidth (m), centred.
    void fit(double halfWidth);
    void resize(QSizeF viewport); ///< px
    /// Makes things \p factor times as large; the place under \p pixel stays there.
    void zoomAbout(QPointF pixel, double factor);
    /// Moves the scene by \p pixels, as far as the square stays within reach.
    void panBy(QPointF pixels);
    /// Looks \p metres farther, however far that is.
    void moveBy(Vec2 metres) { m_centre += metres; }

    [[nodiscard]] QPointF toPixels(Vec2 metres) const;
    [[nodiscard]] Vec2 toMetres(QPointF pixel) const;
    [[nodiscard]] double pixelsPerMetre() const;
    [[nodiscard]] QSizeF viewport() const { return m_viewport; }
    [[nodiscard]] Vec2 centre() const { return m_centre; }        ///< m
    [[nodiscard]] double extent() const { return m_extent; }      ///< m on the shorter side
    [[nodiscard]] double fittedTo() const { return m_halfWidth; } ///< m
    [[nodiscard]] QPointF middle() const
    {
        return {m_viewport.width() / 2, m_viewport.height() / 2};
    }

    friend bool operator==(const Camera &, const Camera &) = default;

private:
    void keepInReach();

    QSizeF m_viewport{700.0, 700.0};
    Vec2 m_centre{};
    double m_halfWidth = 4.0;
    double m_extent = extentPerHalfWidth * 4.0;
};

} // namespace cradle
