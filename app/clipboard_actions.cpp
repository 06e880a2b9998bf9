// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/clipboard_actions.h"

#include "views/code/code_editor.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMetaObject>
#include <QPlainTextEdit>
#include <QTextEdit>

#include <optional>

namespace cradle {

namespace {

constexpr const char *cutSlot = "cut";
constexpr const char *copySlot = "copy";
constexpr const char *pasteSlot = "paste";

/// Whether the text of \p widget is only to be read.
bool isReadOnly(const QWidget &widget)
{
    if (widget.property("readOnly").toBool())
        return true;
    for (const QWidget *each = &widget; each; each = each->parentWidget()) {
        if (const auto *editor = qobject_cast<const CodeEditor *>(each))
            return editor->isReadOnly();
    }
    return false;
}

/// nullopt: nobody knows, so it is tried.
std::optional<bool> hasSelection(const QWidget &widget)
{
    if (const auto *line = qobject_cast<const QLineEdit *>(&widget))
        return line->hasSelectedText();
    if (const auto *text = qobject_cast<const QTextEdit *>(&widget))
        return text->textCursor().hasSelection();
    if (const auto *text = qobject_cast<const QPlainTextEdit *>(&widget))
        return text->textCursor().hasSelection();
    return std::nullopt;
}

} // namespace

ClipboardActions::ClipboardActions(QWidget &window, QMenu &menu)
    : QObject(&menu)
    , m_window(window)
{
    const auto add = [&](QKeySequence::StandardKey key, const char *slot, const QString &name) {
        m_entries.push_back({menu.addAction(QString()), key, slot, name});
    };
    add(QKeySequence::Cut, cutSlot, tr("Cu&t"));
    add(QKeySequence::Copy, copySlot, tr("&Copy"));
    add(QKeySequence::Paste, pasteSlot, tr("&Paste"));
    add(QKeySequence::SelectAll, "selectAll", tr("Select a&ll"));
    for (const Entry &entry : m_entries)
        connect(entry.action, &QAction::triggered, this, [this, entry] { perform(entry); });
    connect(&menu, &QMenu::aboutToShow, this, &ClipboardActions::show);
    connect(qApp, &QApplication::focusChanged, this,
            [this](QWidget *, QWidget *now) { follow(now); });
    follow(QApplication::focusWidget());
    show();
}

/// The keyboard goes to the menus, and to other windows, and comes back: neither is work.
void ClipboardActions::follow(QWidget *focused)
{
    if (!focused || qobject_cast<QMenuBar *>(focused) || qobject_cast<QMenu *>(focused)
        || focused->window() != &m_window)
        return;
    m_focused = focused;
    show();
}

/// A pane may have an action of its own for the same key.
QAction *ClipboardActions::ownAction(const Entry &entry) const
{
    for (const QWidget *each = m_focused; each && each != &m_window; each = each->parentWidget()) {
        for (QAction *action : each->actions()) {
            if (action->shortcut().matches(QKeySequence(entry.key)) == QKeySequence::ExactMatch)
                return action;
        }
    }
    return nullptr;
}

bool ClipboardActions::canPerform(const Entry &entry) const
{
    if (!m_focused || !m_focused->isVisible())
        return false;
    if (const QAction *own = ownAction(entry))
        return own->isEnabled();
    const QByteArray signature = QByteArray(entry.slot) + "()";
    if (m_focused->metaObject()->indexOfMethod(signature.constData()) < 0)
        return false;
    if (entry.slot == pasteSlot)
        return !isReadOnly(*m_focused) && !QApplication::clipboard()->text().isEmpty();
    if (entry.slot == cutSlot)
        return !isReadOnly(*m_focused) && hasSelection(*m_focused).value_or(true);
    return entry.slot != copySlot || hasSelection(*m_focused).value_or(true);
}

void ClipboardActions::perform(const Entry &entry)
{
    if (!canPerform(entry))
        return;
    if (QAction *own = ownAction(entry))
        own->trigger();
    else
        QMetaObject::invokeMethod(m_focused, entry.slot);
}

/// A shortcut here would rob the panes of theirs; the text tells it.
void ClipboardActions::show()
{
    for (const Entry &entry : m_entries) {
        const QAction *own = m_focused ? ownAction(entry) : nullptr;
        entry.action->setText(QStringLiteral("%1\t%2").arg(
            own ? own->text() : entry.name,
            QKeySequence(entry.key).toString(QKeySequence::NativeText)));
        entry.action->setEnabled(canPerform(entry));
    }
}

} // namespace cradle
