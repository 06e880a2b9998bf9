// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/task_form.h"
#include "views/author/author_document.h"

#include <QWidget>

namespace cradle {

class CodeEditor;

/// The program of a check that is written in Lua, below the form of the check.
class CheckProgram final : public QWidget
{
    Q_OBJECT
public:
    explicit CheckProgram(AuthorDocument &document, QWidget *parent = nullptr);

    [[nodiscard]] CodeEditor &editor() { return *m_editor; }
    /// Shows the program of \p check, a check of the open step; hides if it has none.
    void showCheck(const CheckForm &check);

    /// The file of the program of \p check in the step's folder "checks"; empty if it has none.
    [[nodiscard]] static QString fileOf(const CheckForm &check);
    /// Gives \p check a file of its own, and \p files a program there that accepts everything if
    /// there is none yet.
    [[nodiscard]] static LabFiles begin(const LabFiles &files, const QString &step,
                                        CheckForm &check);

    /// Gives \p check, which has the program of another, a copy of it under its own id.
    [[nodiscard]] static LabFiles copied(const LabFiles &files, const QString &step,
                                         CheckForm &check);

private:
    void takeText();
    void retranslate();

    AuthorDocument &m_document;
    CodeEditor *m_editor;
    QString m_path{}; ///< of the program that is shown
};

} // namespace cradle
