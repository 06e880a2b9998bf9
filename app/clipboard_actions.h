// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QObject>
#include <QPointer>

#include <vector>

QT_BEGIN_NAMESPACE
class QAction;
class QMenu;
QT_END_NAMESPACE

namespace cradle {

/// Cut, Copy, Paste and Select all of what has the keyboard's focus: circles in the scene, text in
/// the program or a field, cells of a table. The menu shows their keys; the panes answer to these.
class ClipboardActions final : public QObject
{
    Q_OBJECT
public:
    /// Adds them to \p menu, which owns them. \p window is borrowed: other windows are not
    /// followed.
    ClipboardActions(QWidget &window, QMenu &menu);

private:
    struct Entry {
        QAction *action;
        QKeySequence::StandardKey key;
        const char *slot; ///< of a widget that edits text
        QString name;
    };

    void follow(QWidget *focused);
    void show();
    void perform(const Entry &entry);
    [[nodiscard]] QAction *ownAction(const Entry &entry) const;
    [[nodiscard]] bool canPerform(const Entry &entry) const;

    QWidget &m_window;
    QPointer<QWidget> m_focused;
    std::vector<Entry> m_entries;
};

} // namespace cradle
