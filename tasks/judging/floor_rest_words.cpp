// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/floor_rest_words.h"

#include "tasks/judging/measured_wall.h"
#include "tasks/judging/probe.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

struct RestText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

constexpr double slidingFrom = 0.02; ///< m, of the rim above the floor
constexpr double sliding = 0.41;     ///< m/s, along the floor
constexpr double smallest = 1e-3;    ///< change of that in a step, of it
constexpr double leastInAll = 0.02;  ///< and in all of them
constexpr double hangingFrom = 0.1;  ///< m
constexpr int watched = 180;         ///< steps
constexpr int stillSteps = 10;       ///< no bounce has so long a top
constexpr double offFloor = 5e-3;    ///< m: lower it rests on the floor

Vec2 downOf(const Ground &ground)
{
    const auto down = std::find_if(ground.gravities.begin(), ground.gravities.end(),
                                   [](Vec2 g) { return g.x == 0.0 && g.y < 0.0; });
    return down == ground.gravities.end() ? Vec2{} : *down;
}

Stage letGo(const Ground &ground, int circle, double height, double along)
{
    Preset preset = ground.stage();
    preset.gravity = downOf(ground);
    preset.restitution = middleOf(ground.walls.restitutions);
    Circle &c = preset.circles[static_cast<std::size_t>(circle)].body;
    c.radius = ground.walls.radii.low;
    c.position = {-0.43, height + c.radius - preset.halfWidth};
    c.velocity = {along, 0.0};
    return {preset, true};
}

struct Slid {
    qint64 step = 0;   ///< the first that changed the part along the floor; 0: none
    double left = 0.0; ///< of it, m/s
    double time = 0.0; ///< s
};

Slid slide(const QString &program, const Stage &stage, int circle)
{
    Slid slid{.left = sliding};
    Probe probe(&program, stage);
    for (int k = 1; k <= watched && probe.runs() && probe.step(); ++k) {
        slid.left = probe.circle(circle).velocity.x;
        slid.time = probe.world().time;
        if (slid.step == 0 && std::abs(slid.left - sliding) > smallest * sliding)
            slid.step = k;
    }
    // What makes so little of so long a time is none of the floor's doing.
    return std::abs(slid.left - sliding) > leastInAll * sliding ? slid : Slid{};
}

struct Hung {
    qint64 step = 0;   ///< the first that left it where it was; 0: none
    double gap = 0.0;  ///< of the rim from the floor, m
    double time = 0.0; ///< s
};

/// Where it stays above the floor for long.
Hung hang(const QString &program, const Stage &stage, int circle)
{
    Hung hung;
    int still = 0;
    Probe probe(&program, stage);
    for (int k = 1; k <= watched && probe.runs(); ++k) {
        const Vec2 before = probe.circle(circle).position;
        if (!probe.step())
            break;
        const Circle &now = probe.circle(circle);
        const double gap = now.position.y - now.radius + stage.preset.halfWidth;
        if (length(now.position - before) > 1e-9 || gap < offFloor) {
            still = 0;
            continue;
        }
        if (++still == 1)
            hung = {k, gap, probe.world().time};
        if (still == stillSteps)
            return hung;
    }
    return {};
}

/// One of the two things, and the circles that do it.
struct Resting {
    QString headline{};
    QString body{};
    Moment moment{};

    void include(int circle, const QString &line, const QString &seen, const Stage &stage,
                 qint64 step)
    {
        if (moment.circles.empty()) {
            headline = line;
            body = seen;
            moment = {.stage = stage, .step = step};
        }
        moment.circles.push_back(circle);
    }
};

} // namespace

std::optional<LawDeviation> restAtFloor(const QString &program, const QString &right,
                                        const Ground &ground)
{
    if (downOf(ground) == Vec2{})
        return std::nullopt;
    Resting rubs;
    Resting hangs;
    for (const int circle : ground.walls.circles) {
        const Stage slides = letGo(ground, circle, slidingFrom, sliding);
        const Slid slid = slide(program, slides, circle);
        if (slid.step > 0 && slide(right, slides, circle).step == 0)
            rubs.include(
                circle, RestText::tr("On the floor the speed of %who along it changes"),
                RestText::tr("Circle %1 was let go %2 m above the floor with %3 m/s along it, and "
                             "had %4 m/s along it %5 s later; %3 m/s is right. Where nothing "
                             "rubs, a push points along the normal only: look at what slow hits "
                             "at the floor change.")
                    .arg(QString::number(circle + 1), brief(slidingFrom), brief(sliding),
                         brief(slid.left), brief(slid.time)),
                slides, slid.step);
        const Stage falls = letGo(ground, circle, hangingFrom, 0.0);
        const Hung hung = hang(program, falls, circle);
        if (hung.step > 0 && hang(right, falls, circle).step == 0)
            hangs.include(
                circle, RestText::tr("Above the floor gravity stops moving %who"),
                RestText::tr("Circle %1 was let go at rest %2 m above the floor, and from %3 s on "
                             "it stood still %4 m above it, where nothing holds it. Look at what "
                             "keeps a circle still, and at whether it lies on the floor then.")
                    .arg(QString::number(circle + 1), brief(hangingFrom), brief(hung.time),
                         brief(hung.gap)),
                falls, hung.step);
    }
    const Resting &said = rubs.moment.circles.empty() ? hangs : rubs;
    if (said.moment.circles.empty())
        return std::nullopt;
    QString message = said.headline + QStringLiteral("\n\n") + said.body;
    message.replace(QLatin1String("%who"), circleNames(said.moment.circles, ground.flights.size()));
    return LawDeviation{.aspect = Aspect::Walls,
                        .message = message,
                        .moment = said.moment,
                        .suspect = Suspect::Answer};
}

} // namespace cradle
