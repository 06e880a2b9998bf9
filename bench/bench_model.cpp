// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of two circles and of a heap at rest, and a verdict of the checks; bench_engines has
// gases.
#include "model/files/preset_json.h"
#include "model/run/stepper.h"
#include "tasks/judging/checker.h"
#include "tasks/reading/lab_reader.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <string>

using namespace cradle;

namespace {

/// Two circles under gravity, one moved by Euler and one by symplectic Euler, with hits of all
/// kinds.
Preset twoCircles(Timing timing)
{
    Preset preset;
    preset.gravity = Vec2{0.0, -9.81};
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, timing};
    preset.circles.resize(2);
    preset.circles[0].body = {.position = {-2.0, 2.0}, .velocity = {3.0, 0.0}};
    preset.circles[0].integrator = Integrator::Euler;
    preset.circles[1].body = {.position = {2.0, 1.9}, .velocity = {-3.0, 0.0}};
    preset.circles[1].integrator = Integrator::SymplecticEuler;
    return preset;
}

/// A step of the engine with the hits that it reports; target: at most 0.5 µs.
void step(benchmark::State &state, Timing timing)
{
    const Preset preset = twoCircles(timing);
    const World start = initialWorld(preset);
    Stepper stepper(preset);
    World world = start;
    std::vector<Hit> hits;
    double hitCount = 0.0;
    for (auto _ : state) {
        // Euler's energy grows without end: ten seconds of the scene, again and again.
        if (world.step == 600)
            world = start;
        hits.clear();
        stepper.advance(world, hits);
        hitCount += static_cast<double>(hits.size());
    }
    state.counters["hits_per_step"] =
        benchmark::Counter(hitCount, benchmark::Counter::kAvgIterations);
}

/// \p count circles, 40 % of the square, that fall into a heap; e < 1.
Preset heapOf(int count, Timing timing)
{
    constexpr double share = 0.4;
    Preset preset;
    preset.gravity = Vec2{0.0, -9.81};
    preset.restitution = 0.5;
    preset.timestep = 1.0 / 60.0;
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, timing};
    const double area = share * 4.0 * preset.halfWidth * preset.halfWidth;
    preset.fill = CircleFill{.count = count,
                             .radius = std::sqrt(area / (std::numbers::pi * count)),
                             .rmsSpeed = 1.0,
                             .seed = 1};
    preset.circles = *makeCircles(*preset.fill, preset.halfWidth);
    return preset;
}

/// A step of circles that have fallen for 3 s. Target: no longer than what it steps over, 16.7 ms.
void heap(benchmark::State &state, Timing timing, int count)
{
    constexpr int stepsOfFall = 180;
    const Preset preset = heapOf(count, timing);
    World world = initialWorld(preset);
    Stepper stepper(preset);
    std::vector<Hit> hits;
    for (int step = 0; step < stepsOfFall; ++step)
        stepper.advance(world, hits);
    for (auto _ : state) {
        hits.clear();
        stepper.advance(world, hits);
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
    for (const auto &[name, timing] :
         {std::pair("step/discrete", Timing::Discrete),
          std::pair("step/continuous", Timing::Continuous), std::pair("step/exact", Timing::Exact)})
        benchmark::RegisterBenchmark(name, step, timing);
    for (const auto &[name, timing] : {std::pair("heap/continuous/", Timing::Continuous),
                                       std::pair("heap/exact/", Timing::Exact)}) {
        for (const int count : {30, 100, 300, 1000})
            benchmark::RegisterBenchmark((name + std::to_string(count)).c_str(), heap, timing,
                                         count)
                ->Unit(benchmark::kMillisecond);
    }
    const Result<Lab> lab = readLab(QLatin1String(shippedLab));
    for (const Task &task : lab->tasks)
        benchmark::RegisterBenchmark(("verdict/" + task.id.toStdString()).c_str(), verdict, task.id)
            ->Unit(benchmark::kMillisecond);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
