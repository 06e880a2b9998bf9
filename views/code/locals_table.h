// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/program.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QLabel;
class QTableWidget;
QT_END_NAMESPACE

namespace cradle {

/// The local variables at the line that runs next.
class LocalsTable final : public QWidget
{
    Q_OBJECT
public:
    explicit LocalsTable(QWidget *parent = nullptr);

    void setLocals(const std::vector<ProgramValue> &locals);
    [[nodiscard]] QSize sizeHint() const override; ///< as wide as its names and values

private:
    void retranslate();

    QLabel *m_heading;
    QLabel *m_none;
    QTableWidget *m_table;
};

} // namespace cradle
