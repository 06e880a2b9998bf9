// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/quiet_button.h"

#include "views/subscript_text.h"
#include "views/theme.h"

#include <QFontMetricsF>
#include <QMenu>

#include <cmath>

namespace cradle {

namespace {

constexpr int buttonHeight = 20; ///< px
constexpr int buttonPad = 6;     ///< px left and right of the text
constexpr int arrowWidth = 10;   ///< px for the arrow of a menu
constexpr int buttonTextPixels = 11;

QFont smallFont(const QWidget &widget)
{
    QFont font = widget.font();
    font.setPixelSize(scaledByText(buttonTextPixels));
    font.setWeight(QFont::Medium);
    return font;
}

} // namespace

QuietButton::QuietButton(QWidget *parent)
    : QAbstractButton(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void QuietButton::setMenu(QMenu *menu, bool arrow)
{
    m_menu = menu;
    m_hasArrow = arrow;
    connect(this, &QuietButton::clicked, menu,
            [this, menu] { menu->popup(mapToGlobal(rect().bottomLeft())); });
    updateGeometry();
}

QSize QuietButton::sizeHint() const
{
    const double text = std::ceil(subscriptWidth(smallFont(*this), this->text()));
    return {static_cast<int>(text) + 2 * buttonPad + (m_hasArrow ? arrowWidth : 0),
            scaledByText(buttonHeight)};
}

void QuietButton::paintEvent(QPaintEvent *)
{
    const Theme &colours = theme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(hasFocus() ? QPen(colours.accent, 1.0) : QPen(Qt::NoPen));
    if (isChecked() || isDown())
        painter.setBrush(colours.accentSoft);
    else if (underMouse() && isEnabled())
        painter.setBrush(colours.hover);
    painter.drawRoundedRect(frame, 4.0, 4.0);

    painter.setFont(smallFont(*this));
    painter.setPen(isChecked() || underMouse() ? colours.text : colours.mutedText);
    const QFontMetricsF metrics(painter.font());
    const double baseline = 0.5 * (this->height() + metrics.capHeight());
    drawSubscripted(painter, {double(buttonPad), baseline}, text());
    if (m_hasArrow) {
        const double x = width() - buttonPad - 3.5;
        const double y = 0.5 * this->height() + 0.5;
        painter.setPen(QPen(painter.pen().color(), 1.2, Qt::SolidLine, Qt::RoundCap));
        painter.drawPolyline(QPolygonF{{x - 3.0, y - 1.5}, {x, y + 1.5}, {x + 3.0, y - 1.5}});
    }
}

} // namespace cradle
