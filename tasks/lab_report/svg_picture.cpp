// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/svg_picture.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr double headLength = 7.0; ///< px
constexpr double headWidth = 5.5;  ///< px

/// A hundredth of a pixel is finer than any printer.
QString px(double value)
{
    if (!std::isfinite(value))
        value = 0.0;
    QString text = QString::number(std::clamp(value, -1e5, 1e5), 'f', 2);
    while (text.endsWith(QLatin1Char('0')))
        text.chop(1);
    if (text.endsWith(QLatin1Char('.')))
        text.chop(1);
    return text == QLatin1String("-0") ? QStringLiteral("0") : text;
}

QString strokeOf(const SvgPicture::Pen &pen)
{
    if (pen.colour.isEmpty())
        return QStringLiteral(" stroke=\"none\"");
    QString stroke =
        QStringLiteral(" stroke=\"%1\" stroke-width=\"%2\"").arg(pen.colour, px(pen.width));
    if (!pen.dash.isEmpty())
        stroke += QStringLiteral(" stroke-dasharray=\"%1\"").arg(pen.dash);
    if (pen.opacity < 1.0)
        stroke += QStringLiteral(" stroke-opacity=\"%1\"").arg(px(pen.opacity));
    return stroke;
}

QString fillOf(const QString &fill)
{
    return QStringLiteral(" fill=\"%1\"").arg(fill.isEmpty() ? QStringLiteral("none") : fill);
}

} // namespace

SvgPicture::SvgPicture(double width, double height, const QString &title)
    : m_title(title)
    , m_width(width)
    , m_height(height)
{
}

void SvgPicture::rectangle(Vec2 corner, Vec2 size, const QString &fill, const Pen &edge)
{
    m_body +=
        QStringLiteral("<rect x=\"%1\" y=\"%2\" width=\"%3\" height=\"%4\"%5%6/>\n")
            .arg(px(corner.x), px(corner.y), px(size.x), px(size.y), fillOf(fill), strokeOf(edge));
}

void SvgPicture::circle(Vec2 centre, double radius, const QString &fill, const Pen &edge)
{
    m_body += QStringLiteral("<circle cx=\"%1\" cy=\"%2\" r=\"%3\"%4%5/>\n")
                  .arg(px(centre.x), px(centre.y), px(radius), fillOf(fill), strokeOf(edge));
}

void SvgPicture::line(Vec2 from, Vec2 to, const Pen &pen)
{
    polyline({from, to}, pen);
}

void SvgPicture::polyline(const std::vector<Vec2> &points, const Pen &pen)
{
    // What rests has no way: a line of no length is a broken path in a PDF.
    QStringList places;
    for (const Vec2 &point : points) {
        const QString place = px(point.x) + QLatin1Char(',') + px(point.y);
        if (places.isEmpty() || places.last() != place)
            places.append(place);
    }
    if (places.size() < 2)
        return;
    m_body +=
        QStringLiteral("<polyline points=\"%1\" fill=\"none\" stroke-linejoin=\"round\"%2/>\n")
            .arg(places.join(QLatin1Char(' ')), strokeOf(pen));
}

void SvgPicture::arrow(Vec2 from, Vec2 to, const QString &colour)
{
    const Vec2 way = to - from;
    const double length = std::hypot(way.x, way.y);
    if (!(length > 1.0))
        return;
    const Vec2 along = way / length;
    const Vec2 across{-along.y, along.x};
    const double head = std::min(headLength, length);
    const Vec2 neck = to - along * head;
    line(from, neck, {colour, 1.6});
    const Vec2 side = across * (0.5 * headWidth * head / headLength);
    const Vec2 left = neck + side;
    const Vec2 right = neck - side;
    m_body +=
        QStringLiteral("<polygon points=\"%1,%2 %3,%4 %5,%6\" fill=\"%7\"/>\n")
            .arg(px(to.x), px(to.y), px(left.x), px(left.y), px(right.x), px(right.y), colour);
}

void SvgPicture::text(Vec2 baseline, const QString &text, double size, const QString &colour,
                      Anchor anchor)
{
    static const QString anchors[] = {QStringLiteral("start"), QStringLiteral("middle"),
                                      QStringLiteral("end")};
    // Of the font of the page that it stands in.
    m_body += QStringLiteral("<text x=\"%1\" y=\"%2\" font-size=\"%3\" fill=\"%4\" "
                             "text-anchor=\"%5\">%6</text>\n")
                  .arg(px(baseline.x), px(baseline.y), px(size), colour,
                       anchors[static_cast<int>(anchor)], text.toHtmlEscaped());
}

QByteArray SvgPicture::toSvg() const
{
    return QStringLiteral("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%1\" height=\"%2\" "
                          "viewBox=\"0 0 %1 %2\" role=\"img\">\n<title>%3</title>\n%4</svg>\n")
        .arg(px(m_width), px(m_height), m_title.toHtmlEscaped(), m_body)
        .toUtf8();
}

} // namespace cradle
