// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/brief_beside.h"
#include "tasks/judging/flight_comparison.h"
#include "tasks/judging/flight_scenes.h"
#include "tasks/judging/likeness.h"

#include <algorithm>

namespace cradle {

namespace {

/// Judges the flight of one circle.
class FlightJudge : FlightComparison
{
public:
    explicit FlightJudge(const FlightComparison &comparison)
        : FlightComparison(comparison)
    {
    }

    /// What is wrong, worst first.
    [[nodiscard]] std::vector<FlightSaid> judge() const
    {
        std::vector<FlightSaid> said = judgeByItself();
        const auto unlike = unlikeStepsSaid(*this);
        if (unlike)
            said = {*unlike};
        // What is shot at walls starts anew, and the steps that it makes there may be the odd ones.
        const bool hidesWalls = !unlike && !said.empty() && firstStepSaid(*this).has_value();
        for (FlightSaid &each : said)
            each.hidesWalls |= hidesWalls;
        if (hidesWalls && said.front().suspect != Suspect::Kept && !comesToWalls())
            said.front().body +=
                QLatin1Char(' ')
                + FlightText::tr("The first step of a run is made in another way.");
        if (!said.empty() && !said.front().isMethod) {
            if (auto wall = strayWallSaid(*this))
                return {*wall};
        }
        // What the others do shows in all that is measured while they do it.
        if (!said.empty() && !carriedSaid(*this)) {
            if (auto fault = othersSaid(*this))
                return {*fault};
        }
        return said;
    }

private:
    /// Whether the flights that tell how the first step is made come so far that walls had a part
    /// in it.
    [[nodiscard]] bool comesToWalls() const
    {
        const Flight &f = flight(0);
        const auto isFar = [&](const Flight::Step &step) {
            return std::max({length(step.way), timestep() * length(step.velocity),
                             timestep() * length(step.velocity + step.turn)})
                   > farInAStep;
        };
        return isFar(f.fromRest) || std::any_of(f.seen.begin(), f.seen.end(), isFar);
    }

    /// The same as if no other circle had a part in it; what hides the rest stands alone.
    [[nodiscard]] std::vector<FlightSaid> judgeByItself() const
    {
        std::vector<FlightSaid> said;
        if (auto fault = timeless())
            return {*fault};
        for (const auto law : {strongFallSaid, strongDriftSaid}) {
            if (auto fault = law(*this))
                return {*fault};
        }
        if (auto fault = letGo())
            return {*fault};
        // Who is put beside another circle may be turned by a hit there.
        if (auto fault = leap();
            fault && flight(0).leap->speed == Flight::Speed::Any && !flight(0).isFromLeader)
            return {*fault};
        for (const auto law : {placeSaid, stepSaid}) {
            if (auto fault = law(*this))
                return {*fault};
        }
        for (const auto law : {carriedSaid, waySaid}) {
            if (auto fault = law(*this))
                said.push_back(*fault);
            if (!said.empty() && !flight(0).isKnown)
                return said;
        }
        if (hasPull() || flight(0).isTurnLinear)
            judgeTurn(said);
        else
            said.push_back(oddTurn());
        if (said.empty()) {
            if (auto fault = leap())
                said.push_back(*fault);
            else if (auto first = firstStepSaid(*this))
                said.push_back(*first);
        }
        return said;
    }

    void judgeTurn(std::vector<FlightSaid> &said) const
    {
        const bool isWayRight = said.empty();
        // What the place does shows in all that is measured at one place, and who turns in every
        // step gets nowhere.
        if (const auto fault = pullSaid(*this)) {
            said.push_back(*fault);
            return;
        }
        if (const auto fault = turnsRoundSaid(*this)) {
            said.push_back(strongWaySaid(*this).value_or(*fault));
            return;
        }
        for (const auto law : {fallSaid, growthSaid}) {
            if (const auto fault = law(*this))
                said.push_back(*fault);
        }
        for (const auto law : {lossSaid, ownSceneSaid}) {
            const auto fault = said.empty() ? law(*this) : std::nullopt;
            if (fault)
                said.push_back(*fault);
        }
        // How much of the fall reaches the place can be told only where the rest is right.
        if (isWayRight && isAlike(flight(0).growth, right().growth, wrong)) {
            const auto drift = said.empty() ? driftSaid(*this) : std::nullopt;
            if (const auto fault = drift ? drift : methodSaid(*this, said.empty()))
                said.push_back(*fault);
        }
    }

