// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_files/lab_files.h"

#include <QDialog>

QT_BEGIN_NAMESPACE
class QDialogButtonBox;
QT_END_NAMESPACE

namespace cradle {

/// Asks what is to become of two versions of a lab, and shows how they differ. Nothing is chosen
/// beforehand but to leave both as they are.
class DifferenceDialog final : public QDialog
{
    Q_OBJECT
public:
    /// \param question  what has come about
    DifferenceDialog(const QString &question, const LabFiles &mine, const LabFiles &theirs,
                     QWidget *parent);

    /// Adds a way out beside Cancel; exec() returns \p code for it, which is 1 or more.
    void addChoice(const QString &text, int code);

private:
    QDialogButtonBox *m_buttons;
};

/// How \p theirs differs from \p mine: a unified diff of every text, and the names of all else.
[[nodiscard]] QString differenceOf(const LabFiles &mine, const LabFiles &theirs);

} // namespace cradle
