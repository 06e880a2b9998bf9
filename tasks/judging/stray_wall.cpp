// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/stray_wall.h"

#include "tasks/judging/flight_scenes.h"

#include <algorithm>
#include <array>

namespace cradle {

namespace {

/// Throws a circle straight at a wall, from places on the way there.
class StrayRange
{
public:
    StrayRange(const QString *program, const Ground &ground, const Flight &right, Vec2 gravity,
               double h, int i)
        : m_program(program)
        , m_ground(ground)
        , m_right(right)
        , m_gravity(gravity)
        , m_h(h)
        , m_i(static_cast<std::size_t>(i))
    {
    }

    [[nodiscard]] std::optional<StrayWall> look(Wall wall) const
    {
        const Vec2 n = outwardNormal(wall);
        std::optional<StrayWall> found;
        double goesOn = -out; // how far out it is known to go on, m
        for (const double place : places) {
            const Throw to = thrown(n, place, speed);
            const bool isTurned = to.made && turns(to, n);
            // What is turned beside what goes on farther out is no wall; nor is who goes nowhere.
            if (!to.made || (!isTurned && (found || !goesRightly(to))))
                return std::nullopt;
            if (!isTurned)
                goesOn = place;
            else if (!found)
                found = StrayWall{.wall = wall,
                                  .from = place,
                                  .before = to.start,
                                  .after = to.is,
                                  .wanted = to.wanted,
                                  .stage = to.stage};
            // Where circles are turned it may ask for no direction.
            if (!isTurned && !goesRightly(thrown(n, place, -speed)))
                return std::nullopt;
        }
        if (!found)
            return std::nullopt;
        if (goesOn == -out) {
            found->from.reset();
            const bool goesBack = std::all_of(places.begin(), places.end(), [&](double place) {
                return goesRightly(thrown(n, place, -speed));
            });
            found->isOfStart = goesOnAfterTurn(n);
            return goesBack ? found : std::nullopt;
        }
        double inside = goesOn;
        double outside = *found->from;
        while (outside - inside > fine) {
            const double middle = 0.5 * (inside + outside);
            (turns(thrown(n, middle, speed), n) ? outside : inside) = middle;
        }
        found->from = dot(thrown(n, outside, speed).wanted.position, n);
        return found;
    }

private:
    static constexpr double speed = 1.3; ///< m/s
    static constexpr double out = 9.0;   ///< outside the square, m
    static constexpr double fine = 1e-6; ///< so well a limit is known, m
    static constexpr double room = 1.2;  ///< from other circles, m: more than any two radii
    /// Along the way, m from the middle, and aside from it. At the last no wall is near.
    static constexpr std::array places{-2.6, -1.7, -0.8, 0.3, 1.2, 2.1, 2.9};
    static constexpr std::array asides{-1.1, 0.7, 2.3, -2.4, 1.5, -0.2};

    struct Throw {
        bool made = false;
        Circle start{};
        Motion is{};
        Motion wanted{};
        Stage stage{};
    };

    /// Whether a circle that comes to the opposite wall, and is turned towards this one there, goes
    /// on so from there for some steps.
    [[nodiscard]] bool goesOnAfterTurn(Vec2 n) const
    {
        constexpr double gap = 0.03; // of its rim from that wall, m: gravity does not turn it there
        constexpr double fast = 0.3 * speed;
        constexpr int mostSteps = 20;
        constexpr int someSteps = 4;
        const double halfWidth = m_ground.stage().halfWidth;
        const double radius = m_ground.stage().circles[m_i].body.radius;
        const Throw to = thrown(n, radius + gap - halfWidth, -speed);
        if (!to.made)
            return false;
        Probe probe(m_program, to.stage);
        int steps = 0; // towards this wall
        for (int k = 0; k < mostSteps && steps < someSteps; ++k) {
            const double before = dot(probe.circle(static_cast<int>(m_i)).velocity, n);
            if (!probe.step())
                return false;
            const Circle &now = probe.circle(static_cast<int>(m_i));
            const bool isTowards = dot(now.velocity, n) > 0.0 && dot(now.position, n) < 0.0;
            if (steps > 0 ? !isTowards : isTowards && before > -fast)
                return false;
            steps += isTowards ? 1 : 0;
        }
        return steps >= someSteps;
    }

    [[nodiscard]] Throw thrown(Vec2 n, double place, double towards) const
    {
        Throw one{.stage = {flights::flightPreset(m_ground, m_gravity, m_h, flights::Scene::Rest)}};
        std::vector<PresetCircle> &all = one.stage.preset.circles;
        Circle &c = all[m_i].body;
        const auto isFree = [&](double aside) {
            const Vec2 at = place * n + aside * perpendicular(n);
            for (std::size_t j = 0; j < all.size(); ++j) {
                if (j != m_i && length(all[j].body.position - at) < room)
                    return false;
            }
            return true;
        };
        const auto aside = std::find_if(asides.begin(), asides.end(), isFree);
        if (aside == asides.end())
            return one;
        c.position = place * n + *aside * perpendicular(n);
        c.velocity = towards * n;
        one.start = c;
        Probe probe(m_program, one.stage);
        one.made = probe.step();
        const Circle &now = probe.circle(static_cast<int>(m_i));
        one.is = {now.position, now.velocity};
        one.wanted = m_right.after(one.start, m_h);
        return one;
    }

    /// Whether the part into the wall was turned round, and the other is as it should be.
    [[nodiscard]] bool turns(const Throw &one, Vec2 n) const
    {
        const Vec2 t = perpendicular(n);
        return dot(one.wanted.velocity, n) > 0.0 && dot(one.is.velocity, n) < -slack(one)
               && std::abs(dot(one.is.velocity - one.wanted.velocity, t)) < slack(one);
    }
    [[nodiscard]] bool goesRightly(const Throw &one) const
    {
        // By whichever method.
        const double ofMethods = 1.01 * length(m_gravity) * m_h * m_h;
        return one.made && length(one.is.velocity - one.wanted.velocity) < slack(one)
               && length(one.is.position - one.wanted.position) < 1e-6 + ofMethods;
    }
    static double slack(const Throw &one) { return 1e-6 * (1.0 + length(one.wanted.velocity)); }

    const QString *m_program;
    const Ground &m_ground;
    const Flight &m_right;
    Vec2 m_gravity;
    double m_h;
    std::size_t m_i;
};

} // namespace

std::optional<StrayWall> measureStrayWall(const QString *program, const Ground &ground,
                                          const Flight &right, Vec2 gravity, double h, int i)
{
    const std::vector<int> &asked = ground.walls.circles;
    if (std::find(asked.begin(), asked.end(), i) == asked.end())
        return std::nullopt;
    for (const Wall wall : allWalls) {
        if (auto found = StrayRange(program, ground, right, gravity, h, i).look(wall))
            return found;
    }
    return std::nullopt;
}

} // namespace cradle
