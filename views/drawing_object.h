// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPainter>
#include <QSvgRenderer>
#include <QTextFormat>
#include <QTextObjectInterface>

#include <memory>
#include <vector>

namespace cradle {

/// Draws what the page calls "drawing:N", as vectors.
class DrawingObject final : public QObject, public QTextObjectInterface
{
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)
public:
    explicit DrawingObject(const std::vector<QByteArray> &drawings)
    {
        for (const QByteArray &svg : drawings)
            m_drawings.push_back(std::make_unique<QSvgRenderer>(svg));
    }

    QSizeF intrinsicSize(QTextDocument *, int, const QTextFormat &format) override
    {
        const QTextImageFormat image = format.toImageFormat();
        return {image.width(), image.height()};
    }

    void drawObject(QPainter *painter, const QRectF &place, QTextDocument *, int,
                    const QTextFormat &format) override
    {
        const QString name = format.toImageFormat().name();
        const auto index = name.section(QLatin1Char(':'), 1).toUInt();
        if (name.startsWith(QLatin1String("drawing:")) && index < m_drawings.size())
            drawWithin(painter, place, *m_drawings[index]);
    }

private:
    static void drawWithin(QPainter *painter, const QRectF &place, QSvgRenderer &drawing)
    {
        // A clip that leaves nothing makes a broken path of a PDF.
        if (painter->hasClipping() && !painter->clipBoundingRect().intersects(place))
            return;
        painter->save();
        painter->setClipRect(place, Qt::IntersectClip);
        drawing.render(painter, place);
        painter->restore();
    }

    std::vector<std::unique_ptr<QSvgRenderer>> m_drawings;
};

} // namespace cradle
