// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>

#include <functional>
#include <initializer_list>

QT_BEGIN_NAMESPACE
class QWidget;
QT_END_NAMESPACE

namespace cradle {

/// Has \p answer called whenever the language, the palette or whatever else \p kinds names changes
/// for \p widget; before its children learn of it.
void onChange(QWidget *widget, std::initializer_list<QEvent::Type> kinds,
              const std::function<void()> &answer);

/// Writes the texts of \p widget by \p retranslate: now, and in every language to come.
template <typename Widget>
void keepTranslated(Widget *widget, void (Widget::*retranslate)())
{
    const auto write = [widget, retranslate] { (widget->*retranslate)(); };
    write();
    onChange(widget, {QEvent::LanguageChange}, write);
}

} // namespace cradle
