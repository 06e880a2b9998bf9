// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/scene_picture.h"

#include "views/scene/raster_painter.h"
#include "views/scene/scene_labels.h"
#include "views/text_direction.h"
#include "views/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr double margin = 8.0;   ///< px between chips and the edge of the scene
constexpr double rowGap = 4.0;   ///< px between chips in one corner
constexpr double rounding = 4.0; ///< px
constexpr QSizeF padding{8.0, 4.0};
constexpr double widestChip = 480.0;
constexpr double widestDetail = 280.0;
constexpr double fromPointer = 16.0;
constexpr double lowPointer = 0.7; ///< of the height
constexpr double chipOpacity = 0.92;
constexpr double bandOpacity = 0.12;
constexpr int textFlags = Qt::AlignCenter | Qt::TextWordWrap;

/// Values are read as numbers, the rest as text.
QFont chipFont(const Chip &chip, const QFont &base)
{
    QFont font = labelFont(base);
    if (chip.place == Chip::Place::Pointer) {
        font.setFamilies({QStringLiteral("JetBrains Mono"), QStringLiteral("monospace")});
        font.setStyleHint(QFont::Monospace);
    }
    return font;
}

void paintChip(QPainter &painter, const Chip &chip, const ScenePicture &picture)
{
    const QRectF rect = chipRect(chip, picture.camera.viewport(), picture.font);
    const Theme &colours = theme();
    const bool value = chip.place == Chip::Place::Pointer;
    QColor ground = chip.warning ? colours.warningSoft : colours.panel;
    ground.setAlphaF(chip.warning ? 1.0f : static_cast<float>(chipOpacity));
    QPen frame(Qt::NoPen);
    if (chip.warning || value)
        frame = QPen(chip.warning ? colours.warningBorder : colours.border, 1.0);
    painter.setPen(frame);
    painter.setBrush(ground);
    painter.drawRoundedRect(rect, rounding, rounding);
    const QColor quiet = value ? colours.text : colours.mutedText;
    painter.setPen(chip.warning ? colours.warning : quiet);
    painter.setFont(chipFont(chip, picture.font));
    const QRectF inner =
        rect.adjusted(padding.width(), padding.height(), -padding.width(), -padding.height());
    painter.setLayoutDirection(directionOf(chip.text));
    if (chip.detail.isEmpty()) {
        painter.drawText(inner, textFlags, chip.text);
        return;
    }
    painter.drawText(inner, Qt::AlignTop | Qt::AlignLeft, chip.text);
    painter.setFont(labelFont(picture.font));
    painter.drawText(inner, Qt::AlignBottom | Qt::AlignLeft | Qt::TextWordWrap, chip.detail);
}

QSizeF textSize(const QString &text, const QFont &font, double room)
{
    if (text.isEmpty())
        return {0.0, 0.0};
    return QFontMetricsF(font).boundingRect(QRectF(0.0, 0.0, room, 1000.0), textFlags, text).size();
}

void paintBand(QPainter &painter, const QRectF &band)
{
    QColor ground = theme().accent;
    ground.setAlphaF(static_cast<float>(bandOpacity));
    painter.setPen(QPen(theme().accent, 1.0, Qt::DashLine));
    painter.setBrush(ground);
    painter.drawRect(QRectF(band.toAlignedRect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

} // namespace

QRectF chipRect(const Chip &chip, QSizeF viewport, const QFont &font)
{
    const double room =
        std::max(std::min(widestChip, viewport.width() - 2 * (margin + padding.width())), 40.0);
    const QSizeF text = textSize(chip.text, chipFont(chip, font), room);
    const QSizeF detail = textSize(chip.detail, labelFont(font), std::min(room, widestDetail));
    // Half pixels at the corner make the frame sharp.
    const QSizeF size(std::ceil(std::max(text.width(), detail.width())) + 2 * padding.width() + 2.0,
                      std::ceil(text.height()) + std::ceil(detail.height()) + 2 * padding.height());
    QPointF corner;
    switch (chip.place) {
    case Chip::Place::TopRight:
        corner = {viewport.width() - margin - size.width(),
                  margin + chip.row * (size.height() + rowGap)};
        break;
    case Chip::Place::Bottom:
        corner = {(viewport.width() - size.width()) / 2,
                  viewport.height() - margin - size.height()};
        // Not where the pointer is, whose value it would cover.
        if (chip.pointer.y() > lowPointer * viewport.height())
            corner.ry() = margin;
        break;
    case Chip::Place::Centre:
        corner = {(viewport.width() - size.width()) / 2, (viewport.height() - size.height()) / 2};
        break;
    case Chip::Place::Pointer:
        corner = chip.pointer + QPointF(fromPointer, -fromPointer - size.height());
        corner.rx() = std::clamp(corner.x(), margin,
                                 std::max(viewport.width() - margin - size.width(), margin));
        // Above the pointer; below it where there is no room above.
        if (corner.y() < margin)
            corner.ry() = chip.pointer.y() + fromPointer;
        break;
    }
    return {QPointF(std::floor(corner.x()) + 0.5, std::floor(corner.y()) + 0.5), size};
}

void paintOverlay(QPainter &painter, const ScenePicture &picture)
{
    painter.setLayoutDirection(Qt::LeftToRight); // no widget tells it here
    paintLabels(painter, picture.list, picture.camera, picture.font);
    if (picture.loupe)
        paintLoupe(painter, *picture.loupe, picture.font);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (picture.inset)
        paintInset(painter, *picture.inset, picture.font);
    if (!picture.band.isNull())
        paintBand(painter, picture.band);
    for (const Chip &chip : picture.chips)
        paintChip(painter, chip, picture);
    if (picture.focusFrame) {
        painter.setPen(QPen(theme().accent, 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF({}, picture.camera.viewport()).adjusted(1.0, 1.0, -1.0, -1.0));
    }
    painter.restore();
}

} // namespace cradle
