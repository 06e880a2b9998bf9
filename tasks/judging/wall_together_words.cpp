// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_together_words.h"

#include "tasks/checks/figures.h"
#include "tasks/judging/wall_comparison.h"

#include <algorithm>

namespace cradle {

namespace {

constexpr int lastStep = 5;       ///< of a throw
constexpr double stepsAway = 2.5; ///< so far from its wall a rim starts
constexpr double beside = 1.3;    ///< of the middle of a wall, m: nothing else is near

/// Throws circles 1 and 2 at two walls, which may be one.
class Pairwise
{
public:
    Pairwise(const Ground &ground, Wall first, Wall second)
        : m_walls{first, second}
        , m_stage{ground.stage(), true}
    {
        Preset &preset = m_stage.preset;
        preset.gravity = ground.walls.gravity;
        preset.restitution = ground.walls.restitutions.back();
        for (const int i : {0, 1}) {
            Circle &c = preset.circles[static_cast<std::size_t>(i)].body;
            const Vec2 n = outwardNormal(m_walls[i]);
            // On both sides of the middle, also of two walls that meet in a corner.
            const Vec2 side = (i == 0 ? -beside : beside) * perpendicular(n);
            c.radius = ground.walls.radii.low;
            c.velocity = speed * n;
            c.position =
                (preset.halfWidth - c.radius - stepsAway * speed * preset.timestep) * n + side;
        }
    }

    /// The step in which each of the two is turned; 0: in none, or the program stops.
    [[nodiscard]] std::array<int, 2> turns(const QString &program) const
    {
        return turnsIn(program, m_stage);
    }

    /// The same of circle \p i, while the other is in the middle.
    [[nodiscard]] int turnAlone(const QString &program, int i) const
    {
        Stage alone = m_stage;
        Circle &other = alone.preset.circles[static_cast<std::size_t>(1 - i)].body;
        other.position = {};
        other.velocity = {0.3, 0.2};
        return turnsIn(program, alone)[static_cast<std::size_t>(i)];
    }

    [[nodiscard]] const Stage &stage() const { return m_stage; }
    [[nodiscard]] Wall wallOf(int i) const { return m_walls[i]; }

private:
    static constexpr double speed = 6.3; ///< m/s

    [[nodiscard]] std::array<int, 2> turnsIn(const QString &program, const Stage &stage) const
    {
        std::array<int, 2> turned{};
        Probe probe(&program, stage);
        for (int k = 1; k <= lastStep && probe.runs() && probe.step(); ++k) {
            for (const int i : {0, 1}) {
                int &at = turned[static_cast<std::size_t>(i)];
                if (at == 0 && dot(outwardNormal(m_walls[i]), probe.circle(i).velocity) < 0.0)
                    at = k;
            }
        }
        return turned;
    }

    Wall m_walls[2];
    Stage m_stage;
};

LawDeviation together(const Pairwise &both, int lost, int step)
{
    const auto came = [&](int i) {
        return brief(both.stage().preset.circles[static_cast<std::size_t>(i)].body.velocity);
    };
    const QString headline =
        WallText::tr("In a step in which circle %1 hits a wall, circle %2 hits none")
            .arg(2 - lost)
            .arg(lost + 1);
    const QString body =
        WallText::tr("Thrown with %1 m/s, circle %2 came to the %3, and circle %5 with %4 m/s to "
                     "the %6 in the same step: circle %2 was turned in it, and circle %5 was not. "
                     "Alone it is. Look at what your program leaves out when the other circle is "
                     "hit.")
            .arg(came(1 - lost), QString::number(2 - lost), motion::wallName(both.wallOf(1 - lost)),
                 came(lost), QString::number(lost + 1), motion::wallName(both.wallOf(lost)));
    return {.aspect = Aspect::Walls,
            .message = headline + QStringLiteral("\n\n") + body,
            .moment = {both.stage(), step, {lost}, false},
            .suspect = Suspect::Question};
}

} // namespace

std::optional<LawDeviation> wallsTogether(const QString &program, const QString &right,
                                          const Ground &ground)
{
    const auto &circles = ground.walls.circles;
    if (std::find(circles.begin(), circles.end(), 0) == circles.end()
        || std::find(circles.begin(), circles.end(), 1) == circles.end())
        return std::nullopt;
    for (const Wall first : allWalls) {
        for (const Wall second : allWalls) {
            const Pairwise both(ground, first, second);
            const std::array<int, 2> own = both.turns(program);
            const auto least = std::max(own[0], own[1]);
            if (own[0] == own[1]
                || (own[0] != 0 && own[1] != 0 && least - std::min(own[0], own[1]) > 1))
                continue;
            const int lost = own[0] == 0 || (own[1] != 0 && own[0] > own[1]) ? 0 : 1;
            const int step = own[static_cast<std::size_t>(1 - lost)];
            const std::array<int, 2> good = both.turns(right);
            if (good[0] == good[1] && good[0] != 0 && both.turnAlone(program, lost) == step)
                return together(both, lost, step);
        }
    }
    return std::nullopt;
}

} // namespace cradle
