// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/step_dots.h"

#include "views/theme.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace cradle {

namespace {

constexpr double side = 12.0;       ///< px before the first dot and behind the last
constexpr double usual = 12.0;      ///< px, the diameter of a dot at the usual size of texts
constexpr double widestStep = 18.0; ///< px from one dot to the next, likewise
constexpr double narrowest = 13.0;  ///< px, of any size
constexpr double leastGap = 4.0;    ///< px between two dots
constexpr int rowHeight = 26;       ///< px, at the usual size of texts

void drawTick(QPainter &painter, const QRectF &dot, const QColor &colour)
{
    const double scale = dot.width() / usual;
    painter.setPen(QPen(colour, 1.6 * scale, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const QPointF c = dot.center();
    painter.drawPolyline(QPolygonF{c + scale * QPointF(-2.8, 0.2), c + scale * QPointF(-0.8, 2.2),
                                   c + scale * QPointF(2.8, -2.0)});
}

bool usesKey(int key)
{
    return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Home || key == Qt::Key_End
           || key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space;
}

} // namespace

StepDots::StepDots(QWidget *parent)
    : QWidget(parent)
{
    setFocusPolicy(Qt::TabFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void StepDots::setSteps(const QStringList &titles, const std::vector<bool> &passed, int current)
{
    m_titles = titles;
    m_passed = passed;
    m_passed.resize(static_cast<std::size_t>(titles.size()));
    m_current = current;
    m_marked = -1;
    describe();
    update();
}

QSize StepDots::sizeHint() const
{
    return {static_cast<int>(2.0 * side + narrowest * std::max(1, count())),
            scaledByText(rowHeight)};
}

QRectF StepDots::dotRect(int step) const
{
    const double pitch =
        std::min(widestStep * textScale(), (width() - 2.0 * side) / std::max(1, count()));
    const double diameter = std::clamp(pitch - leastGap, usual, usual * textScale());
    const double along = side + step * pitch;
    const bool mirrored = layoutDirection() == Qt::RightToLeft;
    return {mirrored ? width() - along - diameter : along, 0.5 * (height() - diameter), diameter,
            diameter};
}

int StepDots::stepAt(QPointF place) const
{
    for (int step = 0; step < count(); ++step) {
        const QRectF dot = dotRect(step);
        if (place.x() >= dot.left() - 0.5 && place.x() <= dot.right() + 0.5)
            return step;
    }
    return -1;
}

QString StepDots::textOf(int step) const
{
    const auto at = static_cast<std::size_t>(step);
    const QString state = m_passed[at]        ? tr("passed")
                          : step == m_current ? tr("current")
                                              : tr("open");
    return QStringLiteral("%1 · %2, %3").arg(step + 1).arg(m_titles[step], state);
}

void StepDots::describe()
{
    setAccessibleName(tr("Steps"));
    const int step = m_marked >= 0 ? m_marked : m_current;
    setAccessibleDescription(step >= 0 && step < count() ? textOf(step) : QString());
}

void StepDots::mark(int step)
{
    if (step == m_marked)
        return;
    m_marked = step;
    describe();
    update();
}

void StepDots::paintEvent(QPaintEvent *)
{
    const Theme &colours = theme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (int step = 0; step < count(); ++step) {
        const QRectF dot = dotRect(step);
        const bool passed = m_passed[static_cast<std::size_t>(step)];
        const bool current = step == m_current;
        if (current || (step == m_marked)) {
            painter.setPen(QPen(colours.accent, current ? 2.0 : 1.0));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(dot.adjusted(-1.0, -1.0, 1.0, 1.0));
        }
        const QRectF inner = dot.adjusted(1.5, 1.5, -1.5, -1.5);
        painter.setPen(passed || current ? QPen(Qt::NoPen) : QPen(colours.mutedText, 1.2));
        painter.setBrush(passed    ? QBrush(colours.success)
                         : current ? QBrush(colours.accent)
                                   : QBrush(Qt::NoBrush));
        painter.drawEllipse(passed ? dot.adjusted(0.5, 0.5, -0.5, -0.5) : inner);
        if (passed)
            drawTick(painter, dot, colours.panel);
    }
    if (hasFocus()) {
        painter.setPen(QPen(colours.accent, 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(rect()).adjusted(3.0, 1.0, -3.0, -1.0), 4.0, 4.0);
    }
}

bool StepDots::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto *help = static_cast<QHelpEvent *>(event);
        if (const int step = stepAt(help->pos()); step >= 0)
            QToolTip::showText(help->globalPos(), textOf(step), this);
        else
            QToolTip::hideText();
        return true;
    }
    if (event->type() == QEvent::LanguageChange)
        describe();
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        updateGeometry();
    // Its keys are those of the run elsewhere.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (key->modifiers() == Qt::NoModifier && usesKey(key->key())) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void StepDots::mousePressEvent(QMouseEvent *event)
{
    const int step = stepAt(event->position());
    if (event->button() == Qt::LeftButton && step >= 0)
        emit stepChosen(step);
}

void StepDots::mouseMoveEvent(QMouseEvent *event)
{
    mark(stepAt(event->position()));
    setCursor(m_marked >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void StepDots::leaveEvent(QEvent *)
{
    mark(hasFocus() ? std::max(0, m_current) : -1);
}

void StepDots::focusInEvent(QFocusEvent *event)
{
    QWidget::focusInEvent(event);
    mark(std::max(0, m_current));
}

void StepDots::keyPressEvent(QKeyEvent *event)
{
    const int last = count() - 1;
    const int from = m_marked >= 0 ? m_marked : std::max(0, m_current);
    const int right = layoutDirection() == Qt::RightToLeft ? -1 : 1;
    switch (event->key()) {
    case Qt::Key_Left:
        return mark(std::clamp(from - right, 0, std::max(0, last)));
    case Qt::Key_Right:
        return mark(std::clamp(from + right, std::min(0, last), std::max(0, last)));
    case Qt::Key_Home:
        return mark(std::min(0, last));
    case Qt::Key_End:
        return mark(last);
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
        if (m_marked >= 0)
            emit stepChosen(m_marked);
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace cradle
