// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/floor_fall_words.h"

#include "tasks/judging/brief_beside.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

struct FloorText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

/// A step whose velocity has another share of gravity than a right one.
struct OddStep {
    int circle = 0;
    double thrown = 0.0;  ///< m/s
    qint64 step = 0;      ///< from 1
    qint64 hit = 0;       ///< that in which the floor turns it
    bool isTwice = false; ///< it has g Δt twice, and else not at all
    Vec2 was{};           ///< velocities, m/s
    Vec2 is{};
    Vec2 right{};
    Stage stage{};

    [[nodiscard]] bool isHit() const { return step == hit; }
};

/// The first gravity of the checks that points straight down, m/s²; zero if none does.
Vec2 fallOf(const Ground &ground)
{
    const auto down = std::find_if(ground.gravities.begin(), ground.gravities.end(),
                                   [](Vec2 g) { return g.x == 0.0 && g.y < 0.0; });
    return down == ground.gravities.end() ? Vec2{} : *down;
}

/// Throws circles at the floor and looks at every step.
class FloorThrows
{
public:
    FloorThrows(const QString *program, const Ground &ground, const MeasuredFlight &flight)
        : m_program(program)
        , m_ground(ground)
        , m_flight(flight)
    {
    }

    [[nodiscard]] std::optional<OddStep> of(int circle) const
    {
        for (const Throw &how : ways) {
            if (const auto odd = thrown(circle, how))
                return odd;
        }
        return std::nullopt;
    }

private:
    /// Their steps near the floor are of different lengths.
    struct Throw {
        double speed;  ///< down, m/s
        double height; ///< of the rim above the floor at the start, m
    };
    static constexpr Throw ways[] = {{2.9, 0.31},  {2.3, 0.31}, {1.3, 0.05},
                                     {0.9, 0.043}, {0.7, 0.02}, {0.62, 0.009}};
    static constexpr int longest = 60; ///< steps
    static constexpr int around = 3;   ///< of these, before the hit and behind it
    /// Slower ones a program may well keep at rest on the floor, m/s.
    static constexpr double resting = 0.56;
    static constexpr double slack = 0.02; ///< of g Δt: what no other share comes to

    [[nodiscard]] Stage stageOf(int circle, const Throw &how) const
    {
        Preset preset = m_ground.stage();
        preset.gravity = fallOf(m_ground);
        preset.restitution = *std::max_element(m_ground.walls.restitutions.begin(),
                                               m_ground.walls.restitutions.end());
        Circle &c = preset.circles[static_cast<std::size_t>(circle)].body;
        c.radius = m_ground.walls.radii.low;
        c.position = {0.43, how.height + c.radius - preset.halfWidth};
        c.velocity = {0.29, -how.speed};
        return {preset, true};
    }

    [[nodiscard]] std::optional<OddStep> thrown(int circle, const Throw &how) const
    {
        const Stage stage = stageOf(circle, how);
        const double h = stage.preset.timestep;
        const Flight &flight = m_flight.at(stage.preset.gravity, h, circle);
        const double fall = h * stage.preset.gravity.y;
        if (!flight.isKnown || std::abs(h * flight.acceleration.y - fall) > slack * std::abs(fall))
            return std::nullopt;
        Probe probe(m_program, stage);
        std::optional<OddStep> odd;
        int hit = 0;
        for (int k = 1; k <= longest && (hit == 0 || k <= hit + around); ++k) {
            const Circle before = probe.circle(circle);
            if (!probe.runs() || !probe.step())
                return std::nullopt;
            const Vec2 is = probe.circle(circle).velocity;
            const bool isHit = hit == 0 && before.velocity.y < 0.0 && is.y > 0.0;
            if (std::min(std::abs(before.velocity.y), std::abs(is.y)) < resting
                || (hit > 0 && is.y < 0.0))
                break;
            hit = isHit ? k : hit;
            OddStep step{circle, how.speed, k, 0, false, before.velocity, is, {}, stage};
            if (!odd && (isHit ? isOddHit(step, fall) : isOddStep(step, fall)))
                odd = step;
        }
        if (!odd || hit == 0 || odd->step + around < hit)
            return std::nullopt;
        odd->hit = hit;
        return odd;
    }

    static bool isShare(double share, double wanted) { return std::abs(share - wanted) < slack; }

    [[nodiscard]] static bool isOddStep(OddStep &step, double fall)
    {
        const double share = (step.is.y - step.was.y) / fall;
        step.right = step.was + Vec2{0.0, fall};
        step.isTwice = isShare(share, 2.0);
        return step.isTwice || isShare(share, 0.0);
    }

    /// What the floor makes of v: −e (v + a g Δt) + b g Δt. Where gravity acts once, in any share
    /// before the turn and after it, b − e a lies between −e and 1.
    [[nodiscard]] static bool isOddHit(OddStep &step, double fall)
    {
        const double e = step.stage.preset.restitution;
        const double left = (step.is.y + e * step.was.y) / fall; // b − e a
        const bool isAfter = isShare(left, 2.0);
        step.isTwice = isAfter || isShare(left, -2.0 * e);
        step.right = {step.was.x, isAfter ? fall - e * step.was.y : -e * (step.was.y + fall)};
        return step.isTwice;
    }

    const QString *m_program;
    const Ground &m_ground;
    const MeasuredFlight &m_flight;
};

QString wordsOf(const OddStep &odd)
{
    const QString headline =
        odd.isTwice ? FloorText::tr("Gravity acts twice in a step of %who at the floor")
                    : FloorText::tr("Gravity leaves out steps of %who at the floor");
    const QString seen =
        odd.isHit()
            ? FloorText::tr("Thrown down with %1 m/s, circle %2 was turned by the floor in step "
                            "%3. In that step its velocity went from %4 to %5 m/s; %6 m/s is "
                            "right: turned round, and with g Δt once. Gravity acts once in every "
                            "step, also where a circle touches the floor.")
            : FloorText::tr("Thrown down with %1 m/s, circle %2 was turned by the floor in step "
                            "%3. In step %7 its velocity went from %4 to %5 m/s; %6 m/s is right. "
                            "Gravity acts once in every step, also where a circle touches the "
                            "floor.");
    const QString told =
        seen.arg(brief(odd.thrown))
            .arg(odd.circle + 1)
            .arg(odd.hit)
            .arg(brief(odd.was), briefBeside(odd.is, odd.right), briefBeside(odd.right, odd.is));
    return headline + QStringLiteral("\n\n") + (odd.isHit() ? told : told.arg(odd.step));
}

} // namespace

std::optional<LawDeviation> fallAtFloor(const QString *program, const Ground &ground,
                                        const MeasuredFlight &flight)
{
    if (fallOf(ground) == Vec2{})
        return std::nullopt;
    std::optional<OddStep> shown;
    std::vector<int> circles;
    for (const int circle : ground.walls.circles) {
        const auto odd = FloorThrows(program, ground, flight).of(circle);
        if (!odd || (shown && (odd->isTwice != shown->isTwice || odd->isHit() != shown->isHit())))
            continue;
        circles.push_back(circle);
        shown = shown ? shown : odd;
    }
    if (!shown)
        return std::nullopt;
    QString message = wordsOf(*shown);
    message.replace(QLatin1String("%who"), circleNames(circles, ground.flights.size()));
    return LawDeviation{.aspect = Aspect::Walls,
                        .message = message,
                        .moment = {shown->stage, shown->step, {shown->circle}, false},
                        .suspect = shown->isHit() ? Suspect::Answer : Suspect::Question};
}

} // namespace cradle
