// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QEvent>

namespace cradle {

/// While it lives, painters write from left to right. Those of Scintilla take the direction of the
/// application, and lines of a program would have their brackets on the wrong side. The windows
/// are not told, so nothing is laid out anew.
class LeftToRightPainting final : public QObject
{
public:
    LeftToRightPainting()
    {
        if (!m_turned)
            return;
        qApp->installEventFilter(this);
        QGuiApplication::setLayoutDirection(Qt::LeftToRight);
    }
    ~LeftToRightPainting() override
    {
        if (!m_turned)
            return;
        QGuiApplication::setLayoutDirection(Qt::LayoutDirectionAuto); // follows the language
        if (!QGuiApplication::isRightToLeft())
            QGuiApplication::setLayoutDirection(Qt::RightToLeft);
    }
    LeftToRightPainting(const LeftToRightPainting &) = delete;
    LeftToRightPainting &operator=(const LeftToRightPainting &) = delete;

    bool eventFilter(QObject *, QEvent *event) override
    {
        return event->type() == QEvent::ApplicationLayoutDirectionChange;
    }

private:
    const bool m_turned = QGuiApplication::isRightToLeft();
};

} // namespace cradle
