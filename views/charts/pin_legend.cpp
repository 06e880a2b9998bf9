// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/pin_legend.h"

#include "views/theme.h"

#include <QFontMetricsF>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr int linePixels = 15;  ///< at the usual size of texts, as textPixels
constexpr double indent = 14.0; ///< px, as the heading's
constexpr double swatch = 22.0; ///< px
constexpr double textGap = 6.0; ///< px
constexpr int textPixels = 11;

int lineHeight()
{
    return scaledByText(linePixels);
}

} // namespace

PinLegend::PinLegend(QWidget *parent)
    : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    hide();
}

void PinLegend::setLines(const std::vector<Line> &lines)
{
    if (lines == m_lines)
        return;
    m_lines = lines;
    QStringList texts;
    for (const Line &line : lines)
        texts << line.text;
    setAccessibleName(texts.join(QStringLiteral("; ")));
    setVisible(!lines.empty());
    updateGeometry();
    update();
}

QSize PinLegend::sizeHint() const
{
    return {200, lineHeight() * static_cast<int>(m_lines.size())};
}

bool PinLegend::event(QEvent *event)
{
    if (event->type() == QEvent::FontChange)
        updateGeometry();
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    const auto line = static_cast<std::size_t>(std::max(0, help->pos().y() / lineHeight()));
    if (line < m_lines.size())
        QToolTip::showText(help->globalPos(), m_lines[line].details, this);
    return true;
}

void PinLegend::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    paint(painter, rect());
}

void PinLegend::paint(QPainter &painter, const QRectF &rect) const
{
    QFont small = font();
    small.setPixelSize(scaledByText(textPixels));
    painter.setFont(small);
    const QFontMetricsF metrics(small);
    const double left = rect.left() + indent + swatch + textGap;
    double top = rect.top();
    for (const Line &line : m_lines) {
        const double middle = std::round(top + 0.5 * lineHeight()) + 0.5;
        painter.setPen(QPen(theme().mutedText, 1.5, line.dash, Qt::FlatCap));
        painter.drawLine(QPointF(rect.left() + indent, middle),
                         QPointF(rect.left() + indent + swatch, middle));
        painter.setPen(theme().mutedText);
        painter.drawText(QPointF(left, middle + std::round(0.5 * metrics.capHeight())),
                         metrics.elidedText(line.text, Qt::ElideRight, rect.right() - left - 8.0));
        top += lineHeight();
    }
}

} // namespace cradle
