// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/diagnosis.h"

#include "tasks/checks/motion.h"
#include "tasks/one_step.h"

#include <QJsonArray>

#include <algorithm>

namespace cradle {

namespace {

/// Steps that are compared in a run: enough to tell mistakes apart, few enough to be quick.
constexpr std::size_t mostOdd = 24;
constexpr std::size_t mostEven = 48;
/// Share of the odd steps that a mistake may fail to explain: what follows from a state that no
/// sound program reaches.
constexpr double unexplained = 0.05;
/// Share of the other steps that it may spoil: a student's slip may be smaller than the known one.
constexpr double spoilt = 0.25;
/// Share of the steps at which a place must show what a remark is about.
constexpr double oftenInPlace = 0.1;

/// Evenly spread over \p all, at most \p most of them.
std::vector<qint64> thinned(const std::vector<qint64> &all, std::size_t most)
{
    if (all.size() <= most)
        return all;
    std::vector<qint64> some;
    for (std::size_t i = 0; i < most; ++i)
        some.push_back(all[i * all.size() / most]);
    return some;
}

/// A run of the student with the steps at which the reference does something else.
struct Evidence {
    const Variant *scene = nullptr;
    const Observation *run = nullptr;
    std::optional<double> restitution{}; ///< that of the student, where he may choose it
    std::vector<qint64> odd{};           ///< the reference disagrees
    std::vector<qint64> even{};          ///< it agrees
    std::size_t oddInAll = 0;
};

/// Whether something was hit in the step after \p k.
bool isEventful(const Observation &run, qint64 k)
{
    for (int i = 0; i < run.circleCount(); ++i) {
        if (motion::isKicked(run, i, k, run.variant.preset.gravity))
            return true;
    }
    return false;
}

Evidence compareWithReference(const QString &solution, const Variant &scene, const Observation &run,
                              OneStep::Places places,
                              std::optional<double> restitution = std::nullopt)
{
    Evidence evidence{&scene, &run, restitution, {}, {}, 0};
    OneStep reference(solution, scene, restitution);
    if (!reference.runs())
        return evidence;
    std::vector<qint64> quiet;
    for (qint64 k = 0; k < run.steps(); ++k) {
        if (!reference.agrees(run, k, places))
            evidence.odd.push_back(k);
        else
            (isEventful(run, k) ? evidence.even : quiet).push_back(k);
    }
    evidence.oddInAll = evidence.odd.size();
    evidence.odd = thinned(evidence.odd, mostOdd);
    evidence.even = thinned(evidence.even, mostEven / 2);
    for (const qint64 k : thinned(quiet, mostEven / 2))
        evidence.even.push_back(k);
    return evidence;
}

/// How well a known program explains what was seen.
struct Fit {
    std::size_t odd = 0;
    std::size_t oddMissed = 0;
    std::size_t even = 0;
    std::size_t evenMissed = 0;
    std::size_t strange = 0; ///< circles that start otherwise

    [[nodiscard]] bool explains() const
    {
        return odd > 0 && static_cast<double>(oddMissed) <= unexplained * static_cast<double>(odd)
               && static_cast<double>(evenMissed) <= spoilt * static_cast<double>(even);
    }
    [[nodiscard]] bool isBetterThan(const Fit &other) const
    {
        return oddMissed + evenMissed + strange
               < other.oddMissed + other.evenMissed + other.strange;
    }
};

/// How many circles start elsewhere, or otherwise, than the student's.
std::size_t strangeStarts(const Preset &start, const Observation &run)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < start.circles.size(); ++i)
        count += start.circles[i].body == run.circle(static_cast<int>(i), 0) ? 0 : 1;
    return count;
}

Fit fitOf(const QString &program, const std::vector<Evidence> &all, OneStep::Places places)
{
    Fit fit;
    for (const Evidence &evidence : all) {
        OneStep known(program, *evidence.scene, evidence.restitution);
        if (!known.runs())
            continue;
        for (const qint64 k : evidence.odd)
            fit.oddMissed += known.agrees(*evidence.run, k, places) ? 0 : 1;
        // What cannot explain the odd steps is not worth more time.
        fit.odd += evidence.odd.size();
        if (static_cast<double>(fit.oddMissed) > unexplained * static_cast<double>(fit.odd) + 2.0)
            return fit;
        for (const qint64 k : evidence.even)
            fit.evenMissed += known.agrees(*evidence.run, k, places) ? 0 : 1;
        fit.even += evidence.even.size();
        // In the student's own scene a mistake that starts as he does fits better.
        if (!evidence.scene->pinned)
            fit.strange += strangeStarts(known.start(), *evidence.run);
    }
    return fit;
}

const KnownScript *bestFit(const Task &task, const std::vector<Evidence> &evidence,
                           OneStep::Places places)
{
    const KnownScript *best = nullptr;
    Fit bestFit;
    for (const KnownScript &mistake : task.mistakes) {
        const Fit fit = fitOf(mistake.source, evidence, places);
        if (fit.explains() && (!best || fit.isBetterThan(bestFit))) {
            best = &mistake;
            bestFit = fit;
        }
    }
    return best;
}

/// The value of a circle that a "start" check asks for.
bool sameStart(const CheckSpec &check, const Preset &a, const Preset &b)
{
    const auto asks = [&](const char *key) {
        return check.parameters.contains(QLatin1String(key));
    };
    return std::all_of(check.circles.begin(), check.circles.end(), [&](int circle) {
        const auto i = static_cast<std::size_t>(circle);
        if (i >= a.circles.size() || i >= b.circles.size())
            return false;
        const Circle &p = a.circles[i].body;
        const Circle &q = b.circles[i].body;
        return (!asks("position") || p.position == q.position)
               && (!asks("velocity") || p.velocity == q.velocity)
               && (!asks("radius") || p.radius == q.radius)
               && (!asks("density") || p.density == q.density);
    });
}

