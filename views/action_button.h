// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/icons.h"

#include <QPushButton>

class QAction;

namespace cradle {

/// A push button that does what an action does, with its text, tool tip and state. It can do
/// without its text where room is scarce.
class ActionButton final : public QPushButton
{
    Q_OBJECT
public:
    explicit ActionButton(QAction *action, QWidget *parent = nullptr);

    /// The icon of the button; the action's own is for menus.
    void setIconName(const QString &name, IconTint tint = IconTint::Text);
    void setCollapsed(bool collapsed);
    /// Texts that the action has in turn: the button is wide enough for each, so that what stands
    /// beside it does not move.
    void setTexts(const QStringList &texts);
    [[nodiscard]] int spareWidth() const; ///< px that it can do without; 0 if collapsed

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void followAction();
    [[nodiscard]] int widthOf(const QString &text) const;
    [[nodiscard]] int widestText() const;

    QAction *m_action;
    bool m_collapsed = false;
    QStringList m_texts;
};

} // namespace cradle
