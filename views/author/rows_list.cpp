// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/rows_list.h"

#include "views/author/form_rows.h"
#include "views/boxes.h"
#include "views/theme.h"

#include <QKeyEvent>
#include <QLabel>
#include <QMetaMethod>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace cradle {

namespace {

constexpr int rowPadding = 14; ///< px, at the left and right of a row together

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

RowsList::RowsList(const QString &name, QWidget *parent, std::initializer_list<Button> buttons)
    : QListWidget(parent)
{
    setObjectName(name);
    setFrameShape(QFrame::NoFrame);
    setKind(this, "rows");
    setTextElideMode(Qt::ElideNone); // it scrolls
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    const char *const icons[] = {"add", "duplicate", "edit", "remove", "up", "down"};
    for (const Button each : buttons)
        m_buttons[each] = makeIconButton(QLatin1String(icons[each]), parent);
    const auto listen = [this](Button which, auto act) {
        if (m_buttons[which])
            connect(m_buttons[which], &QToolButton::clicked, this, act);
    };
    listen(Add, &RowsList::addRequested);
    listen(Duplicate, &RowsList::duplicateRequested);
    listen(Rename, &RowsList::renameRequested);
    listen(Remove, &RowsList::removeRequested);
    listen(Up, [this] { emit moveRequested(currentRow(), currentRow() - 1); });
    listen(Down, [this] { emit moveRequested(currentRow(), currentRow() + 1); });
    connect(this, &QListWidget::currentRowChanged, this, &RowsList::followRow);
    for (const auto way : {&QListWidget::itemClicked, &QListWidget::itemActivated})
        connect(this, way, this, [this](QListWidgetItem *item) { emit chosen(row(item)); });
    for (const auto counted : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(model(), counted, this, &RowsList::showHeading);
    connect(model(), &QAbstractItemModel::modelReset, this, &RowsList::showHeading);
}

RowsList::~RowsList()
{
    model()->disconnect(this); // which empties itself once this is no list any more
}

void RowsList::setTexts(const QString &name,
                        std::initializer_list<std::pair<Button, QString>> buttons,
                        const QString &heading)
{
    const QString keys[] = {{}, {}, tr("F2"), tr("Delete"), tr("Alt+Up"), tr("Alt+Down")};
    setAccessibleName(name);
    for (const auto &[which, text] : buttons)
        nameButton(m_buttons[which], text, keys[which]);
    m_headingText = heading;
    showHeading();
}

void RowsList::showHeading()
{
    if (m_heading)
        m_heading->setText(
            QString(m_headingText).replace(QLatin1String("%1"), QString::number(count())));
}

void RowsList::enableButtons(bool writable, int fewest, int most)
{
    m_writable = writable;
    m_fewest = fewest;
    m_most = most;
    followRow();
}

void RowsList::followRow()
{
    const int row = currentRow();
    const bool any = row >= 0;
    const bool enabled[] = {count() < m_most,          any,     any,
                            any && count() > m_fewest, row > 0, any && row + 1 < count()};
    for (int i = 0; i < ButtonCount; ++i) {
        if (m_buttons[i])
            m_buttons[i]->setEnabled(m_writable && enabled[i]);
    }
}

QBoxLayout *RowsList::underHeading()
{
    m_heading = makeHeading(parentWidget());
    auto *row = makeRow({12, 6, 6, 4}, 0, {{m_heading, 1}});
    for (const Button each : {Up, Down, Add, Duplicate, Rename, Remove}) {
        if (m_buttons[each])
            row->addWidget(m_buttons[each]);
    }
    return makeColumn({}, 0, {row, {this, 1}});
}

void RowsList::wrapRows()
{
    setWordWrap(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setResizeMode(QListView::Adjust);
    setItemDelegate(new WrappedRow(this));
}

void RowsList::showRows(const QStringList &texts, int current)
{
    {
        const QSignalBlocker blocker(this);
        const auto wanted = static_cast<int>(texts.size());
        while (count() > wanted)
            delete takeItem(count() - 1);
        for (int i = 0; i < wanted; ++i) {
            if (i == count())
                addItem(QString());
            item(i)->setText(texts[i]);
        }
        doItemsLayout(); // a text may take another number of lines now
        setCurrentRow(std::clamp(current, std::min(0, wanted - 1), wanted - 1));
    }
    followRow();
}

void RowsList::keyPressEvent(QKeyEvent *event)
{
    const bool alt = event->modifiers() == Qt::AltModifier;
    const int key = event->key();
    QToolButton *pressed = alt && key == Qt::Key_Up        ? m_buttons[Up]
                           : alt && key == Qt::Key_Down    ? m_buttons[Down]
                           : !alt && key == Qt::Key_Delete ? m_buttons[Remove]
                                                           : nullptr;
    if (pressed)
        pressed->click();
    else if (key == Qt::Key_F2
             && isSignalConnected(QMetaMethod::fromSignal(&RowsList::renameRequested)))
        emit renameRequested();
    else
        QListWidget::keyPressEvent(event);
}

} // namespace cradle
