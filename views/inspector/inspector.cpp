// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspector/inspector.h"

#include "views/inspector/circles_group.h"
#include "views/inspector/laws_group.h"
#include "views/inspector/world_group.h"
#include "views/theme.h"

#include <QEvent>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

namespace cradle {

namespace {

constexpr int groupMargin = 12;  ///< px
constexpr int scrollBar = 10;    ///< px, where the groups are higher than the pane
constexpr int groupGap = 24;     ///< px between World and Laws
constexpr int besideTable = 640; ///< px that the table wants beside the other groups

QLabel *footLine(QWidget *parent, const char *kind)
{
    auto *label = new QLabel(parent);
    label->setWordWrap(true);
    label->setContentsMargins(groupMargin, 0, groupMargin, 6);
    setKind(label, kind);
    label->hide();
    return label;
}

} // namespace

Inspector::Inspector(PresetDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
{
    makeLayout();
    retranslate();
    showReadOnly();
    showStartNote();
    connect(&document, &PresetDocument::refused, this, &Inspector::showRefusal);
    connect(&document.simulation(), &Simulation::presetChanged, this, &Inspector::clearRefusal);
    connect(&document.simulation(), &Simulation::presetChanged, this, &Inspector::showReadOnly);
    connect(&document, &PresetDocument::lockedChanged, this, &Inspector::showReadOnly);
    connect(&document.simulation(), &Simulation::frameReady, this, &Inspector::showStartNote);
    connect(m_world, &WorldGroup::notANumber, this, &Inspector::showNotANumber);
    connect(m_circles, &CirclesGroup::notANumber, this, &Inspector::showNotANumber);
    connect(m_world, &WorldGroup::reverted, this, &Inspector::clearRefusal);
    connect(m_circles, &CirclesGroup::reverted, this, &Inspector::clearRefusal);
    connect(m_circles, &CirclesGroup::selectionChanged, this, &Inspector::selectionChanged);
}

void Inspector::makeLayout()
{
    auto *content = new QWidget;
    m_world = new WorldGroup(m_document, content);
    m_laws = new LawsGroup(m_document, content);
    m_circles = new CirclesGroup(m_document, content);
    m_groups = new QBoxLayout(QBoxLayout::TopToBottom, content);
    m_groups->setContentsMargins(groupMargin, 8, groupMargin, 0);
    m_groups->setSpacing(6);
    m_top = new QBoxLayout(QBoxLayout::LeftToRight);
    m_top->addWidget(m_world);
    m_top->addWidget(m_laws);
    m_top->addStretch(1);
    m_groups->addLayout(m_top);
    m_groups->addWidget(m_circles, 1);

    auto *scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(content);
    m_refusal = footLine(this, "warning");
    m_readOnly = footLine(this, "muted");
    m_startNote = footLine(this, "muted");
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(scroll, 1);
    column->addWidget(m_refusal);
    column->addWidget(m_readOnly);
    column->addWidget(m_startNote);
}

void Inspector::hideReset()
{
    m_circles->hideReset();
}

int Inspector::selected() const
{
    return m_circles->selected();
}

void Inspector::select(int circle)
{
    m_circles->select(circle);
}

void Inspector::retranslate()
{
    setAccessibleName(tr("Inspector"));
    m_startNote->setText(tr("These values are the start of the run."));
    showReadOnly();
    arrange();
}

void Inspector::showRefusal(const Error &error)
{
    m_refusal->setText(tr("Not possible: %1.").arg(error.message));
    m_refusal->show();
    m_circles->setFault(error.pointer);
}

void Inspector::showNotANumber(const QString &text)
{
    m_refusal->setText(
        tr("“%1” is not a number; 0.5, 1e-3 or 1/240 would be right.").arg(text.simplified()));
    m_refusal->show();
}

void Inspector::clearRefusal()
{
    m_refusal->hide();
    m_circles->setFault({});
}

void Inspector::showReadOnly()
{
    const QString why = m_document.whyReadOnly();
    m_readOnly->setText(why + QLatin1Char('.'));
    m_readOnly->setVisible(!why.isEmpty());
}

void Inspector::showStartNote()
{
    m_startNote->setVisible(!m_document.simulation().atStart());
}

/// The table beside the other groups where there is room for both; fields of the world in one
/// column where two do not fit, and the groups below one another where even that is too wide, each
/// as low as its width allows, so that the table stays in sight.
void Inspector::arrange()
{
    const int laws = m_laws->columnWidth();
    const int oneRow = m_world->twoColumnWidth() + groupGap + laws + 2 * groupMargin;
    m_world->arrange(oneRow <= width() ? WorldGroup::TwoColumns : WorldGroup::OneColumn);
    const bool sideBySide =
        m_world->sizeHint().width() + groupGap + laws + 2 * groupMargin <= width();
    if (sideBySide) {
        m_laws->arrange(LawsGroup::Column);
    } else {
        const int room = width() - 2 * groupMargin - scrollBar;
        m_laws->arrange(m_laws->rowWidth() <= room            ? LawsGroup::Row
                        : m_laws->headedColumnWidth() <= room ? LawsGroup::HeadedColumn
                        : laws <= room                        ? LawsGroup::Column
                                                              : LawsGroup::OwnRows);
        m_world->arrange(m_world->twoColumnWidth() <= room ? WorldGroup::TwoColumns
                                                           : WorldGroup::OneColumn);
        if (m_world->sizeHint().width() > room)
            m_world->arrange(WorldGroup::OwnRows);
    }
    m_top->setDirection(sideBySide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_top->setSpacing(sideBySide ? groupGap : 6);
    m_top->setAlignment(m_laws, sideBySide ? Qt::Alignment() : Qt::AlignLeft);
    const bool beside = width() >= oneRow + groupGap + besideTable;
    m_groups->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_groups->setSpacing(beside ? groupGap : 6);
}

void Inspector::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    arrange();
}

void Inspector::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        // Its groups learn of the language, and of their widths, after it.
        QMetaObject::invokeMethod(this, &Inspector::arrange, Qt::QueuedConnection);
    }
}

} // namespace cradle
