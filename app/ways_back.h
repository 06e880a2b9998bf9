// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/kept_progress.h"
#include "views/preset_document.h"

namespace cradle {

/// What the work on the open step can go back to: its start, the solution of the step before, the
/// scene that passed; and what becomes of a file that is no program.
class WaysBack final : public QObject
{
    Q_OBJECT
public:
    /// All outlive this.
    WaysBack(const LabPlace &place, PresetDocument &document, CodeSession &code,
             const KeptProgress &progress);

    /// The newest version of the step's program; nothing if there is none.
    [[nodiscard]] std::optional<QString> newestVersion() const;
    /// The step before, if the open one builds on its solution and the student has a program of
    /// neither: who jumped ahead.
    [[nodiscard]] const Task *missedTask() const;
    /// The scene with which the step was passed, where steps are worked on by scenes and another is
    /// there now.
    [[nodiscard]] std::optional<Preset> passedScene() const;

public slots:
    void startAfresh();       ///< the program, from what the step before ended with
    void startFromSolution(); ///< of the step before, if it was missed
    void takePassedScene();
    void convertProgram();    ///< the step's file, which is no program, becomes one
    void setProgramAside();   ///< the step begins anew; the file that is no program is kept
    void takeNewestVersion(); ///< in place of a file that is no program

private:
    const LabPlace &m_place;
    PresetDocument &m_document;
    CodeSession &m_code;
    const KeptProgress &m_progress;
};

} // namespace cradle
