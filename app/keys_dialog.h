// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include <utility>
#include <vector>

namespace cradle {

/// What a key does, and the key.
using KeyRow = std::pair<QString, QString>;

struct KeyTable {
    QString title;
    std::vector<KeyRow> rows;
};

/// All keys side by side. It is no larger than the window over which it opens, and scrolls.
class KeysDialog final : public QDialog
{
    Q_OBJECT
public:
    /// \param columns  from where one begins to read; the tables of each from the top
    KeysDialog(const std::vector<std::vector<KeyTable>> &columns, QWidget *parent);

protected:
    void showEvent(QShowEvent *event) override;
};

} // namespace cradle
