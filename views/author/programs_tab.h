// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/lab_edits.h"
#include "views/author/author_document.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QLabel;
class QListWidget;
class QListWidgetItem;
class QMenu;
class QSplitter;
class QToolButton;
QT_END_NAMESPACE

namespace cradle {

class CodeEditor;
class MarkdownEditor;
class MarkdownView;

/// The programs of a step: what a student starts from, the reference, known mistakes, and work
/// that passes and deserves a word. Below the program, what the student reads of it.
class ProgramsTab final : public QWidget
{
    Q_OBJECT
public:
    explicit ProgramsTab(AuthorDocument &document, QWidget *parent = nullptr);

    [[nodiscard]] CodeEditor &editor() { return *m_editor; }
    /// Shows a program of the open step: "solution.lua" or "mistakes/NAME.lua".
    void showProgram(const QString &file, int line = 0);
    [[nodiscard]] const QString &program() const { return m_program; }

public slots:
    void addMistake();
    void addRemark();
    void removeProgram();
    void renameProgram(); ///< begins to edit its name in the list

protected:
    void changeEvent(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makeLayout();
    void wire();
    void retranslate();
    void reload();
    void fillList();
    void showText();
    void showMessage();
    void addKnown(KnownKind kind);
    void takeSource();
    void takeTranslation(const QString &text);
    void takeName(QListWidgetItem *item);
    void renameTo(const QString &file, const QString &name);
    void checkSyntax();
    [[nodiscard]] QString path() const;       ///< in the lab
    [[nodiscard]] bool isTranslation() const; ///< the open language is not the lab's own

    AuthorDocument &m_document;
    QLabel *m_heading = nullptr;
    QListWidget *m_list = nullptr;
    QToolButton *m_add = nullptr;
    QMenu *m_addMenu = nullptr;
    QToolButton *m_rename = nullptr;
    QToolButton *m_remove = nullptr;
    QLabel *m_note = nullptr; ///< about the program shown
    QSplitter *m_splitter = nullptr;
    CodeEditor *m_editor = nullptr;
    QWidget *m_messagePane = nullptr;
    QLabel *m_messageHeading = nullptr;
    MarkdownEditor *m_translation = nullptr;
    MarkdownView *m_message = nullptr;
    QString m_program = QStringLiteral("solution.lua"); ///< below the step's folder
    QString m_shownPath;
    QString m_listed; ///< what the list was made of
    bool m_loading = false;
};

} // namespace cradle
