// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace cradle {

/// A drawing as SVG (of 1.1 what every viewer and Qt read: no clips), without any window system.
/// Places are in px from the top left, colours "#rrggbb".
class SvgPicture
{
public:
    /// How a line is drawn.
    struct Pen {
        QString colour{};
        double width = 1.0; ///< px
        QString dash{};     ///< "4 3": px drawn and left out; empty: solid
        double opacity = 1.0;
    };
    enum class Anchor { Start, Middle, End };

    /// \param title  what the drawing shows, for who cannot see it
    SvgPicture(double width, double height, const QString &title);

    void rectangle(Vec2 corner, Vec2 size, const QString &fill, const Pen &edge);
    void circle(Vec2 centre, double radius, const QString &fill, const Pen &edge);
    void line(Vec2 from, Vec2 to, const Pen &pen);
    void polyline(const std::vector<Vec2> &points, const Pen &pen);
    void arrow(Vec2 from, Vec2 to, const QString &colour);
    /// \param baseline  the place of the text's start, middle or end
    void text(Vec2 baseline, const QString &text, double size, const QString &colour,
              Anchor anchor = Anchor::Start);
    [[nodiscard]] QByteArray toSvg() const;

private:
    QString m_body{};
    QString m_title;
    double m_width;
    double m_height;
};

} // namespace cradle
