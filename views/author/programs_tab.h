// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/other_mistakes.h"
#include "views/author/author_document.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QListWidgetItem;
QT_END_NAMESPACE

namespace cradle {

class CodeEditor;
class Menu;
class OtherMistakesMenu;
class ProgramPage;
class RowsList;

/// The programs of a step: what a student starts from, the reference, known mistakes, and work
/// that passes and deserves a word; beside them the chosen one.
class ProgramsTab final : public QWidget
{
    Q_OBJECT
public:
    explicit ProgramsTab(AuthorDocument &document, QWidget *parent = nullptr);

    [[nodiscard]] CodeEditor &editor();
    /// Shows a program of the open step: "solution.lua" or "mistakes/NAME.lua".
    void openProgram(const QString &file, int line = 0);
    /// Shows how a remark of the open step is recognised.
    void openRemark(const QString &name);
    [[nodiscard]] const QString &program() const { return m_program; }
    /// The remarks of any step, "STEP/ID", in which something is typed that is no value.
    [[nodiscard]] QStringList refusedRemarks() const;

public slots:
    void addMistake();
    void addRemark();
    void removeProgram();
    void renameProgram(); ///< begins to edit its name in the list

private:
    void makeLayout();
    void wire();
    void retranslate();
    void reload();
    void fillList();
    void showProgram();
    void addKnown(KnownKind kind);
    void takeOver(const OtherMistake &mistake);
    void takeName(QListWidgetItem *item);
    void renameTo(const QString &file, const QString &name);
    [[nodiscard]] QString path() const; ///< in the lab

    AuthorDocument &m_document;
    RowsList *m_list = nullptr;
    Menu *m_addMenu = nullptr;
    OtherMistakesMenu *m_otherMenu = nullptr;
    ProgramPage *m_page = nullptr;
    QString m_program = QStringLiteral("solution.lua"); ///< below the step's folder
    QString m_listed;                                   ///< what the list was made of
    bool m_loading = false;
};

} // namespace cradle
