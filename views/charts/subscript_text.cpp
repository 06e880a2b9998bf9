// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/subscript_text.h"

#include <QFontMetricsF>

namespace cradle {

namespace {

constexpr double subscriptSize = 0.78; ///< of the font
constexpr double subscriptDrop = 0.22; ///< of the font's size

/// The place of the underscore of the next single-letter symbol; −1 if there is none.
qsizetype nextSubscript(const QString &text, qsizetype from)
{
    const auto isPart = [&text](qsizetype i) {
        return i >= 0 && i < text.size() && text[i].isLetterOrNumber();
    };
    for (qsizetype i = text.indexOf(u'_', from); i >= 0; i = text.indexOf(u'_', i + 1)) {
        if (isPart(i - 1) && isPart(i + 1) && !isPart(i - 2) && !isPart(i + 2))
            return i;
    }
    return -1;
}

QFont smaller(QFont font)
{
    if (font.pixelSize() > 0)
        font.setPixelSize(qMax(1, qRound(subscriptSize * font.pixelSize())));
    else
        font.setPointSizeF(subscriptSize * font.pointSizeF());
    return font;
}

/// Calls visit(part, isSubscript) for the parts of \p text from left to right.
template <typename Visit>
void forEachPart(const QString &text, Visit visit)
{
    qsizetype from = 0;
    for (qsizetype at = nextSubscript(text, 0); at >= 0; at = nextSubscript(text, from)) {
        visit(text.mid(from, at - from), false);
        visit(text.mid(at + 1, 1), true);
        from = at + 2;
    }
    if (from < text.size())
        visit(text.mid(from), false);
}

} // namespace

double subscriptWidth(const QFont &font, const QString &text)
{
    if (!text.contains(u'_'))
        return QFontMetricsF(font).horizontalAdvance(text);
    const QFontMetricsF normal(font);
    const QFontMetricsF small(smaller(font));
    double width = 0.0;
    forEachPart(text, [&](const QString &part, bool isSubscript) {
        width += (isSubscript ? small : normal).horizontalAdvance(part);
    });
    return width;
}

void drawSubscripted(QPainter &painter, QPointF baseline, const QString &text)
{
    if (!text.contains(u'_')) {
        painter.drawText(baseline, text);
        return;
    }
    const QFont font = painter.font();
    const QFont small = smaller(font);
    const double drop = subscriptDrop * QFontMetricsF(font).ascent();
    forEachPart(text, [&](const QString &part, bool isSubscript) {
        painter.setFont(isSubscript ? small : font);
        painter.drawText(baseline + QPointF(0.0, isSubscript ? drop : 0.0), part);
        baseline.rx() += QFontMetricsF(painter.font()).horizontalAdvance(part);
    });
    painter.setFont(font);
}

} // namespace cradle
