// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspector/circles_group.h"

#include "views/circle_edits.h"
#include "views/icons.h"
#include "views/inspector/circle_delegate.h"
#include "views/inspector/circle_header.h"
#include "views/inspector/circle_table_model.h"
#include "views/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>

namespace cradle {

namespace {

constexpr int rowsAtLeast = 2; ///< that can be seen

} // namespace

CirclesGroup::CirclesGroup(PresetDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    makeButtons();
    makeTable();
    retranslate();
    reload();
    connect(&document.simulation(), &Simulation::presetChanged, this, &CirclesGroup::reload);
    connect(&document, &PresetDocument::lockedChanged, this, &CirclesGroup::reload);
}

void CirclesGroup::makeButtons()
{
    auto *row = new QHBoxLayout;
    row->setSpacing(8);
    m_strut = new QSpacerItem(0, 0);
    row->addItem(m_strut);
    m_heading = new QLabel(this);
    m_heading->setFont(headingFont());
    setKind(m_heading, "heading");
    row->addWidget(m_heading);
    row->addStretch(1);
    const auto make = [&](const QString &iconName) {
        auto *button = new QPushButton(icon(iconName), QString(), this);
        setKind(button, "small");
        row->addWidget(button);
        return button;
    };
    m_add = make(QStringLiteral("add"));
    m_duplicate = make(QStringLiteral("duplicate"));
    m_remove = make(QStringLiteral("remove"));
    m_reset = make(QStringLiteral("reset"));
    static_cast<QVBoxLayout *>(layout())->addLayout(row);
    connect(m_add, &QPushButton::clicked, this, &CirclesGroup::addCircle);
    connect(m_duplicate, &QPushButton::clicked, this, &CirclesGroup::duplicate);
    connect(m_remove, &QPushButton::clicked, this, &CirclesGroup::remove);
    connect(m_reset, &QPushButton::clicked, &m_document, &PresetDocument::resetToOriginal);
}

void CirclesGroup::makeTable()
{
    m_model = new CircleTableModel(m_document, this);
    m_delegate = new CircleDelegate(this);
    m_table = new QTableView(this);
    m_table->setLayoutDirection(Qt::LeftToRight); // else signs and units change sides
    m_header = new CircleHeader(m_table);
    m_table->setModel(m_model);
    m_table->setItemDelegate(m_delegate);
    m_table->setHorizontalHeader(m_header);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->verticalHeader()->setDefaultSectionSize(scaledByText(rowHeight));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setTabKeyNavigation(false); // Tab leaves it
    m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed
                             | QAbstractItemView::AnyKeyPressed
                             | QAbstractItemView::SelectedClicked);
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    fitHeight();
    m_table->installEventFilter(this);
    m_table->viewport()->installEventFilter(this);
    layout()->addWidget(m_table);
    connect(m_delegate, &CircleDelegate::notANumber, this, &CirclesGroup::notANumber);
    connect(m_delegate, &CircleDelegate::reverted, this, &CirclesGroup::reverted);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        enableButtons();
        if (std::exchange(m_announced, selected()) != selected())
            emit selectionChanged(selected());
    });
}

void CirclesGroup::fitHeight()
{
    m_table->setMinimumHeight(m_header->sizeHint().height()
                              + rowsAtLeast * scaledByText(rowHeight));
}

void CirclesGroup::retranslate()
{
    m_heading->setText(tr("Circles"));
    m_table->setAccessibleName(tr("Circles"));
    const auto name = [](QPushButton *button, const QString &text, const QString &tip) {
        button->setToolTip(tip);
        button->setAccessibleName(text);
    };
    name(m_add, tr("Add circle"), tr("Add a circle at a free place"));
    name(m_duplicate, tr("Duplicate"), tr("Add a copy of the selected circle"));
    name(m_remove, tr("Remove"), tr("Remove the selected circle (Delete)"));
    name(m_reset, tr("Reset to the step's scene"),
         tr("Bring back the scene that the step came with; Undo takes it back"));
    nameButtons();
    m_model->retranslate();
    layOutColumns();
}

