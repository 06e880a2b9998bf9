// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/proof/sensitivity.h"

#include "tasks/checks/check_library.h"
#include "tasks/proof/hit_answer.h"
#include "tasks/runs/observation.h"

#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cradle {

namespace {

constexpr std::size_t mostScenes = 3; ///< of a check: the others are drawn alike
constexpr double leastShare = 1e-13;  ///< of the most that is tried
constexpr double exactness = 1.1;     ///< of the answer, as a factor
constexpr double hitShare = 1e-3;     ///< of a speed: a larger change in a step is a hit
constexpr double mostTurn = 45.0;     ///< °
constexpr double mostSpeed = 0.5;
constexpr double mostDrift = 1.0; ///< m/s
constexpr double mostRestitution = 1.0;
constexpr double mostExponent = 3.0;

/// A way to be wrong: by how much of it.
enum class Bend { Turn, Speed, Drift, Restitution, MassExponent };

/// The first state after a hit of the circle: bent from there, its run is wrong in that hit and
/// right again after it. 0 if it never was hit: then it is wrong in its first step.
qint64 firstHit(const Observation &run, int circle)
{
    const Vec2 fall = run.variant.preset.gravity * run.timestep();
    for (qint64 k = 0; k < run.steps(); ++k) {
        const Vec2 before = run.circle(circle, k).velocity;
        const Vec2 change = run.circle(circle, k + 1).velocity - before;
        if (length(change) > hitShare * (1.0 + length(before)) + 2.0 * length(fall))
            return k + 1;
    }
    return 0;
}

Vec2 turned(Vec2 v, double degrees)
{
    const double angle = degrees * std::numbers::pi / 180.0;
    return {std::cos(angle) * v.x - std::sin(angle) * v.y,
            std::sin(angle) * v.x + std::cos(angle) * v.y};
}

/// \p run with the way of one circle bent from the state \p from on.
Observation bent(const Observation &run, int circle, qint64 from, Bend bend, double amount)
{
    Observation wrong;
    wrong.variant = run.variant;
    wrong.fields = run.fields;
    wrong.instructions = run.instructions;
    const Vec2 pivot = run.circle(circle, from).position;
    for (qint64 k = run.states.first(); k <= run.steps(); ++k) {
        World world = run.states.world(k);
        Circle &body = world.circles[static_cast<std::size_t>(circle)];
        const double seconds = static_cast<double>(k - from) * run.timestep();
        const bool velocityBent = k > from || (k == from && from > 0);
        if (velocityBent && bend == Bend::Turn) {
            body.velocity = turned(body.velocity, amount);
            body.position = pivot + turned(body.position - pivot, amount);
        } else if (velocityBent && bend == Bend::Speed) {
            body.velocity = (1.0 + amount) * body.velocity;
            body.position = pivot + (1.0 + amount) * (body.position - pivot);
        } else if (k > from) {
            body.position = body.position + Vec2{amount * seconds, amount * seconds};
        }
        wrong.states.append(world);
    }
    return wrong;
}

/// \p run with what its first hit answers shifted.
Observation answered(const Observation &run, const HitAnswer &answer, Bend bend, double amount)
{
    Observation wrong;
    wrong.variant = run.variant;
    wrong.fields = run.fields;
    wrong.instructions = run.instructions;
    const auto shifts =
        answer.shifts(run.states.circleCount(), bend == Bend::Restitution ? amount : 0.0,
                      bend == Bend::MassExponent ? amount : 0.0);
    for (qint64 k = run.states.first(); k <= run.steps(); ++k) {
        World world = run.states.world(k);
        const double seconds = static_cast<double>(k - answer.after) * run.timestep();
        for (std::size_t i = 0; k >= answer.after && i < shifts.size(); ++i) {
            world.circles[i].velocity += shifts[i];
            world.circles[i].position += seconds * shifts[i];
        }
        wrong.states.append(world);
    }
    return wrong;
}

/// One scene of the check with the right run.
struct RightRun {
    Observation run;
    int circle = 0;
    qint64 from = 0;
    std::optional<HitAnswer> answer{};
};

std::optional<Observation> wrongRun(const RightRun &right, Bend bend, double amount)
{
    if (bend != Bend::Restitution && bend != Bend::MassExponent)
        return bent(right.run, right.circle, right.from, bend, amount);
    if (!right.answer || (bend == Bend::MassExponent && right.answer->b < 0))
        return std::nullopt;
    return answered(right.run, *right.answer, bend, amount);
}

bool notices(const CheckSpec &check, const std::vector<RightRun> &runs, Bend bend, double amount)
{
    return std::any_of(runs.begin(), runs.end(), [&](const RightRun &right) {
        const auto wrong = wrongRun(right, bend, amount);
        return wrong && judge(check, *wrong).has_value();
    });
}

/// The least amount that is noticed; found by halving the logarithm.
std::optional<double> leastNoticed(const CheckSpec &check, const std::vector<RightRun> &runs,
                                   Bend bend, double most)
{
    if (!notices(check, runs, bend, most))
        return std::nullopt;
    double passes = most * leastShare;
    double fails = most;
    while (fails > exactness * passes) {
        const double middle = std::sqrt(passes * fails);
        (notices(check, runs, bend, middle) ? fails : passes) = middle;
    }
    return fails;
}

} // namespace

std::optional<Sensitivity> sensitivityOf(const Task &task, const CheckSpec &check,
                                         const std::function<bool()> &stop)
{
    if (task.solution.isEmpty() || check.circles.empty())
        return std::nullopt;
    std::vector<RightRun> runs;
    for (const Variant &variant : makeVariants(task.preset, check, 1)) {
        if (runs.size() == mostScenes || stop())
            break;
        RightRun right{observe(variant, &task.solution, stop), check.circles.front(), 0};
        if (right.run.error || right.circle >= right.run.circleCount() || judge(check, right.run))
            return std::nullopt;
        right.from = firstHit(right.run, right.circle);
        right.answer = answerIn(check, right.run, right.from);
        runs.push_back(std::move(right));
    }
    if (runs.empty() || stop())
        return std::nullopt;
    return Sensitivity{.turn = leastNoticed(check, runs, Bend::Turn, mostTurn),
                       .speed = leastNoticed(check, runs, Bend::Speed, mostSpeed),
                       .drift = leastNoticed(check, runs, Bend::Drift, mostDrift),
                       .restitution = leastNoticed(check, runs, Bend::Restitution, mostRestitution),
                       .massExponent = leastNoticed(check, runs, Bend::MassExponent, mostExponent)};
}

QString describe(const Sensitivity &sensitivity)
{
    const auto figure = [](const std::optional<double> &value, double factor, const char *unit) {
        static const QRegularExpression zeros(QStringLiteral("e([+-])0"));
        return value
                   ? QString::number(*value * factor, 'g', 2).replace(zeros, QStringLiteral("e\\1"))
                         + QString::fromUtf8(unit)
                   : QStringLiteral("–");
    };
    QStringList figures{figure(sensitivity.turn, 1.0, "°"), figure(sensitivity.speed, 100.0, " %"),
                        figure(sensitivity.drift, 1000.0, " mm/s")};
    if (sensitivity.restitution)
        figures.append(QStringLiteral("e ± ") + figure(sensitivity.restitution, 1.0, ""));
    if (sensitivity.massExponent)
        figures.append(QStringLiteral("r^(3 ± %1)").arg(figure(sensitivity.massExponent, 1.0, "")));
    return figures.join(QStringLiteral(" · "));
}

} // namespace cradle
