// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/momentum_inset.h"

#include "views/scene/scene_labels.h"
#include "views/theme.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

struct InsetText {
    Q_DECLARE_TR_FUNCTIONS(MomentumInset)
};

constexpr double frameOpacity = 0.9;
constexpr double frameRounding = 4.0;   ///< px
constexpr double shaftWidth = 2.5;      ///< px
constexpr double insetHeadLength = 9.0; ///< px

void paintArrow(QPainter &painter, const MomentumInset::Arrow &arrow)
{
    const QLineF line(arrow.from, arrow.to);
    const double whole = line.length();
    painter.setPen(Qt::NoPen);
    painter.setBrush(arrow.colour);
    if (whole < MomentumInset::shortest) {
        painter.drawEllipse(arrow.from, shaftWidth, shaftWidth);
        return;
    }
    const double head = std::min(insetHeadLength, whole);
    const double shaft = shaftWidth / 2;
    const double barb = head * arrowHeadAspect / 2;
    const QPolygonF outline{{0.0, -shaft}, {whole - head, -shaft}, {whole - head, -barb},
                            {whole, 0.0},  {whole - head, barb},   {whole - head, shaft},
                            {0.0, shaft}};
    painter.drawPolygon(
        QTransform().translate(line.x1(), line.y1()).rotate(-line.angle()).map(outline));
}

} // namespace

void paintInset(QPainter &painter, const MomentumInset &inset, const QFont &font)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QColor ground = theme().panel;
    ground.setAlphaF(static_cast<float>(frameOpacity));
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(inset.frame, frameRounding, frameRounding);

    const QFont plain = labelFont(font);
    const QFontMetricsF metrics(plain);
    const QRectF inner = inset.frame.adjusted(MomentumInset::padding, MomentumInset::padding,
                                              -MomentumInset::padding, -MomentumInset::padding);
    painter.setFont(plain);
    painter.setPen(theme().mutedText);
    painter.drawText(inner, Qt::AlignTop | Qt::AlignLeft, InsetText::tr("Momentum"));
    const QString scale =
        InsetText::tr("%1 kg m/s").arg(QString::number(inset.scaleMomentum, 'g', 6));
    painter.drawText(inner, Qt::AlignBottom | Qt::AlignRight, scale);
    const double y = std::round(inner.bottom() - metrics.height() / 2) + 0.5;
    const double end = std::round(inner.right() - metrics.horizontalAdvance(scale) - 6.0) + 0.5;
    const double begin = end - inset.scaleLength;
    painter.setPen(QPen(theme().mutedText, 1.0));
    painter.drawLine(QPointF(begin, y), QPointF(end, y));
    for (const double x : {begin, end})
        painter.drawLine(QPointF(x, y - 3.0), QPointF(x, y + 3.0));

    for (const MomentumInset::Arrow &arrow : inset.arrows) {
        paintArrow(painter, arrow);
        if (arrow.label.isEmpty())
            continue;
        painter.setFont(labelFont(font, true));
        painter.setPen(arrow.isSum ? arrow.colour : readableOn(arrow.colour, theme().panel));
        painter.drawText(QRectF(arrow.labelAt - QPointF(20.0, 10.0), QSizeF(40.0, 20.0)),
                         Qt::AlignCenter, arrow.label);
    }
    painter.restore();
}

} // namespace cradle
