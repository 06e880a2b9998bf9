// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/subscript_text.h"

#include <QFontMetricsF>

#include <vector>

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

struct Part {
    QString text;
    bool isSubscript = false;
};

/// The parts of \p text from the left. Of a text that is read from the right the last one comes
/// first; a symbol and its subscript stay as they are.
std::vector<Part> partsOf(const QString &text)
{
    std::vector<Part> parts;
    const bool fromRight = text.isRightToLeft();
    const auto add = [&parts, fromRight](const std::vector<Part> &group) {
        parts.insert(fromRight ? parts.begin() : parts.end(), group.begin(), group.end());
    };
    qsizetype from = 0;
    for (qsizetype at = nextSubscript(text, 0); at >= 0; at = nextSubscript(text, from)) {
        if (fromRight) {
            add({{text.mid(from, at - 1 - from), false}});
            from = at - 1;
        }
        add({{text.mid(from, at - from), false}, {text.mid(at + 1, 1), true}});
        from = at + 2;
    }
    add({{text.mid(from), false}});
    return parts;
}

} // namespace

double subscriptWidth(const QFont &font, const QString &text)
{
    if (!text.contains(u'_'))
        return QFontMetricsF(font).horizontalAdvance(text);
    const QFontMetricsF normal(font);
    const QFontMetricsF small(smaller(font));
    double width = 0.0;
    for (const Part &part : partsOf(text))
        width += (part.isSubscript ? small : normal).horizontalAdvance(part.text);
    return width;
}

void drawSubscripted(QPainter &painter, QPointF baseline, const QString &text)
{
    const Qt::LayoutDirection direction = painter.layoutDirection();
    if (text.isRightToLeft())
        painter.setLayoutDirection(Qt::RightToLeft); // its colons and spaces, too
    const QFont font = painter.font();
    const QFont small = smaller(font);
    const double drop = subscriptDrop * QFontMetricsF(font).ascent();
    for (const Part &part : partsOf(text)) {
        painter.setFont(part.isSubscript ? small : font);
        painter.drawText(baseline + QPointF(0.0, part.isSubscript ? drop : 0.0), part.text);
        baseline.rx() += QFontMetricsF(painter.font()).horizontalAdvance(part.text);
    }
    painter.setFont(font);
    painter.setLayoutDirection(direction);
}

} // namespace cradle
