// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/program_work.h"

#include "tasks/judging/probe.h"

namespace cradle {

qint64 workOfAStep(const QString *program, const Preset &scene)
{
    constexpr int steps = 20;
    Probe probe(program, {scene, false});
    const qint64 before = probe.instructions();
    for (int k = 0; k < steps && probe.step(); ++k) {
    }
    return (probe.instructions() - before) / steps;
}

} // namespace cradle
