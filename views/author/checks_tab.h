// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/task_form.h"
#include "views/author/author_document.h"

#include <QWidget>

#include <optional>

QT_BEGIN_NAMESPACE
class QLabel;
class QSplitter;
QT_END_NAMESPACE

namespace cradle {

class CheckEditor;
class CheckProgram;
class CheckTrial;
class CodeEditor;
class RowsList;

/// The checks of a step: a list in the order of the report, and the chosen one as a form. A check
/// that is written in Lua has its program below the form.
class ChecksTab final : public QWidget
{
    Q_OBJECT
public:
    explicit ChecksTab(AuthorDocument &document, QWidget *parent = nullptr);

    void showCheck(const QString &id);
    void showScript(const QString &file); ///< the check in Lua that \p file is the program of
    [[nodiscard]] CodeEditor &scriptEditor();
    /// The program of the step that a check is tried on: "mistakes/NAME.lua".
    void setProgram(const QString &file);
    /// The checks of any step, "STEP/ID", in which something is typed that is no value.
    [[nodiscard]] QStringList refusedChecks() const;

public slots:
    void addCheck();
    void duplicateCheck();
    void removeCheck();

private:
    void makeLayout();
    void wire();
    void retranslate();
    void reload();
    void showCurrent();
    void move(int from, int to);
    void takeCheck(const CheckForm &check, const QString &field);
    void beginScript(std::vector<CheckForm> checks, int at);
    void store(const QString &text, const std::vector<CheckForm> &checks, int current,
               const QString &mergeKey = {}, const std::optional<LabFiles> &base = {});
    void markRefused();

    AuthorDocument &m_document;
    std::vector<CheckForm> m_checks;
    RowsList *m_list = nullptr;
    QLabel *m_empty = nullptr;
    QSplitter *m_splitter = nullptr;
    CheckEditor *m_editor = nullptr;
    CheckProgram *m_script = nullptr;
    CheckTrial *m_trial = nullptr;
    QString m_shownStep;
};

} // namespace cradle
