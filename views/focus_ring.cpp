// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/focus_ring.h"

#include "views/theme.h"

#include <QAbstractScrollArea>
#include <QFocusEvent>
#include <QPainter>

namespace cradle {

namespace {

constexpr double ringWidth = 2.0; ///< px, as of buttons and fields

/// Lies over an area, and takes neither clicks nor keys.
class FocusRing final : public QWidget
{
public:
    explicit FocusRing(QAbstractScrollArea *area)
        : QWidget(area)
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setFocusPolicy(Qt::NoFocus);
        hide();
        area->installEventFilter(this);
    }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (event->type() == QEvent::FocusIn)
            follow(static_cast<QFocusEvent *>(event)->reason());
        else if (event->type() == QEvent::FocusOut)
            hide();
        else if (event->type() == QEvent::Resize)
            setGeometry(parentWidget()->rect());
        return QWidget::eventFilter(watched, event);
    }

    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        painter.setPen(
            QPen(theme().accent, ringWidth, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
        const double half = ringWidth / 2.0;
        painter.drawRect(QRectF(rect()).adjusted(half, half, -half, -half));
    }

private:
    /// A window that comes back, or a menu that closes, gives the focus back as it was.
    void follow(Qt::FocusReason reason)
    {
        if (reason != Qt::ActiveWindowFocusReason && reason != Qt::PopupFocusReason)
            m_byKeys = reason != Qt::MouseFocusReason;
        if (!m_byKeys)
            return;
        setGeometry(parentWidget()->rect());
        raise();
        show();
    }

    bool m_byKeys = false;
};

} // namespace

void ringFocus(QAbstractScrollArea *area)
{
    new FocusRing(area);
}

} // namespace cradle
