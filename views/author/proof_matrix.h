// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/proof/verified_task.h"

#include <QTableWidget>

namespace cradle {

/// Programs × checks of one step: which program fails which check, and what it was taken for. The
/// cells of a mistake's failed checks are filled, so that an empty column catches the eye.
class ProofMatrix final : public QTableWidget
{
    Q_OBJECT
public:
    explicit ProofMatrix(QWidget *parent = nullptr);

    void show(const VerifiedTask &task);

signals:
    void programChosen(const QString &program); ///< "solution", "mistakes/NAME"
    void checkChosen(const QString &id);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void fill();
    void fitColumns();
    void addRow(int row, const VerifiedProgram &program);
    void addSensitivity(int row);

    VerifiedTask m_task;
};

} // namespace cradle
