// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

QT_BEGIN_NAMESPACE
class QListWidget;
class QToolButton;
QT_END_NAMESPACE

namespace cradle {

/// Hints in the order in which a student opens them: one is chosen to be written; add, remove,
/// move by the buttons or Alt+Up and Alt+Down.
class HintsList final : public QWidget
{
    Q_OBJECT
public:
    explicit HintsList(QWidget *parent = nullptr);

    void showHints(const QStringList &hints); ///< keeps the choice where it can
    [[nodiscard]] int current() const;        ///< −1 if there is none
    void setCurrent(int hint);
    void setReadOnly(bool readOnly);

signals:
    void currentChanged(int hint);
    void edited(const QStringList &hints, int current); ///< added, removed or moved

private:
    void add();
    void remove();
    void move(int by);
    void retranslate();
    void enableButtons();

    QStringList m_hints;
    QListWidget *m_list;
    QToolButton *m_add;
    QToolButton *m_remove;
    QToolButton *m_up;
    QToolButton *m_down;
    bool m_readOnly = false;
    bool m_loading = false;
};

} // namespace cradle
