// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

#include <algorithm>
#include <cstdlib>
#include <vector>

/// How alike two pictures are.
namespace cradle::pictures {

/// A channel that is farther off than this (of 255) is not just another shade at an edge.
inline constexpr int visible = 64;

/// How far off two pictures are.
struct Difference {
    double mean = 0.0;     ///< absolute, of all channels, of 255
    int visiblePixels = 0; ///< with a channel that is visibly off
    int greatest = 0;      ///< of any channel, of 255
};

/// \p a and \p b have the same size.
inline Difference compare(const QImage &a, const QImage &b)
{
    qint64 sum = 0;
    Difference found;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            const int red = std::abs(qRed(p) - qRed(q));
            const int green = std::abs(qGreen(p) - qGreen(q));
            const int blue = std::abs(qBlue(p) - qBlue(q));
            sum += red + green + blue;
            const int most = std::max({red, green, blue});
            found.visiblePixels += most > visible;
            found.greatest = std::max(found.greatest, most);
        }
    }
    found.mean = static_cast<double>(sum) / (3.0 * a.width() * a.height());
    return found;
}

/// \p image so coarse that how glyphs are smoothed no longer shows, but whether they are there: an
/// eighth of its size where \p scale pixels are one in width.
inline QImage coarse(const QImage &image, double scale)
{
    return image.scaled(image.size() / (8.0 * scale), Qt::IgnoreAspectRatio,
                        Qt::SmoothTransformation);
}

/// How many different colours \p image shows.
inline int colours(const QImage &image)
{
    std::vector<QRgb> all;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            all.push_back(image.pixel(x, y));
    }
    std::sort(all.begin(), all.end());
    return static_cast<int>(std::unique(all.begin(), all.end()) - all.begin());
}

} // namespace cradle::pictures
