// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/gui/drawn_texts.h"
#include "views/code/lua_area.h"
#include "views/theme.h"

#include <QHash>
#include <QImage>
#include <QLineEdit>
#include <QPixmap>
#include <QStringList>
#include <QTabBar>
#include <QTextEdit>
#include <QTreeWidget>

namespace cradle {

inline constexpr double hair = 1.5; ///< px that boxes may overlap or be clipped: they are whole
inline constexpr double leastContrast = 4.5; ///< WCAG 2.1, 1.4.3
inline constexpr double rounding = 0.05;     ///< of a contrast: colours are kept in bytes

inline QString describe(const DrawnText &text)
{
    QStringList path;
    for (const QWidget *w = text.widget; w && !w->isWindow() && path.size() < 3;
         w = w->parentWidget())
        path.prepend(QLatin1String(w->metaObject()->className()));
    const auto box = [](const QRectF &rect) {
        return QStringLiteral("%1,%2 %3x%4")
            .arg(rect.x(), 0, 'f', 1)
            .arg(rect.y(), 0, 'f', 1)
            .arg(rect.width(), 0, 'f', 1)
            .arg(rect.height(), 0, 'f', 1);
    };
    return QStringLiteral("“%1” in %2 at %3 (seen %4)")
        .arg(text.text, path.join(QLatin1Char('/')), box(text.ink), box(text.seen));
}

/// What is cut there is reached by scrolling, or by the cursor.
inline bool isReached(const DrawnText &text)
{
    if (qobject_cast<const LuaArea *>(text.widget->parentWidget()))
        return true; // it knows a little later how far
    const bool isTooWide =
        text.seen.left() > text.ink.left() + hair || text.seen.right() < text.ink.right() - hair;
    const auto *line = qobject_cast<const QLineEdit *>(text.widget.data());
    if (line && !line->isReadOnly() && isTooWide)
        return true;
    for (const QWidget *w = text.widget; w; w = w->parentWidget()) {
        if (const auto *area = qobject_cast<const QAbstractScrollArea *>(w)) {
            const QScrollBar *bar =
                isTooWide ? area->horizontalScrollBar() : area->verticalScrollBar();
            if (bar->maximum() > bar->minimum())
                return true;
        }
    }
    return false;
}

inline bool isCut(const DrawnText &text)
{
    // Letters of another font may be taller than those that a field has its height from.
    const bool isField = qobject_cast<const QLineEdit *>(text.widget.data());
    return text.seen.width() < text.ink.width() - hair
           || text.seen.height() < text.ink.height() - (isField ? 2.0 * hair : hair);
}

/// The colour that most of \p rect has.
inline QColor groundOf(const QImage &image, const QRectF &rect)
{
    QHash<QRgb, int> counts;
    QRgb most = 0;
    const QRect area = rect.toAlignedRect().adjusted(-2, -2, 2, 2) & image.rect();
    for (int y = area.top(); y <= area.bottom(); ++y) {
        for (int x = area.left(); x <= area.right(); ++x) {
            const QRgb pixel = image.pixel(x, y);
            if (++counts[pixel] > counts.value(most))
                most = pixel;
        }
    }
    return QColor(most);
}

inline QColor over(const QColor &ground, const QColor &ink)
{
    const auto part = [&ink](int below, int above) {
        return below + (above - below) * ink.alpha() / 255;
    };
    return {part(ground.red(), ink.red()), part(ground.green(), ink.green()),
            part(ground.blue(), ink.blue())};
}

/// Ends in dots that are not its own.
inline bool isAbbreviated(const DrawnText &text)
{
    if (!text.text.endsWith(QChar(0x2026)))
        return false;
    // A line of a program is told whole when it is pointed at.
    const QWidget *area = text.widget->parentWidget();
    if (qobject_cast<const QTreeWidget *>(area) || qobject_cast<const QTextEdit *>(area))
        return false;
    return !text.widget->property("text").toString().contains(QChar(0x2026));
}

inline void findCut(const std::vector<DrawnText> &texts, QStringList &found)
{
    for (const DrawnText &each : texts) {
        if (isCut(each) && !isReached(each))
            found << describe(each) + QStringLiteral(" is cut off");
        if (isAbbreviated(each))
            found << describe(each) + QStringLiteral(" may be abbreviated");
    }
}

inline void findTouching(const std::vector<DrawnText> &texts, QStringList &found)
{
    for (std::size_t i = 0; i < texts.size(); ++i) {
        for (std::size_t k = i + 1; k < texts.size(); ++k) {
            const QRectF both = texts[i].seen & texts[k].seen;
            // The parts of a line follow one upon the other.
            const bool isOneLine = texts[i].widget == texts[k].widget;
            if (both.width() > (isOneLine ? 3.0 * hair : hair) && both.height() > hair)
                found << describe(texts[i]) + QStringLiteral(" touches ") + describe(texts[k]);
        }
    }
}

inline void findPale(const std::vector<DrawnText> &texts, const QImage &image, QStringList &found)
{
    const QColor disabled = paletteOf(theme()).color(QPalette::Disabled, QPalette::Text);
    for (const DrawnText &each : texts) {
        if (!each.widget->isEnabled() || each.colour == disabled)
            continue; // as WCAG has it
        const QColor ground = groundOf(image, each.seen);
        const QColor ink = over(ground, each.colour);
        const double ratio = contrast(ink, ground);
        if (ratio < leastContrast - rounding)
            found << QStringLiteral("%1: %2 on %3 is %4 : 1")
                         .arg(describe(each), ink.name(), ground.name())
                         .arg(ratio, 0, 'f', 2);
    }
}

/// Tabs that are scrolled or abbreviated, as there is no room for all of them.
inline void findScrolledTabs(const QWidget &window, QStringList &found)
{
    for (const auto *tabs : window.findChildren<QTabBar *>()) {
        // Qt keeps the titles of panes that stand alone now beyond the window.
        const bool isSeen = tabs->isVisible() && !tabs->visibleRegion().isEmpty();
        int room = 0;
        QStringList titles;
        for (int tab = 0; tab < tabs->count(); ++tab) {
            room += tabs->tabRect(tab).width();
            titles << tabs->tabText(tab);
        }
        if (isSeen && room > tabs->width())
            found << QStringLiteral("the tabs %1 need %2 px and have %3")
                         .arg(titles.join(QStringLiteral(" | ")))
                         .arg(room)
                         .arg(tabs->width());
    }
}

/// What of that which \p window says cannot be read: it is cut, stands on something else, or can
/// hardly be told from the ground.
inline QStringList illegibleTexts(QWidget &window, std::size_t atLeast)
{
    for (QLineEdit *line : window.findChildren<QLineEdit *>())
        line->deselect(); // what is selected is written twice
    QStringList found;
    const QImage image = window.grab().toImage().convertToFormat(QImage::Format_RGB32);
    const std::vector<DrawnText> texts = drawnTexts(window);
    if (texts.size() < atLeast)
        found << QStringLiteral("only %1 texts").arg(texts.size());
    findCut(texts, found);
    findScrolledTabs(window, found);
    findTouching(texts, found);
    findPale(texts, image, found);
    return found;
}

} // namespace cradle
