// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/diagnosis.h"

#include "tasks/evidence.h"

#include <QJsonArray>

#include <algorithm>

namespace cradle {

namespace {

/// Share of the steps at which a place must show what a remark is about.
constexpr double oftenInPlace = 0.1;

/// Whether all circles start alike: else what the mistake says of them is not true.
bool sameStart(const Preset &a, const Preset &b)
{
    return std::equal(
        a.circles.begin(), a.circles.end(), b.circles.begin(), b.circles.end(),
        [](const PresetCircle &p, const PresetCircle &q) { return p.body == q.body; });
}

/// Whether the program also moves them as the student's does.
bool samePath(OneStep &known, const Observation &run)
{
    for (qint64 k = 0; k < run.steps(); ++k) {
        if (!known.agrees(run, k, OneStep::Places::Free))
            return false;
    }
    return true;
}

/// The mistake that starts and then moves as the student's program does.
const KnownScript *sameWrongStart(const Task &task, const FailedCheck &failed)
{
    const Observation &run = failed.runs.front();
    for (const KnownScript &mistake : task.mistakes) {
        OneStep known(mistake.source, failed.scenes.front());
        if (known.runs() && sameStart(known.start(), run.variant.preset) && samePath(known, run))
            return &mistake;
    }
    return nullptr;
}

enum class Restitution { Reference, Student };

/// What the student did in the scenes of one failed check, beside the reference.
std::vector<Evidence> evidenceOf(const Task &task, const FailedCheck &failed,
                                 OneStep::Places places, Restitution whose)
{
    std::vector<Evidence> evidence;
    for (std::size_t i = 0; i < failed.runs.size(); ++i) {
        const Observation &run = failed.runs[i];
        const auto e = whose == Restitution::Student ? std::optional(run.variant.preset.restitution)
                                                     : std::nullopt;
        evidence.push_back(compareWithReference(task.solution, failed.scenes[i], run, places, e));
    }
    return evidence;
}

/// How well \p program explains all failed checks; nothing if one speaks against it.
std::optional<Fit> fitOfAll(const QString &program, const std::vector<std::vector<Evidence>> &all,
                            OneStep::Places places)
{
    Fit sum;
    for (const std::vector<Evidence> &evidence : all) {
        const Fit fit = fitOf(program, evidence, places);
        // The first failure it must explain, the others it must not contradict. Where the student
        // answers a hit rightly, it must not say that he does not.
        if (&evidence == &all.front() ? !fit.explains() : fit.isContradicted() || fit.deniesHits())
            return std::nullopt;
        sum.oddMissed += fit.oddMissed;
        sum.evenMissed += fit.evenMissed;
        sum.strange += fit.strange;
    }
    return sum;
}

Finding diagnosisOf(const KnownScript &mistake, const FailedCheck &failed)
{
    return {.mistake = mistake.name, .message = mistake.message, .check = failed.check->id};
}

/// Where gravity acts, sound programs differ in the step of a hit. So what was seen without it
/// decides, if there is any.
void dropFalling(std::vector<std::vector<Evidence>> &all)
{
    const auto falls = [](const std::vector<Evidence> &evidence) {
        return evidence.front().run->variant.preset.gravity != Vec2{};
    };
    if (!std::all_of(all.begin(), all.end(), falls))
        std::erase_if(all, falls);
}

/// The mistake that explains every failed check in which the reference does something else.
std::optional<Finding> explain(const Task &task, const std::vector<FailedCheck> &failed,
                                 OneStep::Places places, Restitution whose)
{
    std::vector<std::vector<Evidence>> all;
    const FailedCheck *shows = nullptr;
    for (const FailedCheck &check : failed) {
        std::vector<Evidence> evidence = evidenceOf(task, check, places, whose);
        if (std::all_of(evidence.begin(), evidence.end(),
                        [](const Evidence &each) { return each.odd.empty(); }))
            continue;
        all.push_back(std::move(evidence));
        shows = shows ? shows : &check;
    }
    if (!shows)
        return std::nullopt;
    dropFalling(all);
    const KnownScript *best = nullptr;
    Fit bestFit;
    for (const KnownScript &mistake : task.mistakes) {
        const std::optional<Fit> fit = fitOfAll(mistake.source, all, places);
        if (fit && (!best || fit->isBetterThan(bestFit))) {
            best = &mistake;
            bestFit = *fit;
        }
    }
    return best ? std::optional(diagnosisOf(*best, *shows)) : std::nullopt;
}

/// Whether another integrator than the reference's would be a mistake.
bool asksForIntegrator(const Task &task)
{
    return std::any_of(task.checks.begin(), task.checks.end(), [](const CheckSpec &check) {
        return check.kind == QLatin1String("closed_form")
               || check.parameters.contains(QStringLiteral("integrators"));
    });
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

std::optional<Finding> diagnose(const Task &task, const std::vector<FailedCheck> &failed)
{
    for (const FailedCheck &check : failed) {
        if (check.check->kind != QLatin1String("start"))
            continue;
        const KnownScript *mistake = sameWrongStart(task, check);
        // From another start what a mistake says of the motion would not be true.
        return mistake ? std::optional(diagnosisOf(*mistake, check)) : std::nullopt;
    }
    if (auto diagnosis = explain(task, failed, OneStep::Places::Exact, Restitution::Reference))
        return diagnosis;
    if (asksForIntegrator(task))
        return std::nullopt;
    if (auto diagnosis = explain(task, failed, OneStep::Places::Free, Restitution::Reference))
        return diagnosis;
    // Any restitution below 1 is right where the student chooses it.
    return explain(task, failed, OneStep::Places::Free, Restitution::Student);
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
