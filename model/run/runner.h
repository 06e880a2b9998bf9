// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/program.h"
#include "model/run/recording.h"
#include "model/run/stepper.h"

#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace cradle {

/// One run of a scene, step by step: under its laws, or by a program where that moves the circles.
/// The window, tables of a run, checks and the search for a line all run so; what they do with a
/// step is theirs.
///
/// The n-th step ends at n × timestep, without drift, as long as all steps before it were of the
/// scene's timestep; after one of another length the time adds up.
class Runner
{
public:
    static constexpr std::size_t allEvents = std::numeric_limits<std::size_t>::max();
    /// A step of exact timing is left for a moment after so many events: about 20 ms.
    static constexpr std::size_t eventsAtOnce = 16'384;

    /// Whom a run serves.
    struct Use {
        Recording *recording = nullptr; ///< takes the start and every step; borrowed
        bool tellsHits = true;          ///< if not, nobody looks at hits, and none are recorded
    };

    /// What a call of advance() came to.
    enum class Progress {
        Done,  ///< the step
        Begun, ///< a part of it; the next call goes on with it
        Failed ///< the program cannot go on, now or before: the state is that before the step
    };

    /// How far run() goes.
    struct Bounds {
        qint64 steps = 0; ///< of the whole run, from its start
        qint64 instructions = std::numeric_limits<qint64>::max(); ///< see Program::instructions()
        /// Asked before every step, and about every 20 ms of a long one; true ends the run there.
        std::function<bool()> stop{};
    };

    /// Why run() ended.
    enum class End { AllSteps, Failed, Stopped, TooManyInstructions };

    /// Begins a run: \p program (none: null), which is borrowed, makes of \p scene what it will.
    /// If it cannot, the scene stays as it is, and error() tells why.
    explicit Runner(const Preset &scene, Program *program = nullptr);
    Runner(const Preset &scene, Program *program, const Use &use);

    /// The scene as the program left it when it was loaded.
    [[nodiscard]] const Preset &scene() const { return m_scene; }
    /// The newest state.
    [[nodiscard]] const World &world() const { return m_world; }
    /// Of the step that was made last; those of a program are inferred (inferHits()).
    [[nodiscard]] const std::vector<Hit> &hits() const { return m_hits; }
    /// Why the program cannot go on, if it cannot.
    [[nodiscard]] const std::optional<ProgramError> &error() const { return m_error; }
    /// Whether the program moves the circles, not the laws.
    [[nodiscard]] bool isProgrammed() const { return !m_laws; }
    /// Whether a step was begun and is not done.
    [[nodiscard]] bool isUnfinished() const { return m_begun.has_value(); }
    /// Of the program so far; 0 without any.
    [[nodiscard]] qint64 instructions() const { return m_program ? m_program->instructions() : 0; }
    /// Stepper::mergedFrom(); none where a program moves the circles.
    [[nodiscard]] std::optional<double> mergedFrom() const
    {
        return m_laws ? m_laws->mergedFrom() : std::nullopt;
    }
    /// When the next step ends, if it is \p dt s long: s.
    [[nodiscard]] double endOf(double dt) const;

    /// Goes on from \p world, which has as many circles.
    void place(const World &world);

    /// Where steps are recorded from now on; null for nowhere.
    void setRecording(Recording *recording) { m_use.recording = recording; }

    /// A step of \p dt s, of any length from 0, but for exact timing only through \p events events.
    /// One that was begun goes on with its own length.
    Progress advance(double dt, std::size_t events = allEvents);

    /// A whole step of the scene's timestep. \return false if the program cannot go on
    bool step();

    /// Whole steps up to \p bounds, after each of which \p done is called.
    End run(const Bounds &bounds, const std::function<void()> &done = {});

private:
    bool moveByLaws(double dt, std::size_t events);
    bool moveByProgram(double dt);
    void record();

    Preset m_scene;
    Program *m_program = nullptr;
    Use m_use;
    std::optional<Stepper> m_laws{}; ///< none where the program moves the circles
    World m_world{};
    std::vector<Circle> m_before{}; ///< at the start of the program's step, for its hits
    std::vector<Hit> m_hits{};
    std::optional<ProgramError> m_error{};
    std::optional<double> m_begun{}; ///< a step that is not done, s long
};

} // namespace cradle
