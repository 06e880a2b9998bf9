// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"
#include "tasks/script/student_script.h"

#include <functional>
#include <memory>

namespace cradle {

/// What runs of the student's program: the last text that could be read. It moves the circles of
/// the simulation while it is active, and can be walked through line by line.
class CodeRun final : public QObject
{
    Q_OBJECT
public:
    using Start = std::function<void(Program *program)>;

    /// \param simulation  outlives this
    explicit CodeRun(Simulation &simulation);
    ~CodeRun() override;

    /// Takes the text of another step. \p start alone begins the run, once: it is handed the new
    /// program(), and puts it into the simulation with the scene that belongs to it.
    /// \param locked  what the step fixes
    /// \param active  from now on
    void open(const QString &text, const QStringList &locked, bool active, const Start &start);
    void close(); ///< there is no program
    /// Runs \p text from the start, if it can be read and is another than what runs.
    void apply(const QString &text);

    [[nodiscard]] bool isActive() const { return m_active; }
    /// Without a program it stays inactive.
    void setActive(bool active);
    /// The scene keeps its values whatever on_load sets: it is one of a check.
    void setPinned(bool pinned);

    /// The program for the simulation: null while the laws move the circles.
    [[nodiscard]] Program *program() const { return m_active ? m_script.get() : nullptr; }
    /// Its text; empty while the laws move the circles.
    [[nodiscard]] QString text() const { return m_active ? m_text : QString(); }
    /// Whether some version of the open text runs, or did when it was last active.
    [[nodiscard]] bool hasGoodVersion() const { return !m_text.isEmpty(); }
    /// What keeps the newest text from being read; the last good version runs on.
    [[nodiscard]] const std::optional<ProgramError> &fault() const { return m_fault; }

public slots:
    void stepLine();   ///< pauses; to the next line of the update
    void finishStep(); ///< to the end of the update

signals:
    void paused(const cradle::StudentScript::Pause &pause);
    void steppingEnded();

private:
    [[nodiscard]] std::unique_ptr<StudentScript> makeScript() const;
    void endStepping();

    Simulation &m_simulation;
    QStringList m_locked;
    QString m_text;                          ///< the last that could be read
    std::unique_ptr<StudentScript> m_script; ///< of that text
    std::optional<ProgramError> m_fault;
    bool m_active = false;
    bool m_pinned = false;
    bool m_stepping = false;
};

} // namespace cradle
