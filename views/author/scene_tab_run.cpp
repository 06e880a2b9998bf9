// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/scene_tab.h"

#include "tasks/script/student_script.h"
#include "tasks/values/lab_values.h"
#include "tasks/values/put_values.h"
#include "views/choice_box.h"
#include "views/error_line.h"

namespace cradle {

// What moves the circles, and why it stopped.

void SceneTab::visit(const SceneVisit &run)
{
    m_preset.visit(run.scene);
    m_programFile = run.program;
    runProgram(run.source, run.pinned);
    m_simulation.goTo(run.step);
}

/// The reference program if it is asked for, else the laws.
QString SceneTab::moverSource() const
{
    if (m_mover->currentIndex() != 1 || which() != StepPreset::Start)
        return {};
    const LabFiles &files = m_document.files();
    const QString written = textOf(files, m_document.inStep(QStringLiteral("solution.lua")));
    const auto source = withNumbers(written, valuesOf(files, m_document.step(), {}), true);
    return source ? *source : written;
}

QStringList SceneTab::lockedFields() const
{
    const Result<TaskForm> form = m_document.form();
    return form ? form->locked : QStringList();
}

void SceneTab::chooseMover()
{
    m_programFile = QStringLiteral("solution.lua");
    runProgram(moverSource(), false);
}

/// Begins anew if the program or what it must leave as it is was edited meanwhile.
void SceneTab::followMover()
{
    const QString running = m_program ? m_program->source() : QString();
    const bool same = moverSource() == running && (!m_program || lockedFields() == m_locked);
    if (!m_preset.isVisiting() && !same)
        chooseMover();
}

void SceneTab::runProgram(const QString &source, bool pinned)
{
    m_locked = lockedFields();
    auto script =
        source.isEmpty()
            ? nullptr
            : std::make_unique<StudentScript>(
                source,
                StudentScript::Options{.pinned = pinned, .timed = true, .locked = m_locked});
    m_simulation.setProgram(script.get());
    m_program = std::move(script);
    showError();
}

void SceneTab::showError()
{
    const auto &error = m_simulation.programError();
    if (error)
        m_error->setError(*error);
    m_error->setVisible(error.has_value());
}

} // namespace cradle
