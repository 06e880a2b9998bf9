// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/disc_stamps.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr std::size_t mostLooks = 16;
constexpr double largestRadius = 24.0; ///< px; a larger disc is mostly inside, which costs the same

} // namespace

void paintDisc(QPainter &painter, const DrawList::Disc &disc, QPointF centre, double radius)
{
    painter.setPen(disc.outlineWidth > 0.0 ? QPen(disc.outline, disc.outlineWidth)
                                           : QPen(Qt::NoPen));
    painter.setBrush(disc.fill.isValid() ? QBrush(disc.fill) : QBrush(Qt::NoBrush));
    painter.drawEllipse(centre, radius, radius);
}

DiscStamps::Stamp *DiscStamps::stampFor(const Look &look)
{
    if (m_last < m_stamps.size() && m_stamps[m_last].look == look)
        return &m_stamps[m_last];
    const auto found = std::find_if(m_stamps.begin(), m_stamps.end(),
                                    [&look](const Stamp &stamp) { return stamp.look == look; });
    if (found == m_stamps.end() && m_stamps.size() == mostLooks)
        return nullptr;
    m_last = static_cast<std::size_t>(found - m_stamps.begin());
    if (found == m_stamps.end())
        m_stamps.push_back({.look = look});
    return &m_stamps[m_last];
}

bool DiscStamps::stamp(QPainter &painter, const DrawList::Disc &disc, QPointF centre, double radius)
{
    if (radius > largestRadius || !disc.fill.isValid())
        return false;
    Stamp *found = stampFor({disc.fill.rgba(), disc.outline.rgba(), disc.outlineWidth, radius});
    if (!found)
        return false;
    // In pixels of the device, where an image lands without being resampled.
    const double dpr = painter.device()->devicePixelRatioF();
    const auto place = [dpr](double pixels) { return std::lround(pixels * dpr * phases); };
    const long x = place(centre.x());
    const long y = place(centre.y());
    const auto phaseOf = [](long quarters) { return ((quarters % phases) + phases) % phases; };
    const long phaseX = phaseOf(x);
    const long phaseY = phaseOf(y);
    const int reach = static_cast<int>(std::ceil((radius + disc.outlineWidth) * dpr)) + 1;
    QImage &image = found->images[static_cast<std::size_t>(phaseY * phases + phaseX)];
    if (image.isNull()) {
        image = QImage(2 * reach + 1, 2 * reach + 1, QImage::Format_ARGB32_Premultiplied);
        image.setDevicePixelRatio(dpr);
        image.fill(Qt::transparent);
        QPainter inside(&image);
        inside.setRenderHint(QPainter::Antialiasing);
        const QPointF middle(reach + static_cast<double>(phaseX) / phases,
                             reach + static_cast<double>(phaseY) / phases);
        paintDisc(inside, disc, middle / dpr, radius);
    }
    const long left = (x - phaseX) / phases - reach;
    const long top = (y - phaseY) / phases - reach;
    painter.drawImage(QPointF(static_cast<double>(left), static_cast<double>(top)) / dpr, image);
    return true;
}

} // namespace cradle
