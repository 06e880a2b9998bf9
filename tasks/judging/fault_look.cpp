// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/fault_look.h"

#include "tasks/judging/likeness.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Steps after the moment, in which an answer that comes a step later has come.
constexpr qint64 answerLate = 2;
/// Of velocities: a step earlier or later gravity has changed a little.
constexpr double alikeSpeeds = 0.03;
/// Steps before the moment, in which what a program keeps from one step to the next has settled.
constexpr qint64 settling = 3;

/// What is right in one scene by chance is wrong with a velocity that is so many times as large.
constexpr double fasterAlongX = 1.05;
constexpr double slowerAlongY = 0.96;

/// Steps by which what comes at \p step comes later with that velocity along y.
qint64 laterAt(qint64 step)
{
    return static_cast<qint64>(std::ceil(static_cast<double>(step) * (1.0 / slowerAlongY - 1.0)));
}

/// The states of a program step by step, the first before any step; they end where it stops.
std::vector<World> statesOf(const QString &program, const Stage &stage, qint64 steps)
{
    Probe probe(&program, stage);
    std::vector<World> states;
    if (!probe.runs())
        return states;
    states.push_back(probe.world());
    while (static_cast<qint64>(states.size()) <= steps && probe.step())
        states.push_back(probe.world());
    return states;
}

/// The circles after so many steps, also of a program that begins in the midst, at \p start;
/// nothing if it stops.
std::vector<Circle> after(const QString &program, const Stage &stage, qint64 steps,
                          const World *start = nullptr)
{
    Probe probe(&program, stage, true);
    if (start)
        probe.place(*start);
    for (qint64 k = start ? start->step : 0; k < steps; ++k) {
        if (!probe.step())
            return {};
    }
    return probe.runs() ? probe.world().circles : std::vector<Circle>{};
}

} // namespace

FaultLook::FaultLook(const QString &program, const QString &reference, const Moment &moment,
                     bool isHit, bool isQuestion, bool isAnyMethod)
    : m_program(program)
    , m_reference(reference)
    , m_moment(moment)
    , m_isHit(isHit)
    , m_isQuestion(isQuestion)
    , m_isAnyMethod(isAnyMethod && !isHit)
{
    const qint64 steps = moment.step + (moment.isPosition ? 0 : answerLate);
    for (auto *scene : {&m_first, &m_second}) {
        // One step more: two changes of sign make none. A hit comes later along y, by as much as it
        // is slower there.
        *scene = scene == &m_first
                     ? sceneOf(moment.stage, steps)
                     : sceneOf(otherStage(), isHit ? steps + laterAt(moment.step) : steps + 1);
        if (*scene && !isTold(**scene))
            scene->reset();
    }
}

bool FaultLook::isTold(Scene &scene) const
{
    constexpr double least = 1e-3; // more than the line of centres turns in a very short step
    constexpr double clear = 0.3;  // of what is wrong
    if (!isRightIn(scene, m_program))
        return true;
    const double off = offOf(scene.whole);
    if (!m_isHit || m_isQuestion || scene.stage.preset.gravity != Vec2{} || off < least)
        return false;
    scene.near = clear * off;
    return !isRightIn(scene, m_program);
}

double FaultLook::offOf(const Ends &ends) const
{
    double most = 0.0;
    for (const int circle : m_moment.circles) {
        const auto i = static_cast<std::size_t>(circle);
        if (i >= ends.wanted.size() || i >= ends.was.size())
            continue;
        const Vec2 off = ends.was[i].velocity - ends.wanted[i].velocity;
        most = std::max(most, length(off) / (1.0 + length(ends.wanted[i].velocity)));
    }
    return most;
}

bool FaultLook::showsFault()
{
    return m_first || m_second;
}

Sight FaultLook::of(const QString &program)
{
    auto seen = m_seen.find(program);
    if (seen == m_seen.end())
        seen = m_seen.insert(program, sightOf(program));
    return *seen;
}

/// Other velocities and another mass.
Stage FaultLook::otherStage() const
{
    Stage stage = m_moment.stage;
    double k = 1.0;
    for (PresetCircle &circle : stage.preset.circles) {
        Vec2 &v = circle.body.velocity;
        v = {fasterAlongX * v.x, slowerAlongY * v.y};
        if (!m_isHit)
            v = v + Vec2{0.37 * k, 0.23};
        if (m_isHit && !m_isQuestion && k < 0.0)
            circle.body.density *= 1.3;
        k *= -0.97;
    }
    return stage;
}

