// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/camera.h"

#include <algorithm>

namespace cradle {

namespace {

/// Extents that can be zoomed to, in half widths: from a fiftieth of the square to twenty squares.
constexpr double smallestExtent = 0.04;
constexpr double largestExtent = 40.0;

/// How far from the origin the centre of the view can go, in half widths.
constexpr double farthestCentre = 3.0;

} // namespace

void Camera::fit(double halfWidth)
{
    m_halfWidth = halfWidth;
    m_centre = {};
    m_extent = extentPerHalfWidth * halfWidth;
}

void Camera::resize(QSizeF viewport)
{
    m_viewport = viewport.expandedTo(QSizeF(1.0, 1.0));
}

void Camera::zoomAbout(QPointF pixel, double factor)
{
    const Vec2 held = toMetres(pixel);
    m_extent =
        std::clamp(m_extent / factor, smallestExtent * m_halfWidth, largestExtent * m_halfWidth);
    m_centre += held - toMetres(pixel);
    keepInReach();
}

void Camera::panBy(QPointF pixels)
{
    const double scale = pixelsPerMetre();
    m_centre += Vec2{-pixels.x() / scale, pixels.y() / scale};
    keepInReach();
}

QPointF Camera::toPixels(Vec2 metres) const
{
    const double scale = pixelsPerMetre();
    return middle() + QPointF((metres.x - m_centre.x) * scale, (m_centre.y - metres.y) * scale);
}

Vec2 Camera::toMetres(QPointF pixel) const
{
    const double scale = pixelsPerMetre();
    const QPointF fromMiddle = pixel - middle();
    return m_centre + Vec2{fromMiddle.x() / scale, -fromMiddle.y() / scale};
}

double Camera::pixelsPerMetre() const
{
    return std::min(m_viewport.width(), m_viewport.height()) / m_extent;
}

void Camera::keepInReach()
{
    const double bound = farthestCentre * m_halfWidth;
    m_centre = {std::clamp(m_centre.x, -bound, bound), std::clamp(m_centre.y, -bound, bound)};
}

} // namespace cradle
