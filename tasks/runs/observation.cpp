// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/runs/observation.h"

#include "model/run/runner.h"
#include "tasks/script/student_script.h"

#include <algorithm>

namespace cradle {

namespace {

/// Enough for a minute of a hundred circles at a fine timestep.
constexpr qint64 maxBytes = 512LL * 1024 * 1024;

} // namespace

Circle Observation::circleAt(int index, double seconds) const
{
    const double place = std::clamp(seconds / timestep(), 0.0, static_cast<double>(steps()));
    const auto before = static_cast<qint64>(place);
    Circle at = circle(index, before);
    const double share = place - static_cast<double>(before);
    if (share > 0.0) {
        const Circle &after = circle(index, before + 1);
        at.position = at.position + share * (after.position - at.position);
        at.velocity = at.velocity + share * (after.velocity - at.velocity);
    }
    return at;
}

Observation observe(const Variant &variant, const QString *script,
                    const std::function<bool()> &stop, qint64 mostInstructions)
{
    bool stopped = false;
    const auto isOver = [&] { return stopped = stopped || (stop && stop()); };
    Observation o{variant, Recording(maxBytes)};
    std::optional<StudentScript> program;
    if (script) {
        program.emplace(*script, StudentScript::Options{.pinned = variant.pinned,
                                                        .quiet = true,
                                                        .locked = variant.locked,
                                                        .stop = isOver});
    }
    Runner runner(variant.preset, program ? &*program : nullptr,
                  {.recording = &o.states, .tellsHits = false});
    o.variant.preset = runner.scene();
    runner.run({.steps = static_cast<qint64>(std::ceil(variant.duration / o.timestep())),
                .instructions = mostInstructions,
                .stop = isOver});
    o.instructions = runner.instructions();
    if (!stopped) // What it was stopped with is no error of its own.
        o.error = runner.error();
    if (program && !runner.error())
        o.fields = program->ownFields();
    return o;
}

} // namespace cradle