/// Writes on as many buttons what they do as there is room for.
void CirclesGroup::nameButtons()
{
    QPushButton *const buttons[] = {m_add, m_duplicate, m_remove, m_reset};
    for (QPushButton *button : buttons)
        button->setText(button->accessibleName());
    // The style sheet's least height is less than large texts need.
    m_strut->changeSize(0, m_add->sizeHint().height(), QSizePolicy::Fixed, QSizePolicy::Fixed);
    layout()->invalidate();
    for (QPushButton *button : buttons) {
        int wanted = m_heading->sizeHint().width();
        for (const QPushButton *each : buttons)
            wanted += each->isHidden() ? 0 : each->sizeHint().width() + 8;
        if (wanted <= width())
            return;
        button->setText(QString());
    }
}

void CirclesGroup::reload()
{
    m_model->reload();
    layOutColumns();
    enableButtons();
}

void CirclesGroup::enableButtons()
{
    const bool open = m_document.whyLocked(QStringLiteral("circles")).isEmpty();
    m_add->setEnabled(open);
    m_duplicate->setEnabled(open && selected() >= 0);
    m_remove->setEnabled(open && selected() >= 0);
    m_reset->setEnabled(!m_document.isOriginal() && m_document.whyReadOnly().isEmpty());
}

void CirclesGroup::hideReset()
{
    m_reset->hide();
    nameButtons();
}

int CirclesGroup::selected() const
{
    const QModelIndexList rows = m_table->selectionModel()->selectedRows();
    return rows.isEmpty() ? -1 : rows.front().row();
}

void CirclesGroup::select(int circle)
{
    if (circle == selected())
        return;
    if (circle < 0 || circle >= m_model->rowCount()) {
        m_table->clearSelection();
        return;
    }
    const int column = std::max(m_table->currentIndex().column(), int{CircleTableModel::Name});
    m_table->setCurrentIndex(m_model->index(circle, column));
    m_table->selectRow(circle);
}

void CirclesGroup::setFault(const QString &pointer)
{
    m_model->setFault(pointer);
}

/// Selects the last circle without a move of the table to the side.
void CirclesGroup::selectLast()
{
    const int left = m_table->horizontalScrollBar()->value();
    select(m_model->rowCount() - 1);
    m_table->horizontalScrollBar()->setValue(left);
}

void CirclesGroup::addCircle()
{
    if (m_document.edit(tr("Add circle"), withAddedCircle(m_document.preset())))
        selectLast();
}

void CirclesGroup::duplicate()
{
    const int circle = selected();
    if (circle >= 0
        && m_document.edit(tr("Duplicate circle"), withDuplicate(m_document.preset(), circle)))
        selectLast();
}

void CirclesGroup::remove()
{
    const int circle = selected();
    if (circle < 0)
        return;
    m_document.edit(tr("Remove circle"), withoutCircle(m_document.preset(), circle));
    select(std::min(circle, m_model->rowCount() - 1));
}

/// Delete removes a circle; Space and Return, which belong to shortcuts, begin no text.
bool CirclesGroup::handleKey(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Delete:
        remove();
        return true;
    case Qt::Key_Space:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        event->ignore();
        return true;
    default:
        return false;
    }
}

bool CirclesGroup::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize && watched == m_table->viewport())
        layOutColumns();
    if (watched == m_table && event->type() == QEvent::KeyPress)
        return handleKey(static_cast<QKeyEvent *>(event));
    return QWidget::eventFilter(watched, event);
}

/// Without the texts of the buttons where they do not fit.
void CirclesGroup::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    nameButtons();
}

QSize CirclesGroup::minimumSizeHint() const
{
    constexpr int narrowest = 280; // px; the table scrolls
    return {narrowest, QWidget::minimumSizeHint().height()};
}

void CirclesGroup::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::FontChange) {
        m_table->verticalHeader()->setDefaultSectionSize(scaledByText(rowHeight));
        layOutColumns();
        // The header and the buttons have the new font a little later.
        QMetaObject::invokeMethod(this, &CirclesGroup::fitHeight, Qt::QueuedConnection);
        QMetaObject::invokeMethod(this, &CirclesGroup::nameButtons, Qt::QueuedConnection);
    }
}

} // namespace cradle
