// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How the controls of the bar stand in a row, and what they give up where it is narrow.
#include "views/action_button.h"
#include "views/theme.h"
#include "views/transport_bar.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>

#include <algorithm>

namespace cradle {

namespace {

constexpr int speedWidth = 104; ///< px
constexpr int leastSpeedWidth = 56;
constexpr int spacing = 8; ///< px between controls
constexpr int leastSpacing = 4;
constexpr int sideMargin = 12; ///< px
constexpr int topMargin = 8;
constexpr double leastReadout = 0.7;   ///< of the usual size, and never smaller than small texts
constexpr std::size_t mainButtons = 2; ///< Run and Check keep their texts the longest

} // namespace

void TransportBar::makeLayout()
{
    auto *row = new QHBoxLayout(this);
    row->setSizeConstraint(QLayout::SetNoConstraint);
    m_order = new QHBoxLayout;
    row->addLayout(m_order);
    turnOrder();
    const auto add = [this](QBoxLayout *place, QAction *action, const QString &iconName,
                            IconTint tint) {
        auto *button = new ActionButton(action, this);
        button->setIconName(iconName, tint);
        place->addWidget(button);
        return button;
    };
    auto *restart = add(m_order, m_restart, QStringLiteral("restart"), IconTint::Text);
    auto *stepBack = add(m_order, m_stepBack, QStringLiteral("step-back"), IconTint::Text);
    m_runButton = add(m_order, m_run, QStringLiteral("run"), IconTint::OnAccent);
    setKind(m_runButton, "primary");
    auto *step = add(m_order, m_step, QStringLiteral("step"), IconTint::Text);
    auto *previousHit = add(m_order, m_previousHit, QStringLiteral("previous-hit"), IconTint::Text);
    m_nextHitButton = add(m_order, m_nextHit, QStringLiteral("next-hit"), IconTint::Text);
    row->addSpacing(spacing);
    addReadout(row);
    row->addStretch(1);

    m_modes = new QWidget(this);
    m_modes->hide();
    m_modeGroup = new QButtonGroup(this);
    row->addWidget(m_modes);
    connect(m_modeGroup, &QButtonGroup::idClicked, this, &TransportBar::modeChosen);

    m_checkButton = add(row, m_check, QStringLiteral("check"), IconTint::OnAccent);
    setKind(m_checkButton, "success");
    m_progress = addProgress();
    m_searchProgress = addProgress();
    m_buttons = {previousHit, restart, stepBack, step, m_nextHitButton, m_runButton, m_checkButton};
}

/// The past stands left in every language, as on the timeline, under the arrow keys and in charts.
void TransportBar::turnOrder()
{
    m_order->setDirection(isRightToLeft() ? QBoxLayout::RightToLeft : QBoxLayout::LeftToRight);
}

/// A thin line, placed by hand beneath the button whose work it tells of.
QProgressBar *TransportBar::addProgress()
{
    auto *progress = new QProgressBar(this);
    progress->setRange(0, progressRange);
    progress->setTextVisible(false);
    progress->hide();
    return progress;
}

void TransportBar::setModes(const QStringList &titles, int current)
{
    const QList<QAbstractButton *> buttons = m_modeGroup->buttons();
    if (!titles.isEmpty() && buttons.size() == titles.size()) {
        // One of them may have been clicked just now, so they stay.
        for (qsizetype i = 0; i < titles.size(); ++i) {
            QAbstractButton *button = m_modeGroup->button(static_cast<int>(i));
            button->setText(titles[i]);
            button->setAccessibleName(titles[i]);
            button->setChecked(i == current);
        }
        collapse();
        return;
    }
    for (QAbstractButton *button : buttons) {
        button->hide();
        button->deleteLater();
        m_modeGroup->removeButton(button);
    }
    delete m_modes->layout();
    auto *row = new QHBoxLayout(m_modes);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    for (qsizetype i = 0; i < titles.size(); ++i) {
        auto *button = new QPushButton(titles[i], m_modes);
        button->setCheckable(true);
        button->setChecked(i == current);
        button->setFocusPolicy(Qt::TabFocus);
        button->setAccessibleName(titles[i]);
        setKind(button, "segment");
        m_modeGroup->addButton(button, static_cast<int>(i));
        row->addWidget(button);
    }
    m_modes->setVisible(titles.size() > 1);
    collapse();
}

/// Gives every control all that it can use.
void TransportBar::spread()
{
    for (ActionButton *button : m_buttons)
        button->setCollapsed(false);
    m_speedCaption->show();
    m_speed->setFixedWidth(speedWidth);
    setSpacing(spacing, sideMargin);
    setReadoutSize(1.0);
    relayout();
}

void TransportBar::setSpacing(int between, int beside)
{
    layout()->setSpacing(between);
    layout()->setContentsMargins(beside, topMargin, beside, topMargin);
}

void TransportBar::relayout()
{
    m_order->invalidate();
    layout()->invalidate();
    layout()->activate();
}

/// Makes the slider of the speed shorter, takes the text from as many buttons as needed for the row
/// to fit, and room and size from all else before Run and Check lose theirs.
void TransportBar::collapse()
{
    const auto isTooNarrow = [this] { return layout()->minimumSize().width() > width(); };
    const auto takeTexts = [&](std::size_t from, std::size_t to) {
        for (; from < to && isTooNarrow(); ++from) {
            m_buttons[from]->setCollapsed(true);
            relayout();
        }
    };
    const std::size_t others = m_buttons.size() - mainButtons;
    spread();
    if (isTooNarrow()) {
        m_speedCaption->hide();
        m_speed->setFixedWidth(leastSpeedWidth);
        relayout();
    }
    takeTexts(0, others);
    if (isTooNarrow()) {
        setSpacing(leastSpacing, leastSpacing);
        relayout();
    }
    if (isTooNarrow()) {
        setReadoutSize(std::max(leastReadout, 1.0 / textScale()));
        relayout();
    }
    takeTexts(others, m_buttons.size());
    const auto placeBeneath = [](QProgressBar *progress, const ActionButton *button) {
        const QRect place = button->geometry();
        progress->setGeometry(place.left(), place.bottom() + 3, place.width(), 3);
    };
    placeBeneath(m_progress, m_checkButton);
    placeBeneath(m_searchProgress, m_nextHitButton);
}

QSize TransportBar::minimumSizeHint() const
{
    int width = layout()->minimumSize().width();
    for (const ActionButton *button : m_buttons)
        width -= button->spareWidth();
    if (!m_speedCaption->isHidden())
        width -= m_speedCaption->sizeHint().width();
    return {width, layout()->minimumSize().height()};
}

} // namespace cradle
