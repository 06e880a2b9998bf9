// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workbench.h"
#include "views/code/code_pane.h"

class QSettings;

namespace cradle {

class ApiPage;

/// Joins the pane of the student's program to the program that runs: edits, errors, steps through
/// lines, the reference of the language.
class CodeDesk final : public QObject
{
    Q_OBJECT
public:
    /// \param pane  lives in the window
    CodeDesk(Workbench &workbench, CodePane &pane, QSettings &settings, QObject *parent = nullptr);

    /// Opens the reference of the student's Lua at \p word.
    void showReference(const QString &word);
    /// Marks the line that made the first step that failed in the report, if it is known.
    void showReport();

private:
    void wireEditor();
    void wireSteps();
    void wireSimulation();
    void showState();
    void showError(const ProgramError &error);
    void clearError();
    void showPause(const StudentScript::Pause &pause);
    void showSolutionButton();
    void startAfresh();

    Workbench &m_workbench;
    CodePane &m_pane;
    QSettings &m_settings;
    ApiPage *m_reference = nullptr; ///< a window, once it was asked for
};

} // namespace cradle
