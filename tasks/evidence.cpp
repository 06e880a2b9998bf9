// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/evidence.h"

#include "tasks/checks/motion.h"

namespace cradle {

namespace {

/// Steps that are compared in a run: enough to tell mistakes apart, few enough to be quick.
constexpr std::size_t mostOdd = 24;
constexpr std::size_t mostEven = 48;

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

/// Whether something was hit in the step after \p k.
bool isEventful(const Observation &run, qint64 k)
{
    for (int i = 0; i < run.circleCount(); ++i) {
        if (motion::isKicked(run, i, k, run.variant.preset.gravity))
            return true;
    }
    return false;
}

/// How many circles start elsewhere, or otherwise, than the student's; and the gravity.
std::size_t strangeStarts(const Preset &start, const Observation &run)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < start.circles.size(); ++i)
        count += start.circles[i].body == run.circle(static_cast<int>(i), 0) ? 0 : 1;
    return count + (start.gravity == run.variant.preset.gravity ? 0 : 1);
}

} // namespace

Evidence compareWithReference(const QString &solution, const Variant &scene, const Observation &run,
                              OneStep::Places places, std::optional<double> restitution)
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
        if (2 * fit.oddMissed > fit.odd + 2)
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

} // namespace cradle
