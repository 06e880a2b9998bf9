// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/examples.h"
#include "app/ways_back.h"
#include "app/work_check.h"
#include "tasks/lab/mode.h"

namespace cradle {

/// What the student works on, without any window: which lab, step and mode are open. What becomes
/// of the work is the matter of its parts.
class Workbench final : public QObject
{
    Q_OBJECT
public:
    /// \param progressFile  where the progress is kept; the programs lie in "programs" beside it
    explicit Workbench(const QString &progressFile, QObject *parent = nullptr);
    ~Workbench() override;

    [[nodiscard]] const Lab &lab() const { return m_place.lab; }
    [[nodiscard]] int current() const { return m_place.current; } ///< −1: a scene without a step
    [[nodiscard]] const Task *task() const { return m_place.task(); } ///< nullptr: the same
    /// The example that is open, if one is.
    [[nodiscard]] std::optional<Example> example() const { return m_example; }
    /// How the student works; a scene without a step can only be explored.
    [[nodiscard]] Mode mode() const { return m_code.run().isActive() ? Mode::Code : Mode::Explore; }
    /// Whether nothing had ever been done in this lab when it was opened.
    [[nodiscard]] bool isFirstStart() const { return m_firstStart; }

    [[nodiscard]] Simulation &simulation() { return m_simulation; }
    [[nodiscard]] PresetDocument &document() { return m_document; }
    [[nodiscard]] CodeSession &code() { return m_code; }
    [[nodiscard]] KeptProgress &progress() { return m_progress; }
    [[nodiscard]] FaultMoment &moment() { return m_moment; }
    [[nodiscard]] WorkCheck &check() { return m_check; }
    [[nodiscard]] WaysBack &waysBack() { return m_waysBack; }

    /// Reads a lab and opens the step where the student left off.
    std::optional<Error> openLab(const QString &folder, const QString &language);
    /// Opens a workspace that lies anywhere, with the lab that it names: a clone of the student's
    /// own, or with \p readOnly one that was handed in, to be looked at.
    std::optional<Error> openWork(const QString &folder, bool readOnly, const QString &language);
    /// Whether the lab draws values for each student, and does not know for whom.
    [[nodiscard]] bool wantsNumber() const;
    /// Keeps the student's number, and shows the lab with the values that are drawn for it.
    std::optional<Error> setStudentNumber(const QString &number);
    /// Reads the same lab again, in another language; keeps step, scene and report.
    void setLanguage(const QString &language);
    /// Opens a scene that belongs to no step.
    std::optional<Error> openPreset(const QString &path);
    /// Opens a scene that ships with the program, in the same way.
    std::optional<Error> openExample(cradle::Example example);
    bool openTask(const QString &id);
    /// Takes a scene as the student's own of the current step; it can be undone.
    std::optional<Error> takePreset(const QString &path);
    /// Takes a file as the student's program of the current step.
    std::optional<Error> takeScript(const QString &path);

public slots:
    void setMode(cradle::Mode mode);
    void openTaskAt(int index);
    void openNextTask();
    void openPreviousTask();
    void takeOver(); ///< the right to save, from the window that has it

signals:
    void numberWanted();  ///< see wantsNumber()
    void heldElsewhere(); ///< another window works on the lab that was opened
    void labChanged();
    void taskChanged(); ///< another step or scene, with its mode, report and progress
    void modeChanged(); ///< of the open step, which has no report in it yet
    void failed(const cradle::Error &error); ///< something could not be saved or read

private:
    void openScene(const Preset &preset, std::optional<Example> example);
    std::optional<Error> openLabWith(const QString &folder, const QString &language,
                                     const QString &work, bool readOnly);
    void openWorkspace(const QString &folder, bool readOnly);

    LabPlace m_place;
    std::optional<Example> m_example;
    bool m_firstStart = false;
    Mode m_wantedMode = Mode::Explore;
    QString m_progressFile;
    QString m_programs; ///< folder of the students' programs; empty: nowhere
    Simulation m_simulation;
    PresetDocument m_document;
    CodeSession m_code;
    KeptProgress m_progress;
    FaultMoment m_moment;
    WorkCheck m_check;
    WaysBack m_waysBack;
};

} // namespace cradle
