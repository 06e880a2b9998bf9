// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/check_row.h"

#include "views/icons.h"
#include "views/task_pane/message_text.h"
#include "views/theme.h"

#include <QGridLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace cradle {

namespace {

/// A label that draws an icon in the colours of the theme in force.
class GlyphLabel final : public QWidget
{
public:
    GlyphLabel(const QIcon &glyph, QWidget *parent)
        : QWidget(parent)
        , m_glyph(glyph)
    {
        setFixedSize(18, 20);
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        m_glyph.paint(&painter, rect());
    }

private:
    QIcon m_glyph;
};

} // namespace

bool hasMoment(const CheckOutcome &outcome)
{
    return outcome.scene.has_value() && outcome.step > 0;
}

QPushButton *makeMomentLink()
{
    auto *link = new QPushButton(CheckRow::tr("Show the moment ▸"));
    link->setAccessibleName(CheckRow::tr("Show the moment"));
    setKind(link, "link");
    return link;
}

CheckRow::CheckRow(const CheckOutcome &outcome, QWidget *parent)
    : QWidget(parent)
    , m_outcome(outcome)
{
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(0);
    grid->setColumnStretch(1, 1);
    const QIcon glyph =
        outcome.passed ? icon(u"passed", IconTint::Success) : icon(u"failed", IconTint::Warning);
    auto *title = new QLabel(withUnits(outcome.title), this);
    title->setWordWrap(true);
    title->setTextFormat(Qt::PlainText);
    title->setAccessibleName(
        (outcome.passed ? tr("Passed: %1") : tr("Failed: %1")).arg(outcome.title));
    grid->addWidget(new GlyphLabel(glyph, this), 0, 0, Qt::AlignTop);
    grid->addWidget(title, 0, 1);
    if (outcome.passed && !outcome.forTeacher)
        return;
    if (!outcome.passed)
        setKind(title, "warning");
    addObserved(outcome);
}

/// What was observed, beneath the title, and the button that opens it.
void CheckRow::addObserved(const CheckOutcome &outcome)
{
    auto *observed = new QWidget(this);
    observed->hide();
    auto *column = new QVBoxLayout(observed);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto *message = new QLabel(asSentence(outcome.message), observed);
    message->setWordWrap(true);
    message->setTextFormat(Qt::PlainText);
    message->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(message);
    if (hasMoment(outcome)) {
        QPushButton *link = makeMomentLink();
        column->addWidget(link, 0, Qt::AlignLeft);
        connect(link, &QPushButton::clicked, this, [this, outcome] { emit showMoment(outcome); });
    }
    m_expand = new QToolButton(this);
    m_expand->setAutoRaise(true);
    m_expand->setCheckable(true);
    m_expand->setIcon(openingIcon(false));
    m_expand->setToolTip(tr("Show what was observed"));
    m_expand->setAccessibleName(tr("Show what was observed: %1").arg(outcome.title));
    setKind(m_expand, "tiny");
    connect(m_expand, &QToolButton::toggled, observed, [this, observed](bool open) {
        observed->setVisible(open);
        m_expand->setIcon(openingIcon(open));
    });
    auto *grid = static_cast<QGridLayout *>(layout());
    grid->addWidget(m_expand, 0, 2, Qt::AlignTop);
    grid->addWidget(observed, 1, 1, 1, 2);
    setCursor(Qt::PointingHandCursor);
    observed->setCursor(Qt::ArrowCursor);
    message->setCursor(Qt::IBeamCursor);
}

void CheckRow::mousePressEvent(QMouseEvent *event)
{
    event->setAccepted(m_expand && event->button() == Qt::LeftButton);
}

void CheckRow::mouseReleaseEvent(QMouseEvent *event)
{
    if (!m_expand || event->button() != Qt::LeftButton || !rect().contains(event->pos()))
        return;
    m_expand->toggle();
    if (m_expand->isChecked() && hasMoment(m_outcome))
        emit showMoment(m_outcome);
}

} // namespace cradle
