// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/presentation.h"

#include "views/theme.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QPen>

#include <algorithm>

namespace cradle {

namespace {

constexpr int fadingTime = 700;    ///< ms that the trail is seen
constexpr int frameTime = 16;      ///< ms
constexpr double trailWidth = 9.0; ///< px at the pointer

} // namespace

PresentationLayer::PresentationLayer(QWidget *window)
    : QWidget(window)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    setGeometry(window->rect());
    m_clock.start();
    m_fading.setInterval(frameTime);
    connect(&m_fading, &QTimer::timeout, this, &PresentationLayer::forget);
    qApp->installEventFilter(this); // the pointer moves over all that lies in the window
    show();
    raise();
}

void PresentationLayer::setBlack(bool black)
{
    m_black = black;
    raise();
    update();
}

bool PresentationLayer::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize) {
        setGeometry(parentWidget()->rect());
        raise();
    }
    if (event->type() == QEvent::MouseMove || event->type() == QEvent::HoverMove) {
        const auto *at = qobject_cast<QWidget *>(watched);
        if (at && at->window() == window()) {
            const auto *move = static_cast<QSinglePointEvent *>(event);
            m_trail.push_back(
                {QPointF(mapFromGlobal(move->globalPosition().toPoint())), m_clock.elapsed()});
            m_fading.start();
            update();
        }
    }
    return QWidget::eventFilter(watched, event);
}

void PresentationLayer::forget()
{
    while (!m_trail.empty() && m_clock.elapsed() - m_trail.front().time > fadingTime)
        m_trail.pop_front();
    if (m_trail.empty())
        m_fading.stop();
    update();
}

void PresentationLayer::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    if (m_black) {
        painter.fillRect(rect(), Qt::black);
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = 1; i < m_trail.size(); ++i) {
        const double age = double(m_clock.elapsed() - m_trail[i].time) / fadingTime;
        QColor colour = theme().warning;
        colour.setAlphaF(static_cast<float>(std::clamp(1.0 - age, 0.0, 1.0)));
        painter.setPen(QPen(colour, trailWidth * (1.0 - 0.6 * std::clamp(age, 0.0, 1.0)),
                            Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(m_trail[i - 1].place, m_trail[i].place);
    }
}

} // namespace cradle
