// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/probe.h"

namespace cradle {

namespace {

/// Instructions of a step after which a changed program that is looked at once is given up: a sound
/// one takes some hundred. Those that never end are among them.
constexpr qint64 mostOfALook = 100'000;

std::optional<StudentScript> scriptOf(const QString *program, bool pinned, bool once)
{
    if (!program)
        return std::nullopt;
    return std::optional<StudentScript>(
        std::in_place, *program,
        StudentScript::Options{.pinned = pinned,
                               .quiet = true,
                               .silent = true,
                               .once = once,
                               .mostWork = once ? mostOfALook : limits::instructionsPerStep,
                               .locked = {}});
}

} // namespace

Probe::Probe(const QString *program, const Stage &stage, bool once)
    : m_program(scriptOf(program, stage.pinned, once))
    , m_run(stage.preset, m_program ? &*m_program : nullptr, {.tellsHits = false})
{
}

qint64 Probe::instructions() const
{
    return isProgrammed() ? m_run.instructions() : 0;
}

std::vector<Assignment> Probe::trace()
{
    return runs() && isProgrammed() ? m_program->trace(world(), start().timestep)
                                    : std::vector<Assignment>{};
}

std::vector<int> Probe::lines()
{
    return runs() && isProgrammed() ? m_program->linesOf(world(), start().timestep)
                                    : std::vector<int>{};
}

std::optional<World> worldAfter(const QString &program, const Stage &stage, qint64 steps)
{
    Probe probe(&program, stage, true);
    for (qint64 k = 0; k < steps; ++k) {
        if (!probe.step())
            return std::nullopt;
    }
    return probe.runs() ? std::optional(probe.world()) : std::nullopt;
}

} // namespace cradle
