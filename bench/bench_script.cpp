// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a student's program costs: one update, loading, and a verdict of the checks.
#include "tasks/checker.h"
#include "tasks/lab_reader.h"
#include "tasks/script/student_script.h"

#include <benchmark/benchmark.h>

using namespace cradle;

namespace {

const Lab &lab()
{
    static const Lab shipped = *readLab(QLatin1String(shippedLab));
    return shipped;
}

const Task &task(const QString &id)
{
    return lab().tasks.at(static_cast<std::size_t>(lab().indexOf(id)));
}

/// One update of the reference solution; target: at most 15 µs.
void update(benchmark::State &state, const QString &id)
{
    StudentScript program(task(id).solution, {.pinned = false, .quiet = true});
    Preset scene = task(id).preset;
    if (program.begin(scene)) {
        state.SkipWithError("it does not load");
        return;
    }
    World world = initialWorld(scene);
    for (auto _ : state) {
        if (program.advance(world, scene.timestep)) {
            state.SkipWithError("it stopped");
            break;
        }
        ++world.step;
    }
}

/// A new Lua state with all that a program finds there, and the file read and run.
void load(benchmark::State &state, const QString &source, const QString &id)
{
    for (auto _ : state) {
        StudentScript program(source);
        Preset scene = task(id).preset;
        benchmark::DoNotOptimize(program.begin(scene));
    }
}

/// A verdict with its diagnosis; targets: median step 300 ms, slowest 1 s.
void verdict(benchmark::State &state, const Task &judged, const QString &source)
{
    const Submission submission(judged.preset, source);
    for (auto _ : state)
        benchmark::DoNotOptimize(judgeTask(lab(), judged, submission, 1));
}

void registerVerdicts(const Task &judged)
{
    const std::string name = "verdict/" + judged.id.toStdString();
    benchmark::RegisterBenchmark((name + "/solution").c_str(), verdict, judged, judged.solution)
        ->Unit(benchmark::kMillisecond);
    for (const KnownScript &mistake : judged.mistakes)
        benchmark::RegisterBenchmark((name + "/" + mistake.name.toStdString()).c_str(), verdict,
                                     judged, mistake.source)
            ->Unit(benchmark::kMillisecond);
}

} // namespace

int main(int argc, char **argv)
{
    const QString last = QStringLiteral("L42T17");
    for (const QString &id : {QStringLiteral("L42T12"), last})
        benchmark::RegisterBenchmark(("update/" + id.toStdString()).c_str(), update, id)
            ->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark("load/empty", load, QString(), last)
        ->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark("load/L42T17", load, task(last).solution, last)
        ->Unit(benchmark::kMicrosecond);
    for (const Task &judged : lab().tasks)
        registerVerdicts(judged);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
