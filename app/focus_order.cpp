// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/focus_order.h"

#include <QScrollArea>
#include <QWidget>

#include <algorithm>
#include <tuple>

namespace cradle {

namespace {

constexpr int rowHeight = 16;   ///< px: what begins so near stands side by side
constexpr int columnWidth = 32; ///< px
constexpr int scrollMargin = 8; ///< px

/// From the side where one begins to read.
int fromBeginning(const QRect &rect, const QWidget &whole)
{
    return whole.isRightToLeft() ? whole.width() - rect.right() : rect.left();
}

bool isStop(const QWidget &widget)
{
    return widget.isEnabled() && (widget.focusPolicy() & Qt::TabFocus) != 0 && !widget.focusProxy();
}

void collect(QWidget *widget, std::vector<QWidget *> &found)
{
    if (!widget->isVisible() || widget->size().isEmpty())
        return;
    if (isStop(*widget))
        found.push_back(widget);
    std::vector<QWidget *> children;
    for (QObject *child : widget->children()) {
        auto *each = qobject_cast<QWidget *>(child);
        if (each && !each->isWindow())
            children.push_back(each);
    }
    const auto place = [widget](const QWidget *child) {
        return std::tuple(child->y() / rowHeight, fromBeginning(child->geometry(), *widget));
    };
    std::stable_sort(children.begin(), children.end(),
                     [&place](QWidget *a, QWidget *b) { return place(a) < place(b); });
    for (QWidget *child : children)
        collect(child, found);
}

} // namespace

bool isInSight(const QWidget &widget)
{
    QRect rect = widget.rect();
    for (const QWidget *w = &widget; !w->isWindow() && w->parentWidget(); w = w->parentWidget())
        rect = rect.translated(w->pos()).intersected(w->parentWidget()->rect());
    return widget.isVisible() && !rect.isEmpty();
}

std::vector<QWidget *> controlsIn(QWidget &part)
{
    std::vector<QWidget *> found;
    collect(&part, found);
    return found;
}

void sortByEye(std::vector<QWidget *> &parts, const QWidget &window)
{
    const auto place = [&window](const QWidget *part) {
        const QRect rect(part->mapTo(&window, QPoint()), part->size());
        return std::tuple(fromBeginning(rect, window) / columnWidth, rect.y());
    };
    std::stable_sort(parts.begin(), parts.end(),
                     [&place](QWidget *a, QWidget *b) { return place(a) < place(b); });
}

void focusByTab(QWidget &widget, bool forwards)
{
    widget.setFocus(forwards ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    if (isInSight(widget))
        return;
    for (QWidget *w = widget.parentWidget(); w && !w->isWindow(); w = w->parentWidget()) {
        if (auto *area = qobject_cast<QScrollArea *>(w))
            area->ensureWidgetVisible(&widget, 0, scrollMargin);
    }
}

} // namespace cradle
