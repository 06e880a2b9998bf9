// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/error_line.h"

#include "views/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

namespace cradle {

namespace {

constexpr qsizetype longestText = 400; ///< characters; the rest is in the tooltip
constexpr int sidePad = 10;            ///< px
constexpr int pad = 7;                 ///< px above and below

} // namespace

ErrorLine::ErrorLine(QWidget *parent)
    : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
    setContentsMargins(sidePad, pad, sidePad, pad);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setKind(this, "warning");
}

QString ErrorLine::describe(const ProgramError &error)
{
    if (error.line > 0 && error.step > 0)
        return tr("line %1, step %2: %3").arg(error.line).arg(error.step).arg(error.message);
    if (error.line > 0)
        return tr("line %1: %2").arg(error.line).arg(error.message);
    if (error.step > 0)
        return tr("step %1: %2").arg(error.step).arg(error.message);
    return error.message;
}

void ErrorLine::setError(const ProgramError &error)
{
    const QString whole = describe(error);
    const bool fits = whole.size() <= longestText;
    setText(fits ? whole : whole.left(longestText - 1) + QChar(0x2026));
    // A message is no rich text, whatever it looks like.
    setToolTip(fits ? QString() : QStringLiteral("<p>%1</p>").arg(whole.toHtmlEscaped()));
    setAccessibleName(tr("The program stopped: %1").arg(whole));
}

void ErrorLine::paintEvent(QPaintEvent *event)
{
    const Theme &colours = theme();
    QPainter painter(this);
    painter.fillRect(rect(), colours.warningSoft);
    painter.fillRect(QRect(0, 0, width(), 1), colours.warningBorder);
    if (hasFocus()) {
        painter.setPen(QPen(colours.accent, 2.0));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
    painter.end();
    QLabel::paintEvent(event);
}

void ErrorLine::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton && rect().contains(event->position().toPoint()))
        emit clicked();
}

void ErrorLine::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter
        || event->key() == Qt::Key_Space)
        emit clicked();
    else
        QLabel::keyPressEvent(event);
}

} // namespace cradle
