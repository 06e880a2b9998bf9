// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/action_button.h"

#include <QAction>
#include <QStyleOptionButton>
#include <QStylePainter>

#include <algorithm>

namespace cradle {

namespace {

constexpr int iconAside = 5; ///< px that an icon alone needs less on either side than a text

} // namespace

ActionButton::ActionButton(QAction *action, QWidget *parent)
    : QPushButton(parent)
    , m_action(action)
{
    setFocusPolicy(Qt::TabFocus);
    setIconSize(iconSquare(18));
    connect(action, &QAction::changed, this, &ActionButton::followAction);
    connect(this, &QPushButton::clicked, action, &QAction::trigger);
    followAction();
}

void ActionButton::setIconName(const QString &name, IconTint tint)
{
    setIcon(cradle::icon(name, tint));
}

void ActionButton::setCollapsed(bool collapsed)
{
    m_collapsed = collapsed;
    followAction();
}

void ActionButton::setTexts(const QStringList &texts)
{
    m_texts = texts;
    updateGeometry();
}

/// As QPushButton measures it, so that the button is as wide with one text as with another, px.
int ActionButton::widthOf(const QString &text) const
{
    return fontMetrics().size(Qt::TextShowMnemonic, text).width();
}

int ActionButton::widestText() const
{
    int widest = widthOf(text());
    for (const QString &other : m_texts)
        widest = std::max(widest, widthOf(other));
    return widest;
}

int ActionButton::spareWidth() const
{
    return m_collapsed ? 0 : widestText() + 2 * iconAside;
}

QSize ActionButton::sizeHint() const
{
    const int spare = m_collapsed ? -2 * iconAside : widestText() - widthOf(text());
    return QPushButton::sizeHint() + QSize(spare, 0);
}

/// From right to left, Qt's style sheets draw the icon of a button that is wider than it need be in
/// its middle and the text at its far end; given no more room than they need, the two stand beside
/// each other.
void ActionButton::paintEvent(QPaintEvent *event)
{
    const int spare = width() - QPushButton::sizeHint().width();
    if (!isRightToLeft() || spare <= 0) {
        QPushButton::paintEvent(event);
        return;
    }
    QStylePainter painter(this);
    QStyleOptionButton option;
    initStyleOption(&option);
    painter.drawControl(QStyle::CE_PushButtonBevel, option);
    option.rect = style()->subElementRect(QStyle::SE_PushButtonContents, &option, this);
    option.rect.adjust(spare / 2, 0, spare / 2 - spare, 0);
    painter.drawControl(QStyle::CE_PushButtonLabel, option);
}

void ActionButton::followAction()
{
    const QString text = m_action->iconText();
    const QString keys = m_action->shortcut().toString(QKeySequence::NativeText);
    const QString tip = m_action->toolTip();
    setText(m_collapsed ? QString() : text);
    setToolTip(keys.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, keys));
    setAccessibleName(text);
    setEnabled(m_action->isEnabled());
}

} // namespace cradle
