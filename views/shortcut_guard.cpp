// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/shortcut_guard.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QTabBar>
#include <QTableView>

namespace cradle {

namespace {

bool usesKey(const QObject *control, const QKeyEvent &event)
{
    const int key = event.key();
    const bool space = key == Qt::Key_Space;
    const bool enter = key == Qt::Key_Return || key == Qt::Key_Enter;
    const bool sideways = key == Qt::Key_Left || key == Qt::Key_Right;
    if ((event.modifiers() & ~Qt::KeypadModifier) != Qt::NoModifier)
        return false;
    // Space does nothing to a radio button that is chosen already.
    if (const auto *radio = qobject_cast<const QRadioButton *>(control))
        return space && !radio->isChecked();
    if (qobject_cast<const QAbstractButton *>(control))
        return space;
    if (qobject_cast<const QAbstractSlider *>(control) || qobject_cast<const QTabBar *>(control))
        return sideways;
    if (qobject_cast<const QComboBox *>(control))
        return space || sideways;
    if (const auto *table = qobject_cast<const QTableView *>(control)) {
        const bool editable = table->editTriggers().testFlag(QAbstractItemView::AnyKeyPressed)
                              && table->currentIndex().flags().testFlag(Qt::ItemIsEditable);
        return sideways || (editable && !space && !enter && !event.text().isEmpty());
    }
    return false;
}

/// Keys of Emacs that fields of text take on Unix, where windows have other uses for them.
bool isOfEmacs(const QObject *field, const QKeyEvent &event)
{
    const bool isText =
        qobject_cast<const QLineEdit *>(field) || qobject_cast<const QPlainTextEdit *>(field);
    const int key = event.key();
    return isText && event.modifiers() == Qt::ControlModifier
           && (key == Qt::Key_E || key == Qt::Key_K || key == Qt::Key_D || key == Qt::Key_H);
}

class ShortcutGuard final : public QObject
{
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        if (event->type() == QEvent::ShortcutOverride
            && usesKey(watched, *static_cast<QKeyEvent *>(event))) {
            event->accept();
            return true;
        }
        if (event->type() == QEvent::ShortcutOverride
            && isOfEmacs(watched, *static_cast<QKeyEvent *>(event))) {
            event->ignore(); // a shortcut, where there is one
            return true;
        }
        return QObject::eventFilter(watched, event);
    }
};

} // namespace

void guardShortcuts()
{
    static QPointer<ShortcutGuard> guard;
    if (guard)
        return;
    guard = new ShortcutGuard(qApp);
    qApp->installEventFilter(guard);
}

} // namespace cradle
