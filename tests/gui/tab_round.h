// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/focus_order.h"
#include "tests/patience.h"
#include "views/code/lua_area.h"

#include <QApplication>
#include <QRadioButton>
#include <QSet>
#include <QStringList>
#include <QTest>

namespace cradle {

inline QString describe(const QWidget &widget)
{
    QStringList path;
    for (const QWidget *w = &widget; w && !w->isWindow() && path.size() < 4; w = w->parentWidget())
        path.prepend(QLatin1String(w->metaObject()->className()));
    return QStringLiteral("%1 “%2%3”")
        .arg(path.join(QLatin1Char('/')), widget.accessibleName(),
             widget.property("text").toString());
}

/// Whether Tab need not stop there: arrows lead to it from one where it does.
inline bool isBesideOne(const QWidget &widget)
{
    const auto *radio = qobject_cast<const QRadioButton *>(&widget);
    return radio && !radio->isChecked();
}

/// What Tab does not pass on its way round \p window, and where it does not go on. In programs,
/// where it indents, Esc goes before it.
inline QStringList missedByTab(QWidget &window)
{
    window.activateWindow();
    if (!QTest::qWaitForWindowActive(&window, patience))
        return {QStringLiteral("never active")};
    std::vector<QWidget *> stops = controlsIn(window);
    std::erase_if(stops, [](const QWidget *stop) { return isBesideOne(*stop); });
    if (stops.empty())
        return {QStringLiteral("nothing to reach")};
    // What opens may still give the focus to something, and the display take it from the window.
    const auto begins = [&] {
        window.activateWindow();
        stops.front()->setFocus(Qt::TabFocusReason);
        QCoreApplication::processEvents();
        return QApplication::focusWidget() == stops.front();
    };
    if (!QTest::qWaitFor(begins, patience))
        return {QStringLiteral("the focus cannot be had")};
    QStringList missed;
    QSet<const QWidget *> met;
    for (std::size_t i = 0; i < 2 * stops.size() + 2; ++i) {
        QWidget *focused = QApplication::focusWidget();
        if (!focused || focused->window() != &window)
            return {QStringLiteral("the focus is lost after %1").arg(met.size())};
        if (met.contains(focused))
            break;
        met.insert(focused);
        if (!isInSight(*focused))
            missed << describe(*focused) + QStringLiteral(" is out of sight");
        if (qobject_cast<LuaArea *>(focused))
            QTest::keyClick(focused, Qt::Key_Escape);
        QTest::keyClick(focused, Qt::Key_Tab);
        if (QApplication::focusWidget() == focused && stops.size() > 1)
            missed << describe(*focused) + QStringLiteral(" is not left");
    }
    for (const QWidget *stop : stops) {
        if (!met.contains(stop) && stop->isVisible())
            missed << describe(*stop) + QStringLiteral(" is passed over");
    }
    return missed;
}

} // namespace cradle
