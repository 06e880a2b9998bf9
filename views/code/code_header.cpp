// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/code_header.h"

#include "views/action_button.h"
#include "views/code/code_actions.h"
#include "views/menu.h"
#include "views/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include <algorithm>

namespace cradle {

namespace {

constexpr int gap = 8;         ///< px
constexpr int sideMargin = 12; ///< px
constexpr int shortState = 90; ///< px; what a state has at least, though cut off

} // namespace

CodeHeader::CodeHeader(CodeActions &actions, QWidget *parent)
    : QWidget(parent)
    , m_title(new QLabel(this))
    , m_atOnce(new QPushButton(this))
    , m_state(new QLabel(this))
    , m_more(new QPushButton(this))
    , m_row(new QHBoxLayout)
    , m_lower(new QHBoxLayout)
{
    QFont bold = m_title->font();
    bold.setWeight(QFont::DemiBold);
    m_title->setFont(bold);
    m_title->setTextFormat(Qt::PlainText);
    m_state->setTextFormat(Qt::PlainText);
    m_state->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_state->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    setKind(m_state, "muted");
    auto *rows = new QVBoxLayout(this);
    rows->setContentsMargins(sideMargin, 5, 8, 6);
    rows->setSpacing(0);
    rows->setSizeConstraint(QLayout::SetNoConstraint);
    for (QHBoxLayout *row : {m_row, m_lower}) {
        row->setSpacing(gap);
        rows->addLayout(row);
    }
    const auto add = [this](QAction *action, const QString &name, IconTint tint) {
        auto *button = new ActionButton(action, this);
        button->setIconName(name, tint);
        button->setIconSize(iconSquare(16));
        setKind(button, "small");
        m_row->addWidget(button);
        return button;
    };
    m_row->addWidget(m_title);
    auto *run = add(actions.run, QStringLiteral("run"), IconTint::Accent);
    m_row->addWidget(m_atOnce);
    auto *step = add(actions.stepLine, QStringLiteral("next"), IconTint::Text);
    auto *finish = add(actions.finishStep, QStringLiteral("step"), IconTint::Text);
    m_row->addWidget(m_state, 1);
    m_row->addStretch();
    m_row->addWidget(m_more);
    m_buttons = {finish, step, run};

    auto *menu = new Menu(m_more);
    actions.fillMenu(menu);
    m_more->setMenu(menu);
    m_more->setFocusPolicy(Qt::TabFocus);
    setKind(m_more, "menu");
    m_atOnce->setFocusPolicy(Qt::TabFocus);
    m_atOnce->setCheckable(true);
    m_atOnce->setIconSize(iconSquare(16));
    setKind(m_atOnce, "small");
    // A sign besides the colour.
    const auto showChecked = [this](bool checked) {
        m_atOnce->setIcon(checked ? icon(u"check", IconTint::Accent)
                                  : icon(u"failed", IconTint::Muted));
    };
    connect(m_atOnce, &QPushButton::toggled, this, showChecked);
    showChecked(false);
    setKind(m_more, "small");
    retranslate();
}

void CodeHeader::setTitle(const QString &title)
{
    m_title->setText(title);
    m_title->setVisible(!title.isEmpty()); // else a screen reader meets a text without words
    arrange();
}

void CodeHeader::setStates(const QStringList &texts)
{
    m_states = texts;
    arrange();
}

void CodeHeader::setState(const QString &text, bool warns)
{
    m_stateText = text;
    setKind(m_state, warns ? "warning" : "muted");
    arrange();
}

void CodeHeader::retranslate()
{
    m_atOnce->setText(tr("Run as I type"));
    m_atOnce->setAccessibleName(m_atOnce->text());
    m_atOnce->setToolTip(tr("Run every change at once, as long as the program parses"));
    m_more->setText(tr("More"));
    m_more->setAccessibleName(tr("More for the program"));
    arrange();
}

/// Takes the text from as many buttons as needed for the longest state to be read. Where not even
/// the usual one has room, it stands below. What is done does not depend on the state of the
/// moment: that changes with every letter typed.
void CodeHeader::arrange()
{
    if (m_arranging)
        return;
    m_arranging = true;
    const auto widthOf = [this](const QString &text) {
        return m_state->fontMetrics().horizontalAdvance(text) + 2;
    };
    int longest = shortState;
    for (const QString &text : m_states)
        longest = std::max(longest, widthOf(text));
    for (ActionButton *button : m_buttons)
        button->setCollapsed(true);
    measureAnew();
    const bool two = minimumSizeHint().width() + widthOf(m_states.value(0)) > width();
    putInRows(two);
    spread(two ? 0 : longest);
    layout()->activate();
    // Where all of it does not fit, what comes before the colon says the most.
    const QFontMetrics metrics = m_state->fontMetrics();
    const bool fits = metrics.horizontalAdvance(m_stateText) <= m_state->width();
    const QString shown = metrics.elidedText(fits ? m_stateText : m_stateText.section(u':', 0, 0),
                                             Qt::ElideRight, m_state->width());
    m_state->setText(shown);
    m_state->setToolTip(shown == m_stateText ? QString() : m_stateText);
    m_state->setAccessibleName(m_stateText);
    m_arranging = false;
}

void CodeHeader::putInRows(bool two)
{
    if (two == isInTwoRows())
        return;
    if (two) {
        m_lower->addWidget(m_atOnce);
        m_lower->addWidget(m_state, 1);
    } else {
        m_row->insertWidget(m_row->indexOf(m_buttons.back()) + 1, m_atOnce);
        m_row->insertWidget(m_row->indexOf(m_more) - 1, m_state, 1); // before the stretch
    }
}

/// Gives the buttons their texts, but for those that must go for the state to have \p room px.
void CodeHeader::spread(int room)
{
    for (ActionButton *button : m_buttons)
        button->setCollapsed(false);
    for (ActionButton *button : m_buttons) {
        measureAnew();
        const bool last = button == m_buttons.back();
        if (layout()->minimumSize().width() + (last ? std::min(room, shortState) : room) <= width())
            break;
        button->setCollapsed(true);
    }
    measureAnew();
}

void CodeHeader::measureAnew()
{
    m_row->invalidate();
    m_lower->invalidate();
    layout()->invalidate();
}

QSize CodeHeader::minimumSizeHint() const
{
    const QMargins margins = layout()->contentsMargins();
    int width = margins.left() + m_row->minimumSize().width() + margins.right();
    for (const ActionButton *button : m_buttons)
        width -= button->spareWidth();
    // The pane is no narrower with two rows: what stands below needs that width, too.
    if (isInTwoRows())
        width += m_atOnce->sizeHint().width() + 2 * gap; // before it and the state
    return {width, layout()->minimumSize().height()};
}

void CodeHeader::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    arrange();
}

bool CodeHeader::event(QEvent *event)
{
    const bool done = QWidget::event(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        arrange();
    return done;
}

void CodeHeader::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setPen(theme().border);
    painter.drawLine(0, height() - 1, width(), height() - 1);
}

} // namespace cradle
