// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A step of the engine and a verdict of the checks.
#include "model/preset_json.h"
#include "model/stepper.h"
#include "tasks/checker.h"
#include "tasks/lab_reader.h"

#include <benchmark/benchmark.h>

using namespace cradle;

namespace {

Preset gas(int count, Timing timing)
{
    Preset preset;
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, timing};
    preset.halfWidth = 4.0;
    // Area fraction 0.2, rms speed 2 m/s.
    const double radius = std::sqrt(0.2 * 64.0 / (std::numbers::pi * count));
    preset.fill = CircleFill{.count = count, .radius = radius, .rmsSpeed = 2.0, .density = 1.0};
    preset.circles = *makeCircles(*preset.fill, preset.halfWidth);
    return preset;
}

void step(benchmark::State &state, Timing timing)
{
    const Preset preset = gas(static_cast<int>(state.range(0)), timing);
    Stepper stepper(preset);
    World world = initialWorld(preset);
    std::vector<Hit> hits;
    for (auto _ : state) {
        hits.clear();
        stepper.advance(world, hits);
        benchmark::DoNotOptimize(world.circles.data());
    }
}

void verdict(benchmark::State &state, const QString &id)
{
    static const Lab lab = *readLab(QLatin1String(shippedLab));
    const Task &task = lab.tasks[static_cast<std::size_t>(lab.indexOf(id))];
    const Preset solution = *readPreset(task.folder + QStringLiteral("/solution-preset.json"));
    for (auto _ : state)
        benchmark::DoNotOptimize(judgeTask(lab, task, solution, 1));
}

} // namespace

int main(int argc, char **argv)
{
    for (const auto &[name, timing] : {std::pair("step/discrete", Timing::Discrete),
                                       std::pair("step/continuous", Timing::Continuous)})
        benchmark::RegisterBenchmark(name, step, timing)->Arg(2)->Arg(10)->Arg(100);
    const Result<Lab> lab = readLab(QLatin1String(shippedLab));
    for (const Task &task : lab->tasks)
        benchmark::RegisterBenchmark(("verdict/" + task.id.toStdString()).c_str(), verdict, task.id)
            ->Unit(benchmark::kMillisecond);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
