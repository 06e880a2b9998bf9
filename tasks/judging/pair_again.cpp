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
/// How many times as fast they are, and from where they come: what is kept from one meeting is
/// wrong in the next.
constexpr std::array speeds{1.0, 0.8, 1.3, 0.9, 1.2, 0.7, 1.1, 1.4, 0.85, 1.0, 0.95, 1.15};
constexpr std::array turns{0.0,   180.0, 85.0,  40.0,  265.0, 150.0,
                           200.0, 20.0,  300.0, 110.0, 240.0, 60.0}; // degrees
/// Of a run whose first meeting is late, s: what counts the time is told from what counts meetings.
constexpr double lateStart = 12.0;

} // namespace

bool PairRange::meetIn(LongRun &run, PairOccasion &meeting) const
{
    PairHit &hit = meeting.hit;
    run.set(hit.stage.preset);
    Probe &probe = run.probe();
    for (int step = 1; step <= fewSteps && !hit.answered; ++step) {
        const std::vector<Circle> before = probe.world().circles;
        if (!probe.step())
            break;
        note(hit, before, probe, step);
    }
    meeting.when.time = run.time();
    return run.runs();
}

/// Of a hit that goes on after its first step: for how many more; none where that takes long.
int PairRange::stepsAfter(const PairHit &model) const
{
    constexpr int most = 12;
    constexpr double smallest = 1e-9; // m and m/s
    Probe probe(m_program, model.stage);
    int last = 0;
    for (int k = 1; k <= model.step + most; ++k) {
        const std::vector<Circle> before = probe.world().circles;
        if (!probe.step())
            return 0;
        for (std::size_t i = 0; i < 2 && k > model.step; ++i) {
            const Motion free = m_paths.free(i, before, probe.start().timestep);
            const Circle &now = probe.circle(static_cast<int>(i));
            if (length(now.position - free.position) + length(now.velocity - free.velocity)
                > smallest)
                last = k - static_cast<int>(model.step);
        }
    }
    return last == most ? 0 : last;
}

std::vector<PairOccasion> PairRange::again(const PairHit &model) const
{
    const Meeting &meeting = model.meeting;
    const bool isElsewhere = model.isMet() && !model.fits(meeting.sum());
    const double aim = isElsewhere ? 0.5 * (model.before + model.reached) : meeting.sum();
    const auto at = [&](Vec2 place, double speed = 1.0, double turn = 0.0) {
        PairOccasion one{{.meeting = meeting, .slowness = m_paths.slowness(shortStep)},
                         {.place = m_ground.pair.room * place}};
        Meeting &m = one.hit.meeting;
        m.middle = one.when.place;
        // Where they answer is known of this line alone, if it is not where the rims meet.
        m.degrees += isElsewhere ? 0.0 : turn;
        m.velocities = faster(m.velocities, speed);
        const double distance = aim + 2.4 * std::abs(m.closing()) * shortStep;
        one.hit.stage = stageOf(m, distance, aim, shortStep);
        one.when.speed = one.hit.slowness * m.closing();
        return one;
    };
    std::vector<PairOccasion> all{
        {model,
         {.time = static_cast<double>(model.step) * model.stage.preset.timestep,
          .place = meeting.middle,
          .speed = model.slowness * meeting.closing()}}};
    PairOccasion late = at(places.back());
    LongRun lateRun(m_program, m_ground, late.hit.stage.preset);
    lateRun.wait(lateStart);
    if (!meetIn(lateRun, late))
        return {};
    all.push_back(late);
    const int rest = model.isMet() ? stepsAfter(model) : 0;
    LongRun run(m_program, m_ground, at(places.front()).hit.stage.preset);
    double last = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < waits.size(); ++k) {
        PairOccasion one = at(places[k % places.size()], speeds[k], turns[k]);
        run.wait(waits[k]);
        if (!meetIn(run, one))
            return {};
        one.when.number = one.when.ownNumber = static_cast<int>(k) + 1;
        one.when.pause = one.when.time - last;
        last = one.when.time;
        all.push_back(one);
        // What is left of one hit is no answer to the next.
        for (int step = 0; step < rest && run.runs(); ++step)
            run.probe().step();
    }
    return all;
}

std::vector<PairOccasion> measurePairAgain(const QString *program, const Ground &ground,
                                           const MeasuredFlight &flight)
{
    const PairRange range(program, ground, flight);
    if (!program || !ground.pair.asked || ground.flights.size() < 2 || !range.isKnown()
        || !range.isEven())
        return {};
    return range.again(range.look(equalMeeting(ground.pair)));
}

} // namespace cradle
