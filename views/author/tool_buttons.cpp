// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/tool_buttons.h"

#include "views/icons.h"

#include <QToolButton>

namespace cradle {

QToolButton *makeIconButton(const QString &iconName, QWidget *parent)
{
    auto *button = new QToolButton(parent);
    button->setIcon(icon(iconName));
    button->setIconSize(iconSquare(16));
    button->setAutoRaise(true);
    return button;
}

void nameButton(QToolButton *button, const QString &name, const QString &keys)
{
    button->setAccessibleName(name);
    button->setToolTip(keys.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, keys));
}

} // namespace cradle