    /// The same start must give the same step, whenever it comes in a run.
    [[nodiscard]] std::optional<FlightSaid> timeless() const
    {
        const Flight &f = flight(0);
        if (f.isTimeless || !right().isTimeless)
            return std::nullopt;
        const QString later = brief(static_cast<double>(flights::lateSteps) * timestep());
        // Who has another velocity goes another way.
        const bool isTurn = brief(f.lateVelocity) != brief(f.turnedInto);
        const bool isWay = !isTurn && brief(f.lateWay) != brief(f.wayMade);
        const QString headline =
            f.isCounted ? FlightText::tr("Not every step of %who is made alike")
                        : FlightText::tr("The step of %who depends on how long the run has lasted");
        const QString where =
            f.isCounted
                ? FlightText::tr("A step or two later it is as at the start again. Look at what "
                                 "your program counts, or keeps from one step to the next.")
                : FlightText::tr("How long a step lasts is the parameter of `on_update`; `time` is "
                                 "the time since the start, and `step` counts.");
        // Both go on alike and are not where they should be: the place itself hangs on the moment.
        if (!isWay && !isTurn)
            return said(
                headline,
                FlightText::tr("Started with %1 m/s, one step later it is %2 m from where "
                               "it was at the start of a run, and %3 m where it starts "
                               "alike %4 s later. A step *adds* a way to the old "
                               "position.")
                        .arg(brief(f.startedWith), brief(f.firstWay), brief(f.lateFirstWay), later)
                    + QLatin1Char(' ') + where,
                true);
        const QString seen =
            isWay
                ? FlightText::tr("Started with %1 m/s, it goes %2 m in the second step of a run "
                                 "and %3 m where it starts alike %4 s later, with the same Δt.")
                      .arg(brief(f.startedWith), brief(f.wayMade), brief(f.lateWay), later)
                : FlightText::tr("Started with %1 m/s, it has %2 m/s after the first step of a "
                                 "run and %3 m/s where it starts alike %4 s later.")
                      .arg(brief(f.startedWith), brief(f.turnedInto), brief(f.lateVelocity), later);
        return said(headline, seen + QLatin1Char(' ') + where, isWay);
    }

    /// What changes the velocity must do so in every step alike.
    [[nodiscard]] std::optional<FlightSaid> leap() const
    {
        const Flight &f = flight(0);
        if (!f.leap || right().leap)
            return std::nullopt;
        const Vec2 gets = f.leap->to - f.leap->from;
        const Vec2 fall = timestep() * right().acceleration;
        if (length(gets - fall) > wrong * length(fall) + 1e-9)
            return leapSaid(*f.leap);
        const auto next = std::find_if(f.seen.begin(), f.seen.end(), [&](const auto &step) {
            return length(step.velocity - f.leap->to) < 1e-9;
        });
        if (next == f.seen.end())
            return std::nullopt;
        return said(
            FlightText::tr("Only the first step changes the velocity of %who rightly"),
            FlightText::tr("Thrown with %1 m/s, it has %2 m/s one step of %3 s later, which is "
                           "right; in the next step that changes by %4 m/s, and gravity gives it "
                           "%5 m/s. Look at which velocity the line that changes it goes on from, "
                           "and at what your program keeps from one step to the next.")
                .arg(brief(f.leap->from), brief(f.leap->to), briefTimestep(timestep()),
                     briefBeside(next->turn, fall), briefBeside(fall, next->turn)),
            false);
    }

