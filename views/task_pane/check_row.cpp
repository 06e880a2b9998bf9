// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/check_row.h"

#include "views/icons.h"
#include "views/theme.h"

#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

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

CheckRow::CheckRow(const CheckOutcome &outcome, QWidget *parent)
    : QWidget(parent)
{
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(0);
    grid->setColumnStretch(1, 1);
    const QIcon glyph =
        outcome.passed ? icon(u"passed", IconTint::Success) : icon(u"failed", IconTint::Warning);
    auto *title = new QLabel(outcome.title, this);
    title->setWordWrap(true);
    title->setTextFormat(Qt::PlainText);
    title->setAccessibleName(
        (outcome.passed ? tr("Passed: %1") : tr("Failed: %1")).arg(outcome.title));
    grid->addWidget(new GlyphLabel(glyph, this), 0, 0, Qt::AlignTop);
    grid->addWidget(title, 0, 1);
    if (outcome.passed)
        return;
    setKind(title, "warning");
    auto *message = new QLabel(outcome.message, this);
    message->setWordWrap(true);
    message->setTextFormat(Qt::PlainText);
    message->setTextInteractionFlags(Qt::TextSelectableByMouse);
    message->hide();
    auto *expand = new QToolButton(this);
    expand->setAutoRaise(true);
    expand->setCheckable(true);
    expand->setIcon(icon(u"next", IconTint::Muted));
    expand->setToolTip(tr("Show what was observed"));
    expand->setAccessibleName(tr("Show what was observed: %1").arg(outcome.title));
    setKind(expand, "tiny");
    connect(expand, &QToolButton::toggled, message, [message, expand](bool open) {
        message->setVisible(open);
        expand->setIcon(icon(open ? u"expanded" : u"next", IconTint::Muted));
    });
    grid->addWidget(expand, 0, 2, Qt::AlignTop);
    grid->addWidget(message, 1, 1, 1, 2);
}

} // namespace cradle
