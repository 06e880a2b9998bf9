// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspector/circle_delegate.h"

#include "views/circle_edits.h"
#include "views/inspector/circle_table_model.h"
#include "views/inspector/number_field.h"
#include "views/law_names.h"
#include "views/theme.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QKeyEvent>
#include <QPainter>

namespace cradle {

namespace {

constexpr int swatchSize = 14; ///< px

void drawSwatch(QPainter *painter, const QRectF &place, const QString &colour)
{
    QRectF disc(0, 0, swatchSize, swatchSize);
    disc.moveCenter(place.center());
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(Qt::NoPen);
    painter->setBrush(circleColour(colour));
    painter->drawEllipse(disc);
}

QIcon swatchIcon(const QString &colour)
{
    QPixmap pixmap(2 * swatchSize, 2 * swatchSize);
    pixmap.setDevicePixelRatio(2.0);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    drawSwatch(&painter, QRectF(0, 0, swatchSize, swatchSize), colour);
    return {pixmap};
}

/// A list whose data are what the model takes.
QComboBox *createList(QWidget *parent, int column)
{
    auto *list = new QComboBox(parent);
    list->setProperty("cell", true);
    if (column == CircleTableModel::Colour) {
        for (const QString &colour : circleColours())
            list->addItem(swatchIcon(colour), QString(), colour);
        return list;
    }
    for (const Integrator integrator : allIntegrators)
        list->addItem(nameOf(integrator), static_cast<int>(integrator));
    return list;
}

} // namespace

void CircleDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                           const QModelIndex &index) const
{
    QStyleOptionViewItem plain = option;
    plain.state &= ~QStyle::State_HasFocus;
    QStyledItemDelegate::paint(painter, plain, index);
    painter->save();
    if (index.column() == CircleTableModel::Colour)
        drawSwatch(painter, option.rect, index.data(Qt::EditRole).toString());
    if (option.state & QStyle::State_HasFocus) {
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(QPen(theme().accent, 2));
        painter->setBrush(Qt::NoBrush);
        painter->drawRoundedRect(QRectF(option.rect).adjusted(1, 1, -1, -1), 4, 4);
    }
    painter->restore();
}

QWidget *CircleDelegate::createEditor(QWidget *parent, const QStyleOptionViewItem &option,
                                      const QModelIndex &index) const
{
    QWidget *editor = nullptr;
    if (CircleTableModel::isNumber(index.column())) {
        editor = createNumberField(parent, index);
    } else if (index.column() == CircleTableModel::Name) {
        editor = QStyledItemDelegate::createEditor(parent, option, index);
    } else {
        auto *list = createList(parent, index.column());
        connect(list, &QComboBox::activated, this, [this, list] {
            auto *self = const_cast<CircleDelegate *>(this);
            emit self->commitData(list);
            emit self->closeEditor(list);
        });
        editor = list;
    }
    editor->setAccessibleName(
        index.model()->headerData(index.column(), Qt::Horizontal, Qt::ToolTipRole).toString());
    return editor;
}

QWidget *CircleDelegate::createNumberField(QWidget *parent, const QModelIndex &index) const
{
    const int column = index.column();
    auto *field = new NumberField(QString(), CircleTableModel::spinStep(column), parent);
    field->setProperty("cell", true);
    field->setFont(numericFont());
    field->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    const QPersistentModelIndex cell(index);
    connect(field, &NumberField::valueProposed, this, [field, cell](double value, bool spinning) {
        auto *model = const_cast<QAbstractItemModel *>(cell.model());
        const int role = spinning ? int{CircleTableModel::spinningRole} : int{Qt::EditRole};
        if (!model->setData(cell, value, role))
            field->setRefused(true);
        else
            field->setValue(cell.data(Qt::EditRole).toDouble());
    });
    connect(field, &NumberField::notANumber, this, &CircleDelegate::notANumber);
    connect(field, &NumberField::reverted, this, &CircleDelegate::reverted);
    return field;
}

void CircleDelegate::setEditorData(QWidget *editor, const QModelIndex &index) const
{
    const QVariant value = index.data(Qt::EditRole);
    if (auto *field = qobject_cast<NumberField *>(editor)) {
        if (!field->isRefused() && !field->isProposing()) // what was typed stays
            field->setValue(value.toDouble());
    } else if (auto *list = qobject_cast<QComboBox *>(editor)) {
        list->setCurrentIndex(list->findData(value));
    } else {
        QStyledItemDelegate::setEditorData(editor, index);
    }
}

void CircleDelegate::setModelData(QWidget *editor, QAbstractItemModel *model,
                                  const QModelIndex &index) const
{
    if (auto *field = qobject_cast<NumberField *>(editor)) {
        if (!field->isRefused())
            field->propose();
    } else if (const auto *list = qobject_cast<QComboBox *>(editor)) {
        if (list->currentData().isValid())
            model->setData(index, list->currentData(), Qt::EditRole);
    } else {
        QStyledItemDelegate::setModelData(editor, model, index);
    }
}

void CircleDelegate::updateEditorGeometry(QWidget *editor, const QStyleOptionViewItem &option,
                                          const QModelIndex &index) const
{
    QStyledItemDelegate::updateEditorGeometry(editor, option, index);
    QRect place = option.rect;
    if (qobject_cast<QComboBox *>(editor))
        place.setWidth(std::max(place.width(), editor->sizeHint().width()));
    editor->setGeometry(place);
}

bool CircleDelegate::handleKey(NumberField *field, int key)
{
    using Hint = QAbstractItemDelegate::EndEditHint;
    switch (key) {
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
        if (field->propose())
            emit closeEditor(field,
                             key == Qt::Key_Tab ? Hint::EditNextItem : Hint::EditPreviousItem);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (field->propose())
            emit closeEditor(field, Hint::NoHint);
        return true;
    case Qt::Key_Escape:
        field->revert();
        emit closeEditor(field, Hint::RevertModelCache);
        return true;
    default:
        return false;
    }
}

bool CircleDelegate::eventFilter(QObject *watched, QEvent *event)
{
    auto *field = qobject_cast<NumberField *>(watched);
    if (!field)
        return QStyledItemDelegate::eventFilter(watched, event);
    if (event->type() == QEvent::KeyPress)
        return handleKey(field, static_cast<QKeyEvent *>(event)->key());
    if (event->type() == QEvent::FocusOut) {
        const Qt::FocusReason reason = static_cast<QFocusEvent *>(event)->reason();
        if (reason == Qt::PopupFocusReason || reason == Qt::ActiveWindowFocusReason)
            return false;
        if (!field->isRefused())
            field->propose();
        field->revert();
        emit closeEditor(field, QAbstractItemDelegate::NoHint);
    }
    return false;
}

} // namespace cradle
