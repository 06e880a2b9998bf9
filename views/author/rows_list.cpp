// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/rows_list.h"

#include "views/theme.h"

#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace cradle {

namespace {

constexpr int rowPadding = 14; ///< px, at the left and right of a row together

/// Looks at the keys of a list before the list does.
class RowKeyFilter final : public QObject
{
public:
    RowKeyFilter(QListWidget *list, RowKeys keys)
        : QObject(list)
        , m_keys(std::move(keys))
    {
        list->installEventFilter(this);
    }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (event->type() != QEvent::KeyPress)
            return QObject::eventFilter(watched, event);
        const auto *key = static_cast<QKeyEvent *>(event);
        if (key->key() == Qt::Key_F2 && m_keys.rename) {
            m_keys.rename();
            return true;
        }
        const bool alt = key->modifiers() == Qt::AltModifier;
        QToolButton *button = alt && key->key() == Qt::Key_Up        ? m_keys.up
                              : alt && key->key() == Qt::Key_Down    ? m_keys.down
                              : !alt && key->key() == Qt::Key_Delete ? m_keys.remove
                                                                     : nullptr;
        if (!button)
            return QObject::eventFilter(watched, event);
        button->click();
        return true;
    }

private:
    RowKeys m_keys;
};

/// Qt forgets the padding of the style sheet when it counts the lines of a row.
class WrappedRow final : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        QStyleOptionViewItem narrower = option;
        narrower.rect.setWidth(option.rect.width() - rowPadding);
        return QStyledItemDelegate::sizeHint(narrower, index);
    }
};

} // namespace

QLabel *makeHeading(QWidget *parent)
{
    auto *label = new QLabel(parent);
    label->setFont(headingFont());
    setKind(label, "heading");
    return label;
}

QListWidget *makeRowsList(const QString &name, QWidget *parent)
{
    auto *list = new QListWidget(parent);
    list->setObjectName(name);
    list->setFrameShape(QFrame::NoFrame);
    setKind(list, "rows");
    list->setTextElideMode(Qt::ElideNone); // it scrolls
    list->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    return list;
}

void setRowCount(QListWidget *list, int count)
{
    while (list->count() > count)
        delete list->takeItem(list->count() - 1);
    while (list->count() < count)
        list->addItem(QString());
}

void chooseRow(QListWidget *list, int row)
{
    const int last = list->count() - 1;
    list->setCurrentRow(std::clamp(row, std::min(0, last), last));
}

void wrapRows(QListWidget *list)
{
    list->setWordWrap(true);
    list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list->setResizeMode(QListView::Adjust);
    list->setItemDelegate(new WrappedRow(list));
}

QBoxLayout *makeRowsColumn(QLabel *heading, const std::vector<QToolButton *> &buttons,
                           QListWidget *list)
{
    auto *row = new QHBoxLayout;
    row->setContentsMargins(12, 6, 6, 4);
    row->setSpacing(0);
    row->addWidget(heading, 1);
    for (QToolButton *button : buttons)
        row->addWidget(button);
    auto *column = new QVBoxLayout;
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(row);
    column->addWidget(list, 1);
    return column;
}

void setRowKeys(QListWidget *list, const RowKeys &keys)
{
    new RowKeyFilter(list, keys);
}

} // namespace cradle
