// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/unchanged_words.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace cradle {

namespace {

struct UnchangedText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

constexpr double longEnough = 20.0; ///< s

/// What was seen of one circle.
struct Seen {
    bool isSame = true; ///< its velocity
    bool wasAtWall = false;
    bool wasAtOther = false;

    [[nodiscard]] bool isTold() const { return isSame && wasAtWall && wasAtOther; }
};

void look(const World &world, const Preset &scene, std::vector<Seen> &all)
{
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Circle &c = world.circles[i];
        all[i].isSame &= c.velocity == scene.circles[i].body.velocity;
        const double reach = length(c.velocity) * scene.timestep;
        all[i].wasAtWall |= std::max(std::abs(c.position.x), std::abs(c.position.y))
                            > scene.halfWidth - c.radius - reach;
        for (std::size_t k = 0; k < all.size(); ++k) {
            const Circle &other = world.circles[k];
            all[i].wasAtOther |=
                k != i && length(other.position - c.position) < c.radius + other.radius;
        }
    }
}

constexpr double noWay = 1e-9; ///< what is nothing but rounding, m

bool isWayOf(Vec2 made, Vec2 wanted)
{
    return length(made - wanted) <= noWay;
}

/// What was seen of a circle that moves, in all directions or along one axis.
struct Course {
    bool isSame = true; ///< its velocity
    Vec2 forward{};   ///< way of a step: that of the velocity of the start or, of what rests there,
                      ///< its first one, m
    int forwards = 0; ///< steps
    int backwards = 0; ///< the last ones, after these

    /// \param way  of a step, m
    void take(Vec2 way)
    {
        if (forward == Vec2{} && length(way) > noWay)
            forward = way;
        if (forward == Vec2{})
            return;
        const double share = dot(way, forward) / lengthSquared(forward);
        forwards += share > 0.9;
        backwards = forwards > 0 && share < -0.1 ? backwards + 1 : 0;
    }
    /// \param rests  at the start: then a hit gives it a way of its own, not a push now and then
    [[nodiscard]] bool isTold(bool rests) const
    {
        constexpr int someSteps = 10; // what is put out of a wall goes back in one
        return isSame && backwards >= someSteps && (!rests || forwards >= someSteps);
    }
};

/// Of a vector (1, 1): all of it, its x, its y.
constexpr std::array<Vec2, 3> wholeAndParts{Vec2{1.0, 1.0}, Vec2{1.0, 0.0}, Vec2{0.0, 1.0}};

Vec2 partOf(Vec2 v, std::size_t part)
{
    return {wholeAndParts[part].x * v.x, wholeAndParts[part].y * v.y};
}

/// The courses of one circle: the whole one, that along x and that along y.
using Courses = std::array<Course, wholeAndParts.size()>;

Courses coursesFrom(Vec2 velocity, double timestep, bool mayBePushed)
{
    Courses all;
    for (std::size_t part = 0; part < wholeAndParts.size(); ++part) {
        const Vec2 v = partOf(velocity, part);
        // What rests is moved by a hit only.
        all[part] = {.isSame = v != Vec2{} || mayBePushed, .forward = timestep * v};
    }
    return all;
}

/// \param axis  whose part of the velocity alone is still that of the start; else all of it is
QString unwrittenText(int circle, const World &world, Vec2 way, double timestep,
                      const QString &axis)
{
    const Vec2 v = world.circles[static_cast<std::size_t>(circle)].velocity;
    const QString text =
        axis.isEmpty()
            ? UnchangedText::tr(
                "Circle %1 does not move as its velocity says\n\nAt %2 s of your own "
                "scene it moves by %3 m in a step of %4 s; its velocity is still "
                "the %5 m/s of the start. A program that keeps velocities in "
                "variables of its own must also assign them to the circles, as to "
                "`circle%1.velocity`.\n\nUntil this is right, no more can be said of "
                "walls and hits.")
            : UnchangedText::tr(
                "Circle %1 does not move as its velocity says\n\nAt %2 s of your own scene it "
                "moves by %3 m in a step of %4 s; its velocity is %5 m/s, of which the %6 is "
                "still that of the start. A program that keeps velocities in variables of its "
                "own must assign both parts of them to the circles, as to "
                "`circle%1.velocity`.\n\nUntil this is right, no more can be said of walls and "
                "hits.");
    return text.arg(circle + 1)
        .arg(brief(world.time), brief(way), briefTimestep(timestep), brief(v))
        .replace(QLatin1String("%6"), axis);
}

} // namespace

