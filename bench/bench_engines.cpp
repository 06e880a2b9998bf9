// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The gas in Cradle's engine, in Box2D, in Chipmunk and in the textbook's event-driven simulation:
// what a simulated second costs, what it is worth, and what memory it takes; and a heap, from where
// it falls to where it lies. The engines take turns at random, so that a busy machine is busy for
// all. bench/compare makes a table of it.
//     bench_engines [--quick] [--benchmark_...]     --quick: no more than 1,000 circles
#include "bench/gas.h"
#include "bench/gas_engine.h"
#include "bench/heap_meter.h"

#include <benchmark/benchmark.h>

#include <cstring>
#include <ctime>
#include <string>

using namespace cradle;

namespace {

constexpr double framesPerSecond = 60.0;
constexpr double standardGravity = 9.81; // m/s²

struct Contestant {
    const char *name = "";
    MakeEngine make = nullptr;
    int largestTruth = 0;      ///< circles; more would take too long to follow for seconds
    double gravitySpan = 60.0; ///< s to follow under gravity at most
    double memorySpan = 1.0;   ///< s to simulate until memory has shown its peak
};

constexpr Contestant contestants[] = {
    {"exact", makeExact, 50'000, 60.0, 1.0},      {"continuous", makeContinuous, 50'000, 60.0, 1.0},
    {"stepped", makeStepped, 50'000, 60.0, 1.0},  {"baseline", makeBaseline, 50'000, 0.0, 1.0},
    {"box2d", makeBox2d, 1000, 5.0, 0.05}, // under gravity it heats up: seconds cost ever more
    {"chipmunk", makeChipmunk, 1000, 60.0, 0.25},
};

void advanceFrame(GasEngine &engine)
{
    for (int i = engine.stepsPerFrame(); i > 0; --i)
        engine.step();
}

/// A frame of 1/60 s. The engine goes on from turn to turn: the gas stays the same gas.
void cost(benchmark::State &state, const Contestant &contestant, int count,
          std::unique_ptr<GasEngine> &engine)
{
    if (!engine) {
        engine = contestant.make(gas(count, 0.0));
        // The first frames build trees and caches.
        for (int i = 0; i < (count > 10'000 ? 3 : 30); ++i)
            advanceFrame(*engine);
    }
    const qint64 before = engine->hitCount();
    for (auto _ : state)
        advanceFrame(*engine);
    const auto frames = static_cast<double>(state.iterations());
    state.counters["hits"] = benchmark::Counter(static_cast<double>(engine->hitCount() - before),
                                                benchmark::Counter::kIsRate);
    state.counters["simulated"] =
        benchmark::Counter(frames / framesPerSecond, benchmark::Counter::kIsRate);
}

/// How far energy drifts (a share of what there was) and how deep circles overlap (in radii).
/// Large gases are looked at once a frame, small ones after every step.
void truth(benchmark::State &state, const Contestant &contestant, int count, double gravity,
           double seconds)
{
    const Gas start = gas(count, gravity);
    std::vector<Motion> motions;
    double drift = 0.0;
    double overlap = 0.0;
    for (auto _ : state) {
        const std::unique_ptr<GasEngine> engine = contestant.make(start);
        engine->read(motions);
        const double energy = specificEnergy(start, motions);
        const int lookEvery = count > 1000 ? engine->stepsPerFrame() : 1;
        const int steps = static_cast<int>(seconds * framesPerSecond) * engine->stepsPerFrame();
        for (int i = 1; i <= steps; ++i) {
            engine->step();
            if (i % lookEvery == 0) {
                engine->read(motions);
                overlap = std::max(overlap, worstOverlap(start, motions));
            }
        }
        drift = specificEnergy(start, motions) / energy - 1.0;
    }
    state.counters["drift"] = drift;
    state.counters["overlap"] = overlap;
    state.counters["seconds"] = seconds;
}

/// The most that the engine ever holds, besides the circles that it is handed.
void memory(benchmark::State &state, const Contestant &contestant, int count)
{
    const Gas start = gas(count, 0.0);
    std::ptrdiff_t most = 0;
    for (auto _ : state) {
        HeapMeter::restart();
        const std::ptrdiff_t before = HeapMeter::held();
        const std::unique_ptr<GasEngine> engine = contestant.make(start);
        for (int i = 0; i < static_cast<int>(contestant.memorySpan * framesPerSecond); ++i)
            advanceFrame(*engine);
        most = HeapMeter::peak() - before;
    }
    state.counters["megabytes"] = static_cast<double>(most) / 1e6;
}

/// Six seconds of a heap, from where its circles are strewn to where they lie: the mean and the
/// worst step of 1/60 s (ms of CPU), the deepest overlap (radii), and by what share of the energy
/// at the start a step gained most.
void heapFall(benchmark::State &state, MakeEngine make, int count)
{
    constexpr int frames = 360;
    const Gas start = heap(count);
    std::vector<Motion> motions;
    double sum = 0.0;
    double worst = 0.0;
    double overlap = 0.0;
    double gain = 0.0;
    for (auto _ : state) {
        const std::unique_ptr<GasEngine> engine = make(start);
        engine->read(motions);
        const double whole = specificEnergy(start, motions);
        double before = whole;
        for (int i = 0; i < frames; ++i) {
            const std::clock_t begin = std::clock();
            advanceFrame(*engine);
            const double took = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
            sum += took;
            worst = std::max(worst, took);
            engine->read(motions);
            overlap = std::max(overlap, worstOverlap(start, motions));
            const double energy = specificEnergy(start, motions);
            gain = std::max(gain, (energy - before) / whole);
            before = energy;
        }
    }
    state.counters["mean"] = sum / frames;
    state.counters["worst"] = worst;
    state.counters["overlap"] = overlap;
    state.counters["gain"] = gain;
}

void registerHeaps(bool quick)
{
    std::vector<int> sizes{300, 1000};
    if (!quick)
        sizes.push_back(10'000);
    const std::pair<const char *, MakeEngine> engines[] = {
        {"continuous", makePiled}, {"box2d", makeBox2d}, {"chipmunk", makeChipmunk}};
    for (const auto &[name, make] : engines) {
        for (const int count : sizes)
            benchmark::RegisterBenchmark(
                (std::string("heap/") + name + '/' + std::to_string(count)).c_str(), heapFall, make,
                count)
                ->Iterations(1)
                ->Unit(benchmark::kMillisecond);
    }
}

void registerTruth(const Contestant &contestant, int count, double gravity)
{
    double seconds = count > 10'000 ? 10.0 : 60.0;
    if (gravity > 0.0)
        seconds = std::min(seconds, contestant.gravitySpan);
    if (seconds == 0.0)
        return;
    const std::string name = std::string("truth/") + contestant.name + '/' + std::to_string(count)
                             + (gravity > 0.0 ? "/gravity" : "/free");
    benchmark::RegisterBenchmark(name.c_str(), truth, contestant, count, gravity, seconds)
        ->Iterations(1)
        ->Repetitions(1)
        ->Unit(benchmark::kMillisecond);
}

/// \param engines  outlive the run; filled at the first turn
void registerAll(bool quick, std::vector<std::unique_ptr<GasEngine>> &engines)
{
    // From 1,000 to 10,000 five sizes, evenly in the logarithm, for the exponent.
    std::vector<int> sizes{2, 1000};
    if (!quick)
        sizes.insert(sizes.end(), {1778, 3162, 5623, 10'000, 50'000});
    engines.resize(std::size(contestants) * sizes.size());
    auto engine = engines.begin();
    for (const Contestant &contestant : contestants) {
        for (const int count : sizes) {
            const std::string suffix = std::string(contestant.name) + '/' + std::to_string(count);
            benchmark::RegisterBenchmark(("cost/" + suffix).c_str(), cost, contestant, count,
                                         std::ref(*engine++))
                ->Unit(benchmark::kMillisecond);
            if (count == 50'000)
                benchmark::RegisterBenchmark(("memory/" + suffix).c_str(), memory, contestant,
                                             count)
                    ->Iterations(1)
                    ->Repetitions(1)
                    ->Unit(benchmark::kMillisecond);
            const bool isForExponent = count > 1000 && count < 10'000;
            if (count > contestant.largestTruth || isForExponent)
                continue;
            registerTruth(contestant, count, 0.0);
            registerTruth(contestant, count, standardGravity);
        }
    }
}

} // namespace

int main(int argc, char **argv)
{
    std::string interleave = "--benchmark_enable_random_interleaving=true";
    std::string repetitions = "--benchmark_repetitions=5";
    std::string minimum = "--benchmark_min_time=0.1"; // s of each turn
    std::vector<char *> arguments{argv[0], interleave.data(), repetitions.data(), minimum.data()};
    bool quick = false;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--quick") == 0)
            quick = true;
        else
            arguments.push_back(argv[i]); // later ones prevail
    }
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data()))
        return 1;
    std::vector<std::unique_ptr<GasEngine>> engines;
    registerAll(quick, engines);
    registerHeaps(quick);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
