// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/long_run.h"
#include "tasks/judging/pair_range.h"

#include <array>

namespace cradle {

namespace {

/// Before each meeting, s: some come as soon as the one before is over.
constexpr std::array waits{0.0, 0.0, 0.3, 0.0, 0.7, 1.3, 0.0, 2.0, 0.0, 3.0, 0.0, 5.0};
/// The middles of the two, m; none is that of MeasuredPair.
constexpr std::array places{Vec2{-2.31, 1.87}, Vec2{1.93, 2.29},  Vec2{-1.79, -2.13},
                            Vec2{2.17, -1.71}, Vec2{0.29, 1.37},  Vec2{-0.83, -1.91},
                            Vec2{1.61, -0.37}, Vec2{-2.53, -0.41}};
/// Of a run whose first meeting is late, s: what counts the time is told from what counts meetings.
constexpr double lateStart = 12.0;

} // namespace

bool PairRange::meetIn(LongRun &run, PairOccasion &meeting) const
{
    PairHit &hit = meeting.hit;
    run.set(hit.stage.preset);
    const std::vector<Flight> &flights = m_flight.at({}, shortStep);
    Probe &probe = run.probe();
    for (int step = 1; step <= fewSteps && !hit.answered; ++step) {
        const std::vector<Circle> before = probe.world().circles;
        if (!probe.step())
            break;
        note(hit, before, probe, flights, step);
    }
    meeting.when.time = run.time();
    return run.runs();
}

std::vector<PairOccasion> PairRange::again(const PairHit &model) const
{
    const Meeting &meeting = model.meeting;
    const bool isElsewhere = model.isMet() && !model.fits(meeting.sum());
    const double aim = isElsewhere ? 0.5 * (model.before + model.reached) : meeting.sum();
    const auto at = [&](Vec2 place) {
        const double distance = aim + 2.4 * std::abs(meeting.closing()) * shortStep;
        PairOccasion one{{.meeting = meeting, .slowness = slowness(shortStep)}, {.place = place}};
        one.hit.meeting.middle = place;
        one.hit.stage = stageOf(one.hit.meeting, distance, aim, shortStep);
        return one;
    };
    std::vector<PairOccasion> all{
        {model,
         {.time = static_cast<double>(model.step) * model.stage.preset.timestep,
          .place = meeting.middle}}};
    PairOccasion late = at(places.back());
    LongRun lateRun(m_program, m_ground, late.hit.stage.preset);
    lateRun.wait(lateStart);
    if (!meetIn(lateRun, late))
        return {};
    all.push_back(late);
    LongRun run(m_program, m_ground, at(places.front()).hit.stage.preset);
    double last = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < waits.size(); ++k) {
        PairOccasion one = at(places[k % places.size()]);
        run.wait(waits[k]);
        if (!meetIn(run, one))
            return {};
        one.when.number = one.when.ownNumber = static_cast<int>(k) + 1;
        one.when.pause = one.when.time - last;
        last = one.when.time;
        all.push_back(one);
    }
    return all;
}

std::vector<PairOccasion> measurePairAgain(const QString *program, const Ground &ground,
                                           const MeasuredFlight &flight)
{
    const PairRange range(program, ground, flight);
    if (!program || !ground.pair.asked || ground.flights.size() < 2 || !range.isKnown())
        return {};
    return range.again(range.look(equalMeeting(ground.pair)));
}

} // namespace cradle
