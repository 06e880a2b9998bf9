// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/focus_order.h"

#include <QAccessible>
#include <QStringList>
#include <QTabBar>

namespace cradle {

/// What a screen reader cannot tell apart without a name.
inline bool needsName(const QAccessibleInterface &each)
{
    switch (each.role()) {
    case QAccessible::PushButton:
    case QAccessible::CheckBox:
    case QAccessible::RadioButton:
    case QAccessible::ComboBox:
    case QAccessible::EditableText:
    case QAccessible::Slider:
    case QAccessible::SpinBox:
    case QAccessible::Table:
    case QAccessible::List:
    case QAccessible::Tree:
    case QAccessible::PageTab:
    case QAccessible::ProgressBar:
    case QAccessible::Canvas:
    case QAccessible::Chart:
    case QAccessible::StaticText:
        return true;
    default:
        return each.state().focusable;
    }
}

inline QString describe(const QAccessibleInterface &each)
{
    QStringList path;
    for (const QObject *object = each.object(); object; object = object->parent())
        path.prepend(QLatin1String(object->metaObject()->className()));
    return QStringLiteral("role %1 at %2")
        .arg(int(each.role()))
        .arg(path.join(QLatin1String(" / ")));
}

/// Those that have no name, also where they are scrolled out of sight.
inline void findNameless(QAccessibleInterface *parent, QStringList &found, int &met)
{
    for (int i = 0; i < parent->childCount(); ++i) {
        QAccessibleInterface *child = parent->child(i);
        if (!child || child->state().invisible)
            continue;
        ++met;
        // Qt keeps the titles of panes that stand alone now beyond the window.
        const auto *titles = qobject_cast<QTabBar *>(child->object());
        if (titles && !isInSight(*titles))
            continue;
        if (needsName(*child) && child->text(QAccessible::Name).trimmed().isEmpty()
            && child->text(QAccessible::Value).trimmed().isEmpty())
            found.append(describe(*child));
        if (child->role() != QAccessible::Table) // cells are told by their texts
            findNameless(child, found, met);
    }
}

} // namespace cradle