std::optional<LawDeviation> unwrittenVelocity(const QString *program, const Ground &ground,
                                              bool isFlightRight)
{
    const std::size_t most = isFlightRight ? wholeAndParts.size() : 1;
    Probe probe(program, {ground.own, false});
    if (!probe.runs())
        return std::nullopt;
    const Preset &scene = probe.start();
    std::vector<Courses> all;
    for (const auto &each : scene.circles)
        all.push_back(coursesFrom(each.body.velocity, scene.timestep, ground.pair.asked));
    const auto isAnySame = [&] {
        return std::any_of(all.begin(), all.end(), [](const Courses &of) {
            return std::any_of(of.begin(), of.end(), [](const Course &c) { return c.isSame; });
        });
    };
    while (probe.world().time < longEnough && isAnySame()) {
        const std::vector<Circle> before = probe.world().circles;
        if (!probe.step())
            return std::nullopt;
        const bool isFirst = probe.world().time < 1.5 * scene.timestep;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Circle &after = probe.world().circles[i];
            const Vec2 v = scene.circles[i].body.velocity;
            const Vec2 way = after.position - before[i].position;
            for (std::size_t part = 0; part < most; ++part) {
                Course &course = all[i][part];
                course.isSame &= partOf(after.velocity - v, part) == Vec2{};
                // What is moved by another part from the start is no velocity of its own.
                course.isSame &=
                    part == 0 || !isFirst || isWayOf(partOf(way, part), course.forward);
                course.take(partOf(way, part));
                if (!course.isTold(partOf(v, part) == Vec2{}))
                    continue;
                const int circle = static_cast<int>(i);
                const QString axis =
                    all[i].front().isSame ? QString() : QString(QChar(part == 1 ? u'x' : u'y'));
                return LawDeviation{
                    .aspect = Aspect::Motion,
                    .message = unwrittenText(circle, probe.world(), way, scene.timestep, axis),
                    .moment = {.stage = {ground.own, false},
                               .circles = {circle},
                               .isPosition = axis.isEmpty()}};
            }
        }
    }
    return std::nullopt;
}

std::optional<LawDeviation> unchangedVelocity(const QString *program, const Ground &ground)
{
    Probe probe(program, {ground.own, false});
    if (!probe.runs() || probe.start().gravity != Vec2{} || probe.start().circles.size() < 2)
        return std::nullopt;
    const Preset &scene = probe.start();
    std::vector<Seen> all(scene.circles.size());
    while (probe.world().time < longEnough && probe.step())
        look(probe.world(), scene, all);
    const auto told =
        std::find_if(all.begin(), all.end(), [](const Seen &s) { return s.isTold(); });
    if (!probe.runs() || told == all.end())
        return std::nullopt;
    const auto circle = static_cast<int>(told - all.begin());
    const Vec2 v = scene.circles[static_cast<std::size_t>(circle)].body.velocity;
    if (v == Vec2{})
        return std::nullopt;
    return LawDeviation{
        .aspect = Aspect::Walls,
        .message = UnchangedText::tr("Nothing changes the velocity of circle %1\n\nIn your own "
                                     "scene it has %2 m/s from the start to the end of %3 s, "
                                     "though it comes to a wall and to another circle. Both must "
                                     "give it a new velocity: look for where that is assigned.")
                       .arg(circle + 1)
                       .arg(brief(v), brief(longEnough)),
        .moment = {.stage = {ground.own, false}, .circles = {circle}},
        .suspect = Suspect::Omission};
}

} // namespace cradle
