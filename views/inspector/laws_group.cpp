// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspector/laws_group.h"

#include "views/choice_box.h"
#include "views/law_names.h"
#include "views/on_change.h"
#include "views/theme.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>

#include <algorithm>
#include <utility>
#include <vector>

namespace cradle {

namespace {

constexpr int gap = 8; ///< px between two columns

/// Names the items in the order of the enumeration, each with a sentence on what it does.
void setItems(QComboBox *list, const std::vector<std::pair<QString, QString>> &items)
{
    for (int i = 0; i < static_cast<int>(items.size()); ++i) {
        const auto &[text, tip] = items[static_cast<std::size_t>(i)];
        if (i >= list->count())
            list->addItem(text);
        list->setItemText(i, text);
        list->setItemData(i, tip, Qt::ToolTipRole);
    }
}

void showItem(QComboBox *list, int index)
{
    list->setCurrentIndex(index);
    list->setToolTip(list->itemData(index, Qt::ToolTipRole).toString());
}

} // namespace

LawsGroup::LawsGroup(PresetDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
{
    m_heading = new QLabel(this);
    m_heading->setFont(headingFont());
    setKind(m_heading, "heading");
    m_grid = new QGridLayout(this);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(gap);
    m_grid->setVerticalSpacing(4);
    int row = 0;
    for (QComboBox **list : {&m_walls, &m_circles, &m_timing}) {
        *list = new ChoiceBox(this);
        (*list)->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
        (*list)->installEventFilter(this);
        m_captions[row] = new QLabel(this);
        m_captions[row]->setBuddy(*list);
        ++row;
    }
    arrange(Column);
    keepTranslated(this, &LawsGroup::retranslate);
    connect(m_walls, &QComboBox::activated, this, [this](int index) {
        Laws laws = m_document.preset().laws;
        laws.walls = static_cast<WallLaw>(index);
        choose(tr("Change law for walls"), laws);
    });
    connect(m_circles, &QComboBox::activated, this, [this](int index) {
        Laws laws = m_document.preset().laws;
        laws.circles = static_cast<CircleLaw>(index);
        choose(tr("Change law for circles"), laws);
    });
    connect(m_timing, &QComboBox::activated, this, [this](int index) {
        Laws laws = m_document.preset().laws;
        laws.timing = static_cast<Timing>(index);
        choose(tr("Change timing"), laws);
    });
    connect(&document.simulation(), &Simulation::presetChanged, this, &LawsGroup::reload);
    connect(&document, &PresetDocument::lockedChanged, this, &LawsGroup::reload);
}

void LawsGroup::arrange(Arrangement arrangement)
{
    if (arrangement == m_arrangement)
        return;
    m_arrangement = arrangement;
    const bool isHeadedLeft = arrangement == Row || arrangement == HeadedColumn;
    m_grid->addWidget(m_heading, 0, 0, 1, isHeadedLeft ? 1 : 3);
    QComboBox *const lists[] = {m_walls, m_circles, m_timing};
    for (int i = 0; i < 3; ++i) {
        switch (arrangement) {
        case Column:
            m_grid->addWidget(m_captions[i], i + 1, 0);
            m_grid->addWidget(lists[i], i + 1, 1);
            break;
        case HeadedColumn:
            m_grid->addWidget(m_captions[i], i, 1);
            m_grid->addWidget(lists[i], i, 2);
            break;
        case Row:
            m_grid->addWidget(m_captions[i], 0, i + 1);
            m_grid->addWidget(lists[i], 1, i + 1);
            break;
        case OwnRows:
            m_grid->addWidget(m_captions[i], 2 * i + 1, 0, 1, 3);
            m_grid->addWidget(lists[i], 2 * i + 2, 0, 1, 3);
            break;
        }
    }
    m_grid->setRowStretch(4, arrangement == Column ? 1 : 0);
}

int LawsGroup::columnWidth() const
{
    int captions = 0;
    int choices = 0;
    const QComboBox *const lists[] = {m_walls, m_circles, m_timing};
    for (int i = 0; i < 3; ++i) {
        captions = std::max(captions, m_captions[i]->sizeHint().width());
        choices = std::max(choices, lists[i]->sizeHint().width());
    }
    return captions + gap + choices;
}

int LawsGroup::headedColumnWidth() const
{
    return m_heading->sizeHint().width() + gap + columnWidth();
}

int LawsGroup::rowWidth() const
{
    int width = m_heading->sizeHint().width() + 3 * gap;
    const QComboBox *const lists[] = {m_walls, m_circles, m_timing};
    for (int i = 0; i < 3; ++i)
        width += std::max(m_captions[i]->sizeHint().width(), lists[i]->sizeHint().width());
    return width;
}

void LawsGroup::choose(const QString &text, const Laws &laws)
{
    Preset changed = m_document.preset();
    changed.laws = laws;
    m_document.edit(text, changed);
    reload(); // a refused law goes back
}

void LawsGroup::retranslate()
{
    m_heading->setText(tr("Laws"));
    const std::pair<QComboBox *, QString> names[] = {
        {m_walls, tr("Walls")}, {m_circles, tr("Circles")}, {m_timing, tr("Timing")}};
    for (int i = 0; i < 3; ++i) {
        m_captions[i]->setText(names[i].second);
        names[i].first->setAccessibleName(tr("Law: %1").arg(names[i].second));
    }
    setItems(m_walls, {{nameOf(WallLaw::None), tr("Circles leave the square unhindered.")},
                       {nameOf(WallLaw::Reflect),
                        tr("A wall turns the part of the velocity that points into "
                           "it around, and multiplies it by e.")}});
    setItems(m_circles, {{nameOf(CircleLaw::None), tr("Circles pass through each other.")},
                         {nameOf(CircleLaw::Stop), tr("Circles that meet both stop.")},
                         {nameOf(CircleLaw::SwapVelocities),
                          tr("Circles that meet exchange their whole velocities.")},
                         {nameOf(CircleLaw::SwapNormal),
                          tr("Only the parts of the velocities along the line of "
                             "centres are exchanged; the parts across it stay.")},
                         {nameOf(CircleLaw::Impulse),
                          tr("An impulse along the line of centres keeps the momentum, with "
                             "the masses and the restitution e.")}});
    setItems(m_timing, {{nameOf(Timing::Discrete),
                         tr("After each step overlaps are looked for; on a hit the circles go "
                            "back to their old positions and respond.")},
                        {nameOf(Timing::Continuous),
                         tr("The time of a hit inside the step is found, and the rest of "
                            "the step is spent after it.")},
                        {nameOf(Timing::Exact),
                         tr("The motion is solved from hit to hit; the timestep only says when "
                            "to look.")}});
    reload();
}

void LawsGroup::reload()
{
    const Laws &laws = m_document.preset().laws;
    showItem(m_walls, static_cast<int>(laws.walls));
    showItem(m_circles, static_cast<int>(laws.circles));
    showItem(m_timing, static_cast<int>(laws.timing));
    const std::pair<QComboBox *, QString> locks[] = {
        {m_walls, m_document.whyLocked(QStringLiteral("laws/walls"))},
        {m_circles, m_document.whyLocked(QStringLiteral("laws/circles"))},
        {m_timing, m_document.whyLocked(QStringLiteral("laws/timing"))}};
    for (const auto &[list, why] : locks) {
        list->setEnabled(why.isEmpty());
        if (!why.isEmpty())
            list->setToolTip(why);
    }
}

/// The wheel scrolls the pane; laws change only when asked.
bool LawsGroup::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Wheel) {
        event->ignore();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace cradle
