// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tour.h"

#include "views/theme.h"

#include <QAccessible>
#include <QFrame>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace cradle {

namespace {

constexpr int cardWidth = 320; ///< px, at the usual size of texts
constexpr int rise = 2;        ///< px that letters may need beyond their line
constexpr int gap = 12;        ///< px between card and part
constexpr float shade = 0.55F; ///< of what is not told of

} // namespace

Tour::Tour(QWidget *window, std::vector<Stop> stops)
    : QWidget(window)
    , m_stops(std::move(stops))
    , m_card(new QFrame(this))
    , m_title(new QLabel(m_card))
    , m_text(new QLabel(m_card))
    , m_next(new QPushButton(m_card))
    , m_skip(new QPushButton(tr("End the tour"), m_card))
{
    std::erase_if(m_stops, [](const Stop &stop) { return !stop.part || !stop.part->isVisible(); });
    setGeometry(window->rect());
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Tour of the window"));
    setKind(m_card, "card");
    setKind(m_title, "cardTitle");
    setKind(m_next, "primary");
    setKind(m_skip, "link");
    m_next->setDefault(true);
    m_title->setWordWrap(true);
    // Letters of a font that stands in, such as Arabic ones, may rise above the lines of the own.
    m_title->setContentsMargins(0, rise, 0, rise);
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_skip);
    buttons->addStretch(1);
    buttons->addWidget(m_next);
    auto *column = new QVBoxLayout(m_card);
    column->setContentsMargins(16, 12 - rise, 16, 12);
    column->setSpacing(8 - rise);
    column->addWidget(m_title);
    column->addWidget(m_text);
    column->addLayout(buttons);
    m_card->setFixedWidth(scaledByText(cardWidth));
    connect(m_next, &QPushButton::clicked, this, &Tour::next);
    connect(m_skip, &QPushButton::clicked, this, &Tour::end);
    window->installEventFilter(this);
    if (m_stops.empty()) {
        deleteLater();
        return;
    }
    show();
    raise();
    showStop();
}

QRect Tour::partRect() const
{
    const QWidget *part = m_stops[m_at].part;
    return part ? QRect(part->mapTo(parentWidget(), QPoint()), part->size()) : QRect();
}

void Tour::next()
{
    if (m_at + 1 >= m_stops.size())
        return end();
    ++m_at;
    showStop();
}

void Tour::end()
{
    hide();
    deleteLater();
}

void Tour::showStop()
{
    const Stop &stop = m_stops[m_at];
    m_title->setText(tr("%1 of %2 · %3").arg(m_at + 1).arg(m_stops.size()).arg(stop.title));
    // Plain text that goes from the right is drawn a space too far to the left, and cut there.
    m_text->setTextFormat(isRightToLeft() ? Qt::RichText : Qt::PlainText);
    m_text->setText(isRightToLeft() ? stop.text.toHtmlEscaped() : stop.text);
    const bool last = m_at + 1 == m_stops.size();
    m_next->setText(last ? tr("Begin") : tr("Next ▸"));
    m_next->setAccessibleName(last ? tr("Begin") : tr("Next"));
    m_next->setAccessibleDescription(m_title->text() + QStringLiteral(". ") + stop.text);
    m_skip->setVisible(!last);
    placeCard();
    m_next->setFocus();
    QAccessibleEvent changed(m_next, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&changed);
    update();
}

/// Beside the part, where there is room: right of it, left of it, below, above; else upon it.
void Tour::placeCard()
{
    const QRect part = partRect();
    const int width = m_card->minimumWidth();
    const QSize size(width, m_card->layout()->totalHeightForWidth(width));
    const QRect room = rect().adjusted(gap, gap, -gap, -gap);
    const int top =
        std::clamp(part.top(), room.top(), std::max(room.top(), room.bottom() - size.height()));
    const int left = std::clamp(part.center().x() - size.width() / 2, room.left(),
                                std::max(room.left(), room.right() - size.width()));
    const QPoint places[] = {
        {part.right() + gap, top},
        {part.left() - gap - size.width(), top},
        {left, part.bottom() + gap},
        {left, part.top() - gap - size.height()},
        {left, std::clamp(part.center().y(), room.top(), room.bottom() - size.height())}};
    for (const QPoint &place : places) {
        if (room.contains(QRect(place, size)) || place == places[4]) {
            m_card->setGeometry(QRect(place, size));
            return;
        }
    }
}

bool Tour::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize) {
        setGeometry(parentWidget()->rect());
        placeCard();
    }
    return QWidget::eventFilter(watched, event);
}

void Tour::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath around;
    around.addRect(rect());
    QPainterPath hole;
    hole.addRoundedRect(partRect().adjusted(-2, -2, 2, 2), 6, 6);
    QColor dark(Qt::black);
    dark.setAlphaF(shade);
    painter.fillPath(around.subtracted(hole), dark);
    painter.setPen(QPen(theme().accent, 3.0));
    painter.drawPath(hole);
}

void Tour::mousePressEvent(QMouseEvent *event)
{
    event->accept(); // what lies beneath waits
}

void Tour::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape)
        return end();
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        return next();
    QWidget::keyPressEvent(event);
}

/// The keyboard stays here until it ends.
bool Tour::focusNextPrevChild(bool)
{
    QPushButton *other = m_next->hasFocus() && m_skip->isVisible() ? m_skip : m_next;
    other->setFocus(Qt::TabFocusReason);
    return true;
}

} // namespace cradle