    /// Who is thrown goes on rightly, and who is let go at rest does not.
    [[nodiscard]] std::optional<FlightSaid> letGo() const
    {
        const Flight &f = flight(0);
        const auto isRight = [&](Vec2 from, Vec2 to) {
            const Motion next = right().after({.position = {}, .velocity = from}, timestep());
            return isAlike(to, next.velocity);
        };
        const Vec2 wanted = timestep() * right().acceleration;
        if (!right().isKnown || isAlike(f.fromRest.velocity, wanted)
            || length(f.firstWay - right().firstWay) > farInAStep
            || !isRight(f.startedWith, f.turnedInto)
            || !std::all_of(f.seen.begin(), f.seen.end(), [&](const Flight::Step &step) {
                   return isRight(step.velocity, step.velocity + step.turn);
               }))
            return std::nullopt;
        FlightSaid fault = said(
            length(f.fromRest.velocity) < 1e-9
                ? FlightText::tr("Gravity leaves %who at rest")
                : FlightText::tr("The velocity of %who changes far from everything"),
            FlightText::tr("Let go at rest, it has %1 m/s one step of %2 s later, far from every "
                           "wall and every other circle; gravity gives it %3 m/s in a step. Thrown "
                           "with %4 m/s it goes on as it should.")
                .arg(brief(f.fromRest.velocity), briefTimestep(timestep()), brief(wanted),
                     brief(f.startedWith)),
            false);
        for (PresetCircle &each : fault.moment.stage.preset.circles)
            each.body.velocity = {};
        fault.moment.step = 1;
        fault.suspect = Suspect::Question;
        return fault;
    }

    [[nodiscard]] FlightSaid leapSaid(const Flight::Leap &leap) const
    {
        FlightSaid fault = said(
            FlightText::tr("The velocity of %who changes far from everything"),
            FlightText::tr("Thrown with %1 m/s, it has %2 m/s one step of %3 s later, far from "
                           "every wall and every other circle; gravity gives it %4 m/s in a step. "
                           "Look at which lines change its velocity there, and at what is asked "
                           "before them.")
                    .arg(brief(leap.from), brief(leap.to), briefTimestep(timestep()),
                         brief(timestep() * right().acceleration))
                + othersGoOn(leap.speed),
            false);
        fault.moment = {flightStage(m_ground, gravity(), timestep(), leap.speed), 1, {m_i}, false};
        fault.moment.stage.preset.circles[static_cast<std::size_t>(m_i)].body.velocity = leap.from;
        return fault;
    }

    static QString othersGoOn(Flight::Speed speed)
    {
        switch (speed) {
        case Flight::Speed::Any:
            break;
        case Flight::Speed::Fast:
            return QLatin1Char(' ') + FlightText::tr("A slower one goes on as it should.");
        case Flight::Speed::Slow:
            return QLatin1Char(' ') + FlightText::tr("A faster one goes on as it should.");
        }
        return {};
    }

    /// A change of the velocity of which a condition is to blame.
    [[nodiscard]] FlightSaid conditional(const QString &headline, const QString &body) const
    {
        FlightSaid fault = said(headline, body, false);
        fault.suspect = Suspect::Question;
        return fault;
    }

    /// A change of the velocity that depends on it otherwise than by a share.
    [[nodiscard]] FlightSaid oddTurn() const
    {
        const Flight::Step &a = flight(0).seen[0];
        // Two that do the same tell less than one of them beside rest.
        const Flight::Step &b =
            brief(a.turn) == brief(flight(0).seen[1].turn) ? flight(0).fromRest : flight(0).seen[1];
        const auto asked = [&](Vec2 velocity) {
            return right().after({.position = {}, .velocity = velocity}, timestep()).velocity
                   - velocity;
        };
        const QString headline =
            FlightText::tr("The acceleration of %who depends wrongly on the velocity");
        // Two moments that look right show nothing of it; a step before them may.
        if (brief(a.turn) == brief(asked(a.velocity))
            && brief(b.turn) == brief(asked(b.velocity))) {
            const Flight &f = flight(0);
            const Vec2 wanted = f.startedWith + asked(f.startedWith);
            if (brief(f.turnedInto) != brief(wanted))
                return leapSaid({f.startedWith, f.turnedInto, Flight::Speed::Any});
            return conditional(
                headline,
                FlightText::tr("Look at what the lines that change the velocity take, and "
                               "at what is asked before them."));
        }
        return conditional(
            headline,
            FlightText::tr("Under gravity %1 m/s² and with the velocity %2 m/s it changes by %3 "
                           "m/s in a step of %4 s, with %5 m/s by %6 m/s; %7 and %8 m/s are "
                           "right. Look at what the lines that change the velocity take, and at "
                           "what is asked before them.")
                .arg(brief(gravity()), brief(a.velocity), brief(a.turn), briefTimestep(timestep()),
                     brief(b.velocity), brief(b.turn), brief(asked(a.velocity)),
                     brief(asked(b.velocity))));
    }
};

} // namespace

std::vector<FlightSaid> flightSaid(const FlightComparison &comparison)
{
    return FlightJudge(comparison).judge();
}

} // namespace cradle
