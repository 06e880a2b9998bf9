// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

QT_BEGIN_NAMESPACE
class QToolButton;
class QWidget;
QT_END_NAMESPACE

namespace cradle {

/// A flat button with the icon of that name, for a row beside a list. Its words come with
/// nameButton().
[[nodiscard]] QToolButton *makeIconButton(const QString &iconName, QWidget *parent);

/// The button's tooltip and accessible name; \p keys are told in the tooltip.
void nameButton(QToolButton *button, const QString &name, const QString &keys = {});

} // namespace cradle
