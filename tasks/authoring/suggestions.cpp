// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/mutations.h"

#include "tasks/report/report_text.h"
#include "tasks/runs/observation.h"

#include <QCryptographicHash>
#include <QJsonArray>
#include <QMutex>
#include <QSet>
#include <QtConcurrentMap>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Programs that agree to this share are the same: rounding in another order of operations.
constexpr double sameShare = 1e-6;
constexpr qint64 seed = 1;

/// Checks whose scenes show what those of the step may not: both circles against all walls, into
/// corners, and parting while they overlap.
std::vector<CheckSpec> probesOf(const Task &task)
{
    std::vector<CheckSpec> probes;
    std::vector<int> circles{0};
    if (task.preset.circles.size() > 1)
        circles.push_back(1);
    for (const char *kind : {"directions", "corners", "encounters", "parting"}) {
        const bool pair = qstrcmp(kind, "encounters") == 0 || qstrcmp(kind, "parting") == 0;
        if (pair && circles.size() < 2)
            continue;
        CheckSpec probe;
        probe.circles = circles;
        probe.scene = {{QStringLiteral("kind"), QLatin1String(kind)},
                       {QStringLiteral("count"), 6},
                       {QStringLiteral("radii"), QJsonArray{0.15, 0.4}},
                       {QStringLiteral("restitutions"), QJsonArray{1.0, 0.5}}};
        // Fast enough to come to the walls.
        if (!pair)
            probe.scene.insert(QStringLiteral("speeds"), QJsonArray{3.0, 4.0});
        probes.push_back(probe);
    }
    return probes;
}

/// The scenes of all checks of a step, and of probes beside them.
std::vector<Variant> scenesOf(const Task &task)
{
    std::vector<Variant> scenes;
    std::vector<CheckSpec> checks = task.checks;
    for (CheckSpec &probe : probesOf(task))
        checks.push_back(std::move(probe));
    for (const CheckSpec &check : checks) {
        for (Variant &scene : makeVariants(task.preset, check, seed)) {
            const bool known = std::any_of(scenes.begin(), scenes.end(), [&](const Variant &other) {
                return other.preset == scene.preset && other.duration >= scene.duration;
            });
            if (!known)
                scenes.push_back(std::move(scene));
        }
    }
    return scenes;
}

bool isNear(Vec2 a, Vec2 b)
{
    return length(a - b) <= sameShare * (1.0 + length(a) + length(b));
}

bool doesTheSame(const Observation &a, const Observation &b)
{
    if (a.steps() != b.steps() || a.circleCount() != b.circleCount())
        return false;
    for (qint64 k = 0; k <= a.steps(); ++k) {
        for (int i = 0; i < a.circleCount(); ++i) {
            const Circle &ca = a.circle(i, k);
            const Circle &cb = b.circle(i, k);
            if (!isNear(ca.position, cb.position) || !isNear(ca.velocity, cb.velocity)
                || std::abs(ca.radius - cb.radius) > sameShare
                || std::abs(ca.density - cb.density) > sameShare)
                return false;
        }
    }
    return true;
}

/// The end of a run in steps of sameShare: alike for programs that do the same.
QByteArray tracesOf(const Observation &run)
{
    QByteArray traces;
    for (const qint64 k : {run.steps() / 3, 2 * run.steps() / 3, run.steps()}) {
        for (int i = 0; i < run.circleCount(); ++i) {
            const Circle &c = run.circle(i, k);
            for (const double value : {c.position.x, c.position.y, c.velocity.x, c.velocity.y})
                traces += QByteArray::number(std::round(value / sameShare) + 0.0, 'f', 0) + ' ';
        }
    }
    return traces;
}

/// One mutant and what became of it.
struct Trial {
    Mutant mutant;
    QByteArray behaviour{}; ///< empty if it stops or does what the solution does
    std::optional<CheckReport> report{};
};

/// Fills in Trial::behaviour.
void tryOut(Trial &trial, const std::vector<Variant> &scenes,
            const std::vector<Observation> &references, const std::function<bool()> &stop)
{
    QCryptographicHash hash(QCryptographicHash::Sha1);
    bool differs = false;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const Observation run = observe(scenes[i], &trial.mutant.source, stop);
        if (run.error || stop())
            return;
        differs = differs || !doesTheSame(run, references[i]);
        hash.addData(tracesOf(run));
    }
    if (differs)
        trial.behaviour = hash.result();
}

} // namespace

Suggestions suggestMistakes(const Lab &lab, const Task &task, const JudgeHooks &hooks)
{
    if (task.solution.isEmpty())
        return {};
    const std::vector<Variant> scenes = scenesOf(task);
    std::vector<Observation> references;
    for (const Variant &scene : scenes)
        references.push_back(observe(scene, &task.solution));
    std::vector<Trial> trials;
    for (Mutant &mutant : mutantsOf(task.solution))
        trials.push_back({std::move(mutant), {}, {}});

    QMutex mutex;
    int done = 0;
    const int total = 2 * static_cast<int>(trials.size());
    bool cancelled = false;
    const auto stop = [&] {
        const QMutexLocker lock(&mutex);
        cancelled = cancelled || (hooks.cancelled && hooks.cancelled());
        return cancelled;
    };
    const auto advance = [&](int steps) {
        const QMutexLocker lock(&mutex);
        done += steps;
        if (hooks.progress && !cancelled)
            hooks.progress(done, total);
    };
    QtConcurrent::blockingMap(trials, [&](Trial &trial) {
        tryOut(trial, scenes, references, stop);
        advance(1);
    });
    QSet<QByteArray> seen;
    std::erase_if(trials, [&](const Trial &trial) {
        const bool drop = trial.behaviour.isEmpty() || seen.contains(trial.behaviour);
        seen.insert(trial.behaviour);
        return drop;
    });
    advance(total / 2 - static_cast<int>(trials.size()));
    QtConcurrent::blockingMap(trials, [&](Trial &trial) {
        trial.report =
            judgeTask(lab, task, answered(task, Submission(task.preset, trial.mutant.source)), seed,
                      {.cancelled = stop, .provesLines = false});
        advance(1);
    });
    if (stop())
        return {};

    Suggestions made;
    std::vector<Suggestion> &suggestions = made.list;
    for (Trial &trial : trials) {
        const CheckReport &report = *trial.report;
        const auto failures =
            std::count_if(report.checks.begin(), report.checks.end(),
                          [](const CheckOutcome &check) { return !check.passed; });
        const auto failed = std::find_if(report.checks.begin(), report.checks.end(),
                                         [](const CheckOutcome &check) { return !check.passed; });
        if (failures == 1 && !made.alone.contains(failed->id))
            made.alone.append(failed->id);
        if (report.error || (!report.passed && !mistakesOf(report).isEmpty()))
            continue;
        Suggestion suggestion;
        suggestion.kind = report.passed             ? Suggestion::Kind::Passes
                          : report.findings.empty() ? Suggestion::Kind::NotDiagnosed
                                                    : Suggestion::Kind::ToldByLaw;
        if (failed != report.checks.end()) {
            suggestion.check = failed->id;
            suggestion.finding = failed->message;
        }
        if (suggestion.kind == Suggestion::Kind::ToldByLaw)
            suggestion.finding = report.diagnosis()->message.section(QLatin1Char('\n'), 0, 0);
        suggestion.mutant = std::move(trial.mutant);
        suggestions.push_back(std::move(suggestion));
    }
    std::stable_sort(suggestions.begin(), suggestions.end(),
                     [](const Suggestion &a, const Suggestion &b) { return a.kind < b.kind; });
    return made;
}

} // namespace cradle
