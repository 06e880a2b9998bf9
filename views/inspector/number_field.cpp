// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspector/number_field.h"

#include "model/world/shortest_number.h"
#include "views/inspector/typed_number.h"
#include "views/theme.h"

#include <QKeyEvent>
#include <QPainter>
#include <QStyle>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr int unitGap = 6; ///< px between number and unit

} // namespace

NumberField::NumberField(const QString &unit, double step, QWidget *parent)
    : QLineEdit(parent)
    , m_unit(unit)
    , m_step(step)
{
    setLayoutDirection(Qt::LeftToRight); // the unit stands behind the number
    setProperty("refused", false);
    measure();
    setValue(0.0);
}

void NumberField::setSpinRange(double lowest, double highest)
{
    m_lowest = lowest;
    m_highest = highest;
}

QString NumberField::textOf(double value) const
{
    return fractionOrNumber(value);
}

void NumberField::setValue(double value)
{
    if (m_value != value)
        updateGeometry();
    m_value = value;
    setRefused(false);
    if (text() != textOf(value))
        setText(textOf(value));
    if (!hasFocus())
        setCursorPosition(0);
    setToolTip(m_unit.isEmpty() ? shortestNumber(value)
                                : shortestNumber(value) + QLatin1Char(' ') + m_unit);
}

void NumberField::setRefused(bool refused)
{
    if (m_refused == refused)
        return;
    m_refused = refused;
    setProperty("refused", refused);
    style()->unpolish(this);
    style()->polish(this);
    update();
}

void NumberField::revert()
{
    const bool changed = m_refused || text() != textOf(m_value);
    setValue(m_value);
    if (changed)
        emit reverted();
}

void NumberField::offer(double value, bool spinning)
{
    m_proposing = true;
    emit valueProposed(value, spinning);
    m_proposing = false;
}

bool NumberField::propose()
{
    if (text() == textOf(m_value)) {
        setRefused(false);
        return true;
    }
    const std::optional<double> number = readNumber(text(), m_unit);
    if (!number) {
        setRefused(true);
        emit notANumber(text());
        return false;
    }
    offer(*number, false);
    if (!m_refused && *number == m_value)
        setValue(m_value); // "0,50" becomes 0.5
    return !m_refused;
}

void NumberField::spin(int steps)
{
    const double from = readNumber(text(), m_unit).value_or(m_value);
    const double moved = m_spin == Spin::Add ? spun(from, m_step, steps) : from * std::exp2(steps);
    const double to = std::clamp(moved, m_lowest, m_highest);
    setText(textOf(to));
    offer(to, true);
    selectAll();
}

/// Where nothing has been typed, Undo and Redo are those of the scene.
bool NumberField::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride && text() == textOf(m_value)) {
        const auto &key = *static_cast<QKeyEvent *>(event);
        if (key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    return QLineEdit::event(event);
}

void NumberField::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Up:
        return spin(1);
    case Qt::Key_Down:
        return spin(-1);
    case Qt::Key_PageUp:
        return spin(m_spin == Spin::Add ? 10 : 1);
    case Qt::Key_PageDown:
        return spin(m_spin == Spin::Add ? -10 : -1);
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (propose())
            selectAll();
        return;
    case Qt::Key_Escape:
        revert();
        return selectAll();
    default:
        QLineEdit::keyPressEvent(event);
    }
}

void NumberField::focusInEvent(QFocusEvent *event)
{
    QLineEdit::focusInEvent(event);
    if (event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason)
        selectAll();
}

void NumberField::focusOutEvent(QFocusEvent *event)
{
    QLineEdit::focusOutEvent(event);
    if (event->reason() == Qt::PopupFocusReason || event->reason() == Qt::ActiveWindowFocusReason)
        return;
    if (!m_refused)
        propose();
    if (m_refused)
        revert();
    setCursorPosition(0);
}

void NumberField::wheelEvent(QWheelEvent *event)
{
    event->ignore(); // the pane scrolls; numbers change only when asked
}

QSize NumberField::sizeHint() const
{
    const int digits = fontMetrics().horizontalAdvance(QStringLiteral("-0.000"));
    return {digits + textMargins().right() + 2 * unitGap + 8, QLineEdit::sizeHint().height()};
}

/// Its own number is whole, however large the letters are.
QSize NumberField::minimumSizeHint() const
{
    const QSize least = QLineEdit::minimumSizeHint();
    const int whole =
        fontMetrics().horizontalAdvance(textOf(m_value)) + textMargins().right() + 2 * unitGap + 8;
    return {std::max(least.width(), std::min(whole, sizeHint().width())), least.height()};
}

/// Room for the unit at the right end.
void NumberField::measure()
{
    const int width = fontMetrics().horizontalAdvance(m_unit);
    setTextMargins(0, 0, m_unit.isEmpty() ? 0 : width + unitGap, 0);
}

void NumberField::paintEvent(QPaintEvent *event)
{
    QLineEdit::paintEvent(event);
    QPainter painter(this);
    painter.setLayoutDirection(layoutDirection()); // else it is the application's
    painter.setPen(theme().mutedText);
    painter.drawText(rect().adjusted(0, 0, -unitGap - 2, 0), Qt::AlignRight | Qt::AlignVCenter,
                     m_unit);
}

void NumberField::changeEvent(QEvent *event)
{
    QLineEdit::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        measure();
}

} // namespace cradle