double FaultLook::slackIn(const Stage &stage) const
{
    const double h = stage.preset.timestep;
    const double fallen = length(stage.preset.gravity) * h * h;
    if (m_moment.isPosition && !m_isHit)
        return 1e-7 + (m_isAnyMethod ? 0.1 : 0.4) * fallen;
    if (!m_isQuestion)
        return 0.2;
    // Who answers a step too early or too late is a step away from there.
    double speed = 0.5;
    for (const PresetCircle &circle : stage.preset.circles)
        speed = std::max(speed, length(circle.body.velocity));
    return 3.0 * h * speed;
}

std::optional<FaultLook::Scene> FaultLook::sceneOf(const Stage &stage, qint64 steps) const
{
    const std::vector<World> right = statesOf(m_reference, stage, steps);
    const std::vector<World> theirs = statesOf(m_program, stage, steps);
    const auto isWhole = [&](const std::vector<World> &states) {
        return static_cast<qint64>(states.size()) == steps + 1;
    };
    Scene scene{.stage = stage, .steps = steps, .slack = slackIn(stage), .near = alikeSpeeds};
    if (!isWhole(right) || !isWhole(theirs))
        return scene;
    scene.whole = {right.back().circles, theirs.back().circles};
    const qint64 start = m_moment.step - 1 - settling;
    if (start <= settling)
        return scene;
    // Who begins in the midst of his own run and goes on as he did keeps nothing to himself.
    const auto goesOn = [&](const QString &program, const std::vector<World> &states) {
        return after(program, stage, steps, &states[static_cast<std::size_t>(start)])
               == states.back().circles;
    };
    if (goesOn(m_reference, right) && goesOn(m_program, theirs)) {
        scene.start = right[static_cast<std::size_t>(start)];
        scene.late = {scene.whole.wanted, after(m_program, stage, steps, &*scene.start)};
        // Walls that are right put circles back in several ways, which adds up on a long way.
        const std::vector<Circle> &there = scene.start->circles;
        const Ends same{there, there};
        scene.isWhole =
            isNear(theirs[static_cast<std::size_t>(start)].circles, same, 1.0, scene, start)
            || isNear(scene.late.was, scene.late, 2.0, scene, steps - start);
    }
    return scene;
}

Sight FaultLook::sightOf(const QString &program) const
{
    if (m_first && !isRightIn(*m_first, program))
        return Sight::Wrong;
    if (m_second && !isRightIn(*m_second, program))
        return m_first ? Sight::Once : Sight::Wrong;
    return Sight::Twice;
}

bool FaultLook::isRightIn(const Scene &scene, const QString &program) const
{
    // Who does the same all the way does it from the midst of the way, which is soon seen.
    return (!scene.start
            || isNear(after(program, scene.stage, scene.steps, &*scene.start), scene.late, 2.0,
                      scene, scene.steps - scene.start->step))
           && (!scene.isWhole
               || isNear(after(program, scene.stage, scene.steps), scene.whole, 1.0, scene,
                         scene.steps));
}

bool FaultLook::isNear(const std::vector<Circle> &made, const Ends &ends, double tolerance,
                       const Scene &scene, qint64 steps) const
{
    // Between one integrator and the next lies half of g Δt² a step.
    const double h = scene.stage.preset.timestep;
    const Vec2 half = 0.5 * h * h * static_cast<double>(steps) * scene.stage.preset.gravity;
    if (made.empty() || made.size() != ends.wanted.size() || made.size() != ends.was.size())
        return false;
    const auto isLike = [&](const Circle &a, const Circle &b, Vec2 off = {}) {
        return isAlike(a.velocity, b.velocity, tolerance * scene.near)
               && length(a.position - b.position - off) < tolerance * scene.slack;
    };
    const auto isRight = [&](const Circle &a, const Circle &b) {
        const auto isOff = [&](double times) { return isLike(a, b, times * half); };
        static constexpr double others[] = {-2.0, -1.0, 1.0, 2.0};
        return isLike(a, b)
               || (m_isAnyMethod && std::any_of(std::begin(others), std::end(others), isOff));
    };
    for (std::size_t i = 0; i < made.size(); ++i) {
        const auto &wrong = m_moment.circles;
        const bool isWrong =
            std::find(wrong.begin(), wrong.end(), static_cast<int>(i)) != wrong.end();
        if (!isRight(made[i], ends.wanted[i]) && (isWrong || !isLike(made[i], ends.was[i])))
            return false;
    }
    return true;
}

} // namespace cradle