/// The mistake that starts as the student does; of several, the one whose start is most alike.
const KnownScript *sameWrongStart(const Task &task, const FailedCheck &failed)
{
    const Preset &own = failed.runs.front().variant.preset;
    const KnownScript *best = nullptr;
    int bestDifferent = 0;
    for (const KnownScript &mistake : task.mistakes) {
        const OneStep known(mistake.source, failed.scenes.front());
        if (!known.runs() || !sameStart(*failed.check, known.start(), own))
            continue;
        int different = 0;
        for (std::size_t i = 0; i < own.circles.size(); ++i)
            different += known.start().circles[i].body == own.circles[i].body ? 0 : 1;
        if (!best || different < bestDifferent) {
            best = &mistake;
            bestDifferent = different;
        }
    }
    return best;
}

enum class Restitution { Reference, Student };

const KnownScript *explain(const Task &task, const FailedCheck &failed, OneStep::Places places,
                           Restitution whose)
{
    std::vector<Evidence> evidence;
    for (std::size_t i = 0; i < failed.runs.size(); ++i) {
        const Observation &run = failed.runs[i];
        const auto e = whose == Restitution::Student ? std::optional(run.variant.preset.restitution)
                                                     : std::nullopt;
        evidence.push_back(compareWithReference(task.solution, failed.scenes[i], run, places, e));
    }
    return bestFit(task, evidence, places);
}

/// Whether another integrator than the reference's would be a mistake.
bool asksForIntegrator(const Task &task)
{
    return std::any_of(task.checks.begin(), task.checks.end(), [](const CheckSpec &check) {
        return check.kind == QLatin1String("closed_form")
               || check.parameters.contains(QStringLiteral("integrators"));
    });
}

Diagnosis diagnosisOf(const KnownScript &mistake, const FailedCheck &failed)
{
    return {.mistake = mistake.name, .message = mistake.message, .check = failed.check->id};
}

bool fieldsShow(const Observation &run, const OneStep &reference, const OneStep &known)
{
    const auto has = [](const std::vector<CircleField> &fields, const CircleField &wanted) {
        return std::any_of(fields.begin(), fields.end(), [&](const CircleField &field) {
            return field.circle == wanted.circle
                   && std::abs(field.value - wanted.value) <= 1e-9 * std::abs(wanted.value);
        });
    };
    const auto right = reference.fields();
    const auto odd = known.fields();
    return std::any_of(run.fields.begin(), run.fields.end(), [&](const CircleField &field) {
        return field.value != 0.0 && has(odd, field) && !has(right, field);
    });
}

bool applies(const RemarkSpec &remark, const Task &task, const Variant &scene,
             const Observation &run)
{
    if (remark.compare == RemarkSpec::Compare::Fields)
        return fieldsShow(run, OneStep(task.solution, scene), OneStep(remark.script.source, scene));
    const bool inPlace = remark.compare == RemarkSpec::Compare::Positions;
    const auto places = inPlace ? OneStep::Places::Only : OneStep::Places::Free;
    const std::vector<Evidence> evidence{compareWithReference(task.solution, scene, run, places)};
    const double odd = static_cast<double>(evidence.front().oddInAll);
    if (inPlace && odd < oftenInPlace * static_cast<double>(run.steps()))
        return false;
    return fitOf(remark.script.source, evidence, places).explains();
}

} // namespace

std::optional<Diagnosis> diagnose(const Task &task, const std::vector<FailedCheck> &failed)
{
    for (const FailedCheck &check : failed) {
        if (check.check->kind != QLatin1String("start"))
            continue;
        if (const KnownScript *mistake = sameWrongStart(task, check))
            return diagnosisOf(*mistake, check);
    }
    std::vector<OneStep::Places> passes{OneStep::Places::Exact};
    const bool free = !asksForIntegrator(task);
    if (free)
        passes.push_back(OneStep::Places::Free);
    for (const auto places : passes) {
        for (const FailedCheck &check : failed) {
            if (const KnownScript *mistake = explain(task, check, places, Restitution::Reference))
                return diagnosisOf(*mistake, check);
        }
    }
    for (const FailedCheck &check : failed) {
        if (!free)
            break;
        // Any restitution below 1 is right where the student chooses it.
        if (const KnownScript *mistake =
                explain(task, check, OneStep::Places::Free, Restitution::Student))
            return diagnosisOf(*mistake, check);
    }
    return std::nullopt;
}

std::vector<Remark> remarksOn(const Task &task, const Submission &submission, qint64 seed)
{
    std::vector<Remark> remarks;
    if (!submission.script || task.solution.isEmpty())
        return remarks;
    for (const RemarkSpec &remark : task.remarks) {
        CheckSpec where;
        where.circles = remark.circles;
        where.scene = remark.scene;
        const std::vector<Variant> scenes = makeVariants(submission.preset, where, seed);
        const bool seen = std::any_of(scenes.begin(), scenes.end(), [&](const Variant &scene) {
            const Observation run = observe(scene, submission.program());
            return !run.error && applies(remark, task, scene, run);
        });
        if (seen)
            remarks.push_back({remark.script.name, remark.script.message});
    }
    return remarks;
}

} // namespace cradle
