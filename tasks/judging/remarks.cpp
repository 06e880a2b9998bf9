// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/remarks.h"

#include "tasks/judging/evidence.h"

#include <algorithm>

namespace cradle {

namespace {

/// Share of the steps at which a place must show what a remark is about.
constexpr double oftenInPlace = 0.1;

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

std::vector<Remark> remarksOn(const Task &task, SubmissionRuns &runs, qint64 seed)
{
    const Submission &submission = runs.submission();
    std::vector<Remark> remarks;
    if (!submission.script || task.solution.isEmpty())
        return remarks;
    for (const RemarkSpec &remark : task.remarks) {
        CheckSpec where;
        where.circles = remark.circles;
        where.scene = remark.scene;
        std::vector<Variant> scenes = makeVariants(submission.preset, where, seed);
        const bool seen = std::any_of(scenes.begin(), scenes.end(), [&](Variant &scene) {
            scene.locked = task.locked; // as in the checks
            const Observation &run = runs.of(scene);
            return !run.error && applies(remark, task, scene, run);
        });
        if (seen)
            remarks.push_back({remark.script.name, remark.script.message});
    }
    return remarks;
}

} // namespace cradle
