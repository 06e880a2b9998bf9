// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a student's program costs: one update, loading, and a verdict of the checks; with
// CRADLE_PROGRAMS=FOLDER also verdicts on the programs there, named STEP-….lua or STEP/…/….lua.
#include "tasks/judging/checker.h"
#include "tasks/judging/task_laws.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/script/student_script.h"

#include <QDirIterator>
#include <QFile>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <memory>
#include <vector>

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

/// Of this thread, ms.
double processorTime()
{
    timespec taken{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &taken);
    return static_cast<double>(taken.tv_sec) * 1e3 + static_cast<double>(taken.tv_nsec) * 1e-6;
}

/// Verdicts told by the processor time that each takes.
class Verdicts
{
public:
    /// Of a program that nobody has judged before, as a check or a worker meets it.
    void judge(const Task &judged, const QString &source)
    {
        const Submission submission(judged.preset, source);
        const double start = processorTime();
        const auto report = judgeTask(lab(), judged, submission, 1);
        (report && report->passed ? m_passed : m_failed).push_back(processorTime() - start);
    }

    void tell(const char *what)
    {
        std::vector<double> all = m_passed;
        all.insert(all.end(), m_failed.begin(), m_failed.end());
        std::printf("%s\n", what);
        tellOf("all", all);
        tellOf("passed", m_passed);
        tellOf("failed", m_failed);
    }

private:
    static void tellOf(const char *which, std::vector<double> &times)
    {
        if (times.empty())
            return;
        std::sort(times.begin(), times.end());
        double sum = 0.0;
        for (const double time : times)
            sum += time;
        std::printf("  %-8s %4zu   median %6.1f ms   mean %6.1f ms   slowest %6.1f ms\n", which,
                    times.size(), times[times.size() / 2], sum / static_cast<double>(times.size()),
                    times.back());
    }

    std::vector<double> m_passed{};
    std::vector<double> m_failed{};
};

/// The step that the path of a program names; null if it is none of the lab.
const Task *taskOf(const QString &path)
{
    for (const Task &each : lab().tasks) {
        if (path.contains(QLatin1Char('/') + each.id + QLatin1Char('/'))
            || path.contains(QLatin1Char('/') + each.id + QLatin1Char('-')))
            return &each;
    }
    return nullptr;
}

/// Verdicts on all programs below \p folder, in one process: first those of a step for which
/// nothing was measured, then the same where it was, as in a class.
void judgeAll(const QString &folder)
{
    QDirIterator files(folder, {QStringLiteral("*.lua")}, QDir::Files,
                       QDirIterator::Subdirectories);
    std::vector<std::pair<const Task *, QString>> programs;
    while (files.hasNext()) {
        QFile file(files.next());
        const Task *judged = taskOf(file.fileName());
        if (judged && file.open(QIODevice::ReadOnly))
            programs.push_back({judged, QString::fromUtf8(file.readAll())});
    }
    Verdicts alone;
    for (const auto &[judged, source] : programs) {
        forgetLaws();
        alone.judge(*judged, source);
    }
    alone.tell("verdicts, each alone");
    Verdicts together;
    for (const Task &each : lab().tasks)
        lawsOf(each)->measureAll();
    for (const auto &[judged, source] : programs)
        together.judge(*judged, source);
    together.tell("verdicts in a class");
}

} // namespace

int main(int argc, char **argv)
{
    if (const QString folder = qEnvironmentVariable("CRADLE_PROGRAMS"); !folder.isEmpty())
        judgeAll(folder);
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
