// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/task_form.h"
#include "views/author/author_document.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QLabel;
class QTabWidget;
QT_END_NAMESPACE

namespace cradle {

class CodeEditor;
class MarkdownEditor;
class MarkdownView;
class RemarkEditor;

/// One program of a step. Below a mistake or a remark stands what the student reads of it, and of
/// a remark how it is recognised.
class ProgramPage final : public QWidget
{
    Q_OBJECT
public:
    explicit ProgramPage(AuthorDocument &document, QWidget *parent = nullptr);

    [[nodiscard]] CodeEditor &editor() { return *m_editor; }
    [[nodiscard]] RemarkEditor &remark() { return *m_remark; }
    /// Shows a program of the open step: "solution.lua" or "mistakes/NAME.lua".
    void showProgram(const QString &program);
    void showRecognition(); ///< of a remark

private:
    void makeLayout();
    QWidget *makeMessage();
    QWidget *makeRecognition();
    void retranslate();
    void showNote();
    void showMessage();
    void showRemark();
    void checkSyntax();
    int markDifference();
    [[nodiscard]] QString differenceNote() const;
    void takeSource();
    void takeTranslation(const QString &text);
    void takeRemark(const RemarkForm &remark, const QString &field);
    [[nodiscard]] QString path() const;       ///< in the lab
    [[nodiscard]] bool isTranslation() const; ///< the open language is not the lab's own

    AuthorDocument &m_document;
    QLabel *m_note = nullptr; ///< about the program shown
    CodeEditor *m_editor = nullptr;
    QTabWidget *m_below = nullptr;
    QLabel *m_messageNote = nullptr;
    MarkdownEditor *m_translation = nullptr;
    MarkdownView *m_message = nullptr;
    RemarkEditor *m_remark = nullptr;
    QString m_program;
    QString m_shownPath;
    bool m_applies = true; ///< else the difference itself is shown, to be mended
    Error m_fault{};       ///< why it does not apply
};

} // namespace cradle
