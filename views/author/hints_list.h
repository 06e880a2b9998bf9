// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace cradle {

class RowsList;

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
    void move(int from, int to);
    void retranslate();

    QStringList m_hints;
    RowsList *m_list;
};

} // namespace cradle
