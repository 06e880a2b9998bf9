// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/icons.h"

#include "views/theme.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

#include <cmath>
#include <utility>

namespace cradle {

namespace {

QColor colourOf(IconTint tint, QIcon::Mode mode)
{
    if (mode == QIcon::Disabled)
        return paletteOf(theme()).color(QPalette::Disabled, QPalette::ButtonText);
    switch (tint) {
    case IconTint::Muted:
        return theme().mutedText;
    case IconTint::Accent:
        return theme().accent;
    case IconTint::OnAccent:
        return theme().onAccent;
    case IconTint::Success:
        return theme().success;
    case IconTint::Warning:
        return theme().warning;
    case IconTint::Text:
        break;
    }
    return theme().text;
}

/// Draws an SVG in the colour that the theme gives at that moment.
class LineIconEngine final : public QIconEngine
{
public:
    LineIconEngine(QString name, QByteArray svg, IconTint tint)
        : m_name(std::move(name))
        , m_svg(std::move(svg))
        , m_tint(tint)
    {
    }

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State) override
    {
        QByteArray svg = m_svg;
        svg.replace("currentColor", colourOf(m_tint, mode).name().toLatin1());
        QSvgRenderer renderer(svg);
        const int side = std::min(rect.width(), rect.height());
        QRectF square(0, 0, side, side);
        square.moveCenter(QRectF(rect).center());
        renderer.render(painter, square);
    }

    /// \param size  in device pixels
    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override
    {
        const QString key = QStringLiteral("cradle-icon-%1-%2-%3x%4")
                                .arg(m_name, colourOf(m_tint, mode).name())
                                .arg(size.width())
                                .arg(size.height());
        QPixmap pixmap;
        if (QPixmapCache::find(key, &pixmap))
            return pixmap;
        pixmap = QPixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        painter.end();
        QPixmapCache::insert(key, pixmap);
        return pixmap;
    }

    [[nodiscard]] QIconEngine *clone() const override { return new LineIconEngine(*this); }
    QString iconName() override { return m_name; }
    bool isNull() override { return m_svg.isEmpty(); }

private:
    QString m_name;
    QByteArray m_svg;
    IconTint m_tint;
};

} // namespace

QIcon icon(QStringView name, IconTint tint)
{
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    return QIcon(new LineIconEngine(name.toString(), file.readAll(), tint));
}

double iconScale(double textScale)
{
    return 1.0 + (textScale - 1.0) / 3.0;
}

QSize iconSquare(int pixels)
{
    return QSize(1, 1) * static_cast<int>(std::lround(iconScale(textScale()) * pixels));
}

QIcon openingIcon(bool isOpen)
{
    const bool isMirrored = QGuiApplication::isRightToLeft();
    return icon(isOpen ? u"expanded" : isMirrored ? u"next-mirrored" : u"next", IconTint::Muted);
}

} // namespace cradle
