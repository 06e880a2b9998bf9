// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace cradle {

class NumberField;

/// Draws and edits the cells of the table of circles: colours as swatches, numbers in a
/// NumberField that stays open while what was typed is impossible, integrators in a list.
class CircleDelegate final : public QStyledItemDelegate
{
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option,
                          const QModelIndex &index) const override;
    void setEditorData(QWidget *editor, const QModelIndex &index) const override;
    void setModelData(QWidget *editor, QAbstractItemModel *model,
                      const QModelIndex &index) const override;
    void updateEditorGeometry(QWidget *editor, const QStyleOptionViewItem &option,
                              const QModelIndex &index) const override;

signals:
    void notANumber(const QString &text) const;
    void reverted() const; ///< an impossible number was taken back

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *createNumberField(QWidget *parent, const QModelIndex &index) const;
    bool handleKey(NumberField *field, int key);
};

} // namespace cradle
