// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/program.h"
#include "tasks/script/assignment.h"
#include "tasks/script/circle_field.h"
#include "tasks/script/script_limits.h"

#include <QStringList>

#include <functional>
#include <memory>

struct lua_State;

namespace cradle {

struct Trace;

/// A student's Lua program: on_load and on_update, run in a sandbox of its own. What it may do and
/// use is in sandbox.h and script_limits.h; past a limit it stops.
class StudentScript final : public Program
{
public:
    struct Options {
        bool pinned = false; ///< the scene keeps its values whatever on_load sets
        bool quiet = false;  ///< nobody looks at what it prints, plots and draws
        bool silent = false; ///< nobody reads what its errors say: they have no words
        bool once = false;   ///< it runs but once: what it was compiled to is not kept
        qint64 mostWork = limits::instructionsPerStep; ///< of a step; past them it stops
        bool timed = false; ///< a live run: a step ends by the clock, too, not only by its work
        /// What it must not change; see locks.h. Places and velocities are fixed at the start only.
        QStringList locked{};
        /// Asked again and again while it runs; true ends the run, with an error of no meaning.
        std::function<bool()> stop{};
    };

    explicit StudentScript(QString source, Options options);
    explicit StudentScript(QString source)
        : StudentScript(std::move(source), Options{})
    {
    }
    ~StudentScript() override;

    [[nodiscard]] const QString &source() const { return m_source; }
    void setPinned(bool pinned) { m_options.pinned = pinned; }
    /// As if on_load had set it; after begin().
    void setRestitution(double restitution);

    std::optional<ProgramError> begin(Preset &scene) override;
    [[nodiscard]] bool moves() const override { return m_moves; }
    std::optional<ProgramError> advance(World &world, double dt) override;
    [[nodiscard]] qint64 instructions() const override;
    [[nodiscard]] ProgramOutput takeOutput() override;

    /// Where a run through the lines of one update stands.
    struct Pause {
        int line = 0;                        ///< that runs next; 0: the update is done
        std::vector<ProgramValue> locals{};  ///< at that line
        std::vector<Circle> circles{};       ///< as they are now
        std::optional<ProgramError> error{}; ///< it stopped here
    };
    /// Begins an update of \p world line by line; nothing has run yet. The next advance() of
    /// that world takes over what was done and does the rest.
    Pause beginLines(const World &world, double dt);
    /// Runs to the next line of the update.
    Pause nextLine();
    /// Leaves an update that was begun, without its end.
    void dropLines();

    /// The numbers that the program keeps with the circles, such as their masses.
    [[nodiscard]] std::vector<CircleField> ownFields() const;
    /// What one update of \p world assigns to the circles, in order, until it ends or fails; of
    /// very many assignments the last. The program has made that update then: its own variables
    /// have gone on.
    [[nodiscard]] std::vector<Assignment> trace(const World &world, double dt);
    /// What the file and on_load assign when they begin with \p scene, until they end or fail; it
    /// is a begin().
    [[nodiscard]] std::vector<Assignment> traceStart(Preset scene);
    /// The lines that run in one update of \p world, in the order of the file. As trace().
    [[nodiscard]] std::vector<int> linesOf(const World &world, double dt);

private:
    struct Engine;

    std::optional<ProgramError> load(lua_State *L);
    std::optional<ProgramError> call(int arguments);
    std::optional<ProgramError> checkScene(const Preset &scene) const;
    ProgramError errorOf(lua_State *L, int status);
    void place(const World &world);
    Pause resume(int arguments);
    [[nodiscard]] ProgramError lostUpdate() const;
    std::optional<ProgramError> endLines(World &world);
    [[nodiscard]] Trace traced(World world, double dt);

    QString m_source;
    Options m_options;
    std::unique_ptr<Engine> m_engine; ///< of the run; none before begin()
    Trace *m_startTrace = nullptr;    ///< of a begin() that is written down
    bool m_moves = false;
};

/// What is wrong with the grammar of \p source, without running it.
[[nodiscard]] std::optional<ProgramError> findSyntaxError(const QString &source);

} // namespace cradle
