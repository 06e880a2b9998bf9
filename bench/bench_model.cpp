// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of two circles and of a heap at rest, and a verdict of the checks; bench_engines has
// gases.
#include "model/preset_json.h"
#include "model/stepper.h"
#include "tasks/checker.h"
#include "tasks/lab_reader.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
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

/// The largest overlap of two circles, in radii; all have the same.
double deepestOverlap(std::vector<Circle> circles)
{
    std::sort(circles.begin(), circles.end(),
              [](const Circle &a, const Circle &b) { return a.position.x < b.position.x; });
    double deepest = 0.0;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        const Circle &a = circles[i];
        for (std::size_t j = i + 1; j < circles.size(); ++j) {
            const Vec2 d = circles[j].position - a.position;
            if (d.x > 2.0 * a.radius)
                break;
            deepest = std::max(deepest, 2.0 - length(d) / a.radius);
        }
    }
    return deepest;
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

/// Six seconds of \p count circles, 40 % of the square, from where they are strewn to where they
/// lie: what the mean and the worst step take, and by how much two overlap at most.
void fall(benchmark::State &state, int count)
{
    const Preset preset = heapOf(count, Timing::Continuous);
    double worst = 0.0;
    double sum = 0.0;
    double overlap = 0.0;
    double steps = 0.0;
    for (auto _ : state) {
        World world = initialWorld(preset);
        Stepper stepper(preset);
        std::vector<Hit> hits;
        while (world.step < 360) {
            const std::clock_t begin = std::clock();
            hits.clear();
            stepper.advance(world, hits);
            const double took = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
            worst = std::max(worst, took);
            sum += took;
            ++steps;
            state.PauseTiming();
            overlap = std::max(overlap, deepestOverlap(world.circles));
            state.ResumeTiming();
        }
    }
    state.counters["mean_ms"] = sum / steps;
    state.counters["worst_ms"] = worst;
    state.counters["overlap_r"] = overlap;
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
    for (const int count : {100, 300, 1000})
        benchmark::RegisterBenchmark(("fall/" + std::to_string(count)).c_str(), fall, count)
            ->Unit(benchmark::kMillisecond)
            ->Iterations(1);
    const Result<Lab> lab = readLab(QLatin1String(shippedLab));
    for (const Task &task : lab->tasks)
        benchmark::RegisterBenchmark(("verdict/" + task.id.toStdString()).c_str(), verdict, task.id)
            ->Unit(benchmark::kMillisecond);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
