// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/evidence.h"

#include "tasks/checks/motion.h"

#include <algorithm>

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

} // namespace

Evidence compareWithReference(const QString &solution, const Variant &scene, const Observation &run,
                              OneStep::Places places, std::optional<double> restitution)
{
    Evidence evidence{&scene, &run, restitution, {}, {}, {}, 0, {}};
    OneStep reference(solution, scene, restitution);
    if (!reference.runs())
        return evidence;
    for (qint64 k = 0; k < run.steps(); ++k) {
        if (!reference.agrees(run, k, places)) {
            evidence.odd.push_back(k);
            continue;
        }
        evidence.evenInAll.push_back(k);
        (isEventful(run, k) ? evidence.events : evidence.quiet).push_back(k);
    }
    evidence.oddInAll = evidence.odd.size();
    evidence.odd = thinned(evidence.odd, mostOdd);
    evidence.events = thinned(evidence.events, mostEven / 2);
    evidence.quiet = thinned(evidence.quiet, mostEven / 2);
    return evidence;
}

Fit fitOf(const QString &program, const std::vector<Evidence> &all, OneStep::Places places)
{
    Fit fit;
    for (const Evidence &evidence : all) {
        OneStep known(program, *evidence.scene, evidence.restitution);
        if (!known.runs())
            continue;
        const auto missed = [&](const std::vector<qint64> &steps) {
            return static_cast<std::size_t>(
                std::count_if(steps.begin(), steps.end(),
                              [&](qint64 k) { return !known.agrees(*evidence.run, k, places); }));
        };
        const std::size_t oddMissed = missed(evidence.odd);
        fit.oddMissed += oddMissed;
        // What cannot explain the odd steps is not worth more time.
        fit.odd += evidence.odd.size();
        if (2 * fit.oddMissed > fit.odd + 2)
            return fit;
        const std::size_t eventsMissed = missed(evidence.events);
        fit.events += evidence.events.size();
        fit.eventsMissed += eventsMissed;
        fit.evenMissed += eventsMissed + missed(evidence.quiet);
        fit.even += evidence.events.size() + evidence.quiet.size();
        if (!evidence.odd.empty())
            fit.shared += static_cast<double>(evidence.oddInAll * (evidence.odd.size() - oddMissed))
                          / static_cast<double>(evidence.odd.size());
    }
    for (const Evidence &evidence : all) {
        if (!fit.explains()) // and nothing makes up for it
            return fit;
        OneStep known(program, *evidence.scene, evidence.restitution);
        if (!known.runs())
            continue;
        for (const qint64 k : evidence.evenInAll)
            fit.claimed += known.agrees(*evidence.run, k, places) ? 0.0 : 1.0;
    }
    return fit;
}

} // namespace cradle
