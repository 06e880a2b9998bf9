// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_words.h"

#include "tasks/judging/likeness.h"

#include <QCoreApplication>

#include <functional>
#include <map>

namespace cradle {

namespace {

struct FlightText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

using Kind = TimestepPattern::Kind;

constexpr double wrong = 1e-4; ///< relative: what is more is another law, not another rounding

/// What is said of one circle; the same of several is said once, with \p names in place of %who.
struct Said {
    QString headline;
    QString body;
    Moment moment{};
    bool isMethod = false; ///< it is about the integrator
};

/// Judges the flight of one circle.
class FlightJudge
{
public:
    FlightJudge(const MeasuredFlight &own, const MeasuredFlight &right, const Ground &ground,
                int circle)
        : m_own(own)
        , m_right(right)
        , m_ground(ground)
        , m_i(circle)
    {
    }

    /// What is wrong, worst first; what hides the rest stands alone.
    [[nodiscard]] std::vector<Said> judge() const
    {
        std::vector<Said> said;
        for (const auto law : {&FlightJudge::carriedOn, &FlightJudge::way}) {
            if (auto fault = (this->*law)())
                said.push_back(*fault);
            if (!said.empty() && !flight(0).isKnown)
                return said;
        }
        const bool isWayRight = said.empty();
        for (const auto law : {&FlightJudge::fall, &FlightJudge::growth}) {
            if (auto fault = (this->*law)())
                said.push_back(*fault);
        }
        // How much of the fall reaches the place can be told only where the rest is right.
        if (isWayRight && isAlike(flight(0).growth, right().growth, wrong)) {
            if (auto fault = method(said.empty()))
                said.push_back(*fault);
        }
        return said;
    }

private:
    [[nodiscard]] Vec2 gravity() const { return m_ground.gravities.front(); }
    [[nodiscard]] double timestep() const { return m_ground.timesteps.front(); }
    [[nodiscard]] const Flight &flight(std::size_t h) const
    {
        return m_own.at(gravity(), m_ground.timesteps[h], m_i);
    }
    /// Of the reference, under the same conditions as flight(0).
    [[nodiscard]] const Flight &right() const { return m_right.at(gravity(), timestep(), m_i); }
    /// How far a growth of the velocity that nobody asked for shows in a step, relative.
    [[nodiscard]] double growthBlur(std::size_t h) const
    {
        const Vec2 off =
            flight(h).growth - m_right.at(gravity(), m_ground.timesteps[h], m_i).growth;
        return 1.1 * std::max(std::abs(off.x), std::abs(off.y)) * m_ground.timesteps[h];
    }
    [[nodiscard]] Moment moment(bool isPosition, Vec2 g) const
    {
        return {flightStage(m_ground, g, timestep()), 2, {m_i}, isPosition};
    }
    [[nodiscard]] Said said(const QString &headline, const QString &body, bool isPosition) const
    {
        return {headline, body, moment(isPosition, gravity())};
    }

    /// Velocity and place must follow from those before, and from the circle's own.
    [[nodiscard]] std::optional<Said> carriedOn() const
    {
        const Flight &f = flight(0);
        if (f.resets && !m_right.at(gravity(), timestep(), m_i).resets)
            return said(FlightText::tr("The velocity of %who is set anew in every step"),
                        FlightText::tr("Started with %1 m/s, it has %2 m/s one step later, and so "
                                       "it has from every other start: what a hit changes is lost "
                                       "at once. A start is set once, in `on_load`; a step works "
                                       "the new velocity out from the old one.")
                            .arg(brief(f.startedWith), brief(f.turnedInto)),
                        false);
        if (f.leader >= 0 && m_right.at(gravity(), timestep(), m_i).leader < 0)
            return said(FlightText::tr("The velocity of circle %1 moves %who").arg(f.leader + 1),
                        FlightText::tr("In a scene in which circle %1 alone has a velocity, it is "
                                       "this circle that goes on by v Δt. Each circle moves with "
                                       "its own velocity: look at the names in the line that "
                                       "moves it.")
                            .arg(f.leader + 1),
                        true);
        if (f.jumps && !m_right.at(gravity(), timestep(), m_i).jumps)
            return said(FlightText::tr("The new place of %who does not depend on the old one"),
                        FlightText::tr("Wherever it starts, after the same two steps it is at the "
                                       "same place. A step *adds* a way to the old position."),
                        true);
        return std::nullopt;
    }

    using Part = std::function<double(const Flight &)>;

    /// \p part divided by that of the reference, for every timestep.
    [[nodiscard]] TimestepPattern pattern(Vec2 g, const Part &part) const
    {
        std::vector<std::pair<double, double>> factors;
        for (const double h : m_ground.timesteps)
            factors.emplace_back(h, part(m_own.at(g, h, m_i)) / part(m_right.at(g, h, m_i)));
        return patternOf(factors);
    }

    /// Where a number stands for the timestep, one that is another number shows it.
    [[nodiscard]] std::size_t shownTimestep(const TimestepPattern &p) const
    {
        if (p.kind != Kind::Fixed)
            return 0;
        const auto &all = m_ground.timesteps;
        const auto off = [&](double h) { return std::abs(std::log(h / p.value)); };
        const auto most = std::max_element(all.begin(), all.end(),
                                           [&](double a, double b) { return off(a) < off(b); });
        return static_cast<std::size_t>(most - all.begin());
    }

    [[nodiscard]] static bool isRight(const TimestepPattern &p)
    {
        return p.kind == Kind::Constant && std::abs(p.value - 1.0) < wrong;
    }

    /// What brakes or drives the velocity shows in \p part of the same step as well.
    [[nodiscard]] bool isBlurred(Vec2 g, const Part &part) const
    {
        for (std::size_t h = 0; h < m_ground.timesteps.size(); ++h) {
            const double step = m_ground.timesteps[h];
            const double factor = part(m_own.at(g, step, m_i)) / part(m_right.at(g, step, m_i));
            if (!(std::abs(factor - 1.0) <= growthBlur(h)))
                return false;
        }
        return growthBlur(0) > 0.0;
    }

    [[nodiscard]] std::optional<Said> way() const
    {
        const auto partX = [](const Flight &f) { return f.way.x; };
        const auto partY = [](const Flight &f) { return f.way.y; };
        const auto x = pattern(gravity(), partX);
        const auto y = pattern(gravity(), partY);
        if ((isRight(x) && isRight(y))
            || (isBlurred(gravity(), partX) && isBlurred(gravity(), partY)))
            return std::nullopt;
        const std::size_t at = shownTimestep(isRight(x) ? y : x);
        const double h = m_ground.timesteps[at];
        const Flight &f = flight(at);
        const bool isX = x.kind == Kind::Constant && x.value == 0.0;
        const bool isY = y.kind == Kind::Constant && y.value == 0.0;
        const auto seen = FlightText::tr("With the velocity %1 m/s and Δt = %2 s it goes %3 m in "
                                         "a step; v Δt is %4 m.")
                              .arg(brief(f.turnedInto), briefTimestep(h), brief(f.wayMade),
                                   brief(h * f.turnedInto));
        // A part that nobody asks for may stay; what is wrong with the other is said first.
        const TimestepPattern &other = isX ? y : isY || !isRight(x) ? x : y;
        if (isX != isY && isRight(other))
            return said(isX ? FlightText::tr("The x of %who never changes")
                            : FlightText::tr("The y of %who never changes"),
                        seen
                            + FlightText::tr(" Both parts of the position change, each by its own "
                                             "part of the velocity."),
                        true);
        const auto [headline, where] = wayWords(other);
        return said(headline, seen + QLatin1Char(' ') + where, true);
    }

    static std::pair<QString, QString> wayWords(const TimestepPattern &p)
    {
        switch (p.kind) {
        case Kind::Forgotten:
            return {FlightText::tr("The way of %who is not multiplied by the timestep"),
                    FlightText::tr("A velocity says how far it gets in a whole second; a step "
                                   "lasts only Δt.")};
        case Kind::Squared:
            return {FlightText::tr("The way of %who is multiplied by the timestep twice"),
                    FlightText::tr("Count how often the timestep stands in the line that moves "
                                   "it.")};
        case Kind::Fixed:
            return {FlightText::tr("A fixed number stands for the timestep in the way of %who"),
                    FlightText::tr("Whatever Δt is, it goes as far as in %1 s. Take the parameter "
                                   "of `on_update`.")
                        .arg(briefTimestep(p.value))};
        case Kind::Constant:
            break;
        case Kind::Other:
            return {FlightText::tr("The way of %who in a step is not v Δt"),
                    FlightText::tr("Look at the line that changes the position.")};
        }
        if (p.value == 0.0)
            return {FlightText::tr("Nothing moves %who"),
                    FlightText::tr("In every step its position gets v Δt added.")};
        if (std::abs(p.value + 1.0) < wrong)
            return {FlightText::tr("The way of %who is subtracted instead of added"),
                    FlightText::tr("Look at the sign in the line that moves it.")};
        if (std::abs(p.value - 2.0) < wrong)
            return {FlightText::tr("Every step moves %who twice"),
                    FlightText::tr("Count the lines that change the position in a step without a "
                                   "hit.")};
        return {FlightText::tr("The way of %who in a step is %1 times v Δt").arg(brief(p.value)),
                FlightText::tr("Look at the factors in the line that moves it.")};
    }

    [[nodiscard]] std::optional<Said> fall() const
    {
        if (auto number = numberForGravity())
            return number;
        for (const Vec2 g : m_ground.gravities) {
            if (auto fault = fallUnder(g))
                return fault;
        }
        return ownFall();
    }

    /// The same acceleration, whatever gravity is.
    [[nodiscard]] std::optional<Said> numberForGravity() const
    {
        for (const Vec2 g : m_ground.gravities) {
            const Vec2 own = m_own.at(g, timestep(), m_i).acceleration;
            const Vec2 right = m_right.at(g, timestep(), m_i).acceleration;
            const bool same =
                std::all_of(m_ground.gravities.begin(), m_ground.gravities.end(), [&](Vec2 other) {
                    return isAlike(m_own.at(other, timestep(), m_i).acceleration, own, wrong);
                });
            if (!same || (m_ground.gravities.size() < 2 && g != Vec2{}) || length(own) < wrong
                || length(own - right) < wrong)
                continue;
            return Said{FlightText::tr("A number stands for gravity in the motion of %who"),
                        FlightText::tr("In a scene with gravity %1 m/s² it is accelerated by %2 "
                                       "m/s², as in every other. The name `gravity` holds the "
                                       "value of the scene; look where your program has one of "
                                       "its own.")
                            .arg(brief(g), brief(own)),
                        moment(false, g)};
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<Said> fallUnder(Vec2 g) const
    {
        const Vec2 right = m_right.at(g, timestep(), m_i).acceleration;
        const Vec2 own = m_own.at(g, timestep(), m_i).acceleration;
        if (length(right) < wrong)
            return std::nullopt;
        const Vec2 down = normalized(right);
        const auto pull = [&](const Flight &f) { return dot(f.acceleration, down); };
        const auto p = pattern(g, pull);
        const Vec2 sideways = own - dot(own, down) * down;
        if (length(sideways) > wrong * length(right))
            return Said{FlightText::tr("Gravity pulls %who in a wrong direction"),
                        FlightText::tr("Under gravity %1 m/s² the velocity changes by %2 m/s in a "
                                       "step of %3 s; it should change by %4 m/s.")
                            .arg(brief(g), brief(timestep() * own), briefTimestep(timestep()),
                                 brief(timestep() * right)),
                        moment(false, g)};
        if (isRight(p) || isBlurred(g, pull))
            return std::nullopt;
        if (isOnPosition(g))
            return Said{FlightText::tr("Gravity moves %who at once and changes no velocity"),
                        FlightText::tr("Under gravity %1 m/s² a circle at rest is %2 m away after "
                                       "a step of %3 s, and its velocity is still 0. Gravity is an "
                                       "acceleration: it changes the velocity, and that moves the "
                                       "circle.")
                            .arg(brief(g), brief(m_own.at(g, timestep(), m_i).drift),
                                 briefTimestep(timestep())),
                        moment(true, g)};
        const auto [headline, where] = fallWords(p);
        const double h = m_ground.timesteps[shownTimestep(p)];
        return Said{headline,
                    FlightText::tr("Under gravity %1 m/s² the velocity changes by %2 m/s in a "
                                   "step of %3 s; it should change by %4 m/s.")
                            .arg(brief(g), brief(h * m_own.at(g, h, m_i).acceleration),
                                 briefTimestep(h), brief(h * m_right.at(g, h, m_i).acceleration))
                        + QLatin1Char(' ') + where,
                    moment(false, g)};
    }

    /// Whether gravity changes the place at once, and the velocity not at all.
    [[nodiscard]] bool isOnPosition(Vec2 g) const
    {
        const Flight &f = m_own.at(g, timestep(), m_i);
        return length(f.acceleration) < wrong && dot(f.drift, g) > 1e-9 * lengthSquared(g);
    }

    static std::pair<QString, QString> fallWords(const TimestepPattern &p)
    {
        switch (p.kind) {
        case Kind::Forgotten:
            return {FlightText::tr("Gravity acts on %who for a whole second in every step"),
                    FlightText::tr("An acceleration says what a second changes; a step lasts only "
                                   "Δt. Compare the units on both sides.")};
        case Kind::Squared:
            return {FlightText::tr("Gravity on %who is multiplied by the timestep twice"),
                    FlightText::tr("Count how often the timestep stands in the line that changes "
                                   "the velocity.")};
        case Kind::Fixed:
            return {FlightText::tr("A fixed number stands for the timestep in the fall of %who"),
                    FlightText::tr("Whatever Δt is, gravity acts for %1 s. Take the parameter of "
                                   "`on_update`.")
                        .arg(briefTimestep(p.value))};
        case Kind::Constant:
        case Kind::Other:
            break;
        }
        if (std::abs(p.value) < wrong)
            return {FlightText::tr("Gravity does not act on %who"),
                    FlightText::tr("It needs a line that lets gravity change the velocity, in "
                                   "every step.")};
        if (std::abs(p.value + 1.0) < wrong)
            return {FlightText::tr("Gravity pushes %who against its own direction"),
                    FlightText::tr("Look at the signs.")};
        if (std::abs(p.value - 2.0) < wrong)
            return {FlightText::tr("Gravity acts on %who twice in every step"),
                    FlightText::tr("Count the lines of a step that change the velocity.")};
        if (std::abs(p.value - 0.5) < wrong)
            return {FlightText::tr("The velocity of %who gets only half of gravity"),
                    FlightText::tr("Where a method takes two halves, both count.")};
        return {FlightText::tr("Gravity on %who is %1 times as strong as it should be")
                    .arg(brief(p.value)),
                FlightText::tr("Look at the factors in the line that changes the velocity.")};
    }

    /// The own scene must fall as all others do: else a copy of gravity is older than gravity.
    [[nodiscard]] std::optional<Said> ownFall() const
    {
        const MeasuredFlight::Own &own = m_own.own();
        const auto i = static_cast<std::size_t>(m_i);
        if (!own.runs || i >= own.accelerations.size())
            return std::nullopt;
        const Vec2 right = own.scene.gravity;
        const Vec2 braked = flight(0).growth;
        const Vec2 v = own.scene.circles[i].body.velocity;
        const Vec2 fallen = own.accelerations[i] - Vec2{braked.x * v.x, braked.y * v.y};
        const bool isAsked = std::find(m_ground.gravities.begin(), m_ground.gravities.end(), right)
                             != m_ground.gravities.end();
        const double blur = 1e-6 + growthBlur(0);
        if (!isAsked || length(fallen - right) < blur * (1.0 + length(right))
            || length(m_right.at(right, timestep(), m_i).acceleration - right) > wrong)
            return std::nullopt;
        return Said{FlightText::tr("The fall of %who is not that of the gravity in the scene"),
                    FlightText::tr("In your own scene gravity is %1 m/s², and the velocity changes "
                                   "by %2 m/s in a second. A copy of gravity keeps the value of "
                                   "the moment when it was made: before or after `on_load` has "
                                   "set it?")
                        .arg(brief(right), brief(own.accelerations[i])),
                    {{m_ground.own, false}, 1, {m_i}, false}};
    }

    [[nodiscard]] std::optional<Said> growth() const
    {
        const Flight &f = flight(0);
        const Flight &r = m_right.at(gravity(), timestep(), m_i);
        if (isAlike(f.growth, r.growth, wrong) && isAlike(f.pull, r.pull, wrong))
            return std::nullopt;
        if (!isAlike(f.pull, r.pull, wrong))
            return said(
                FlightText::tr("The place of %who acts on its velocity otherwise than asked"),
                FlightText::tr("For every metre further out the acceleration changes by %1 "
                               "m/s²; %2 is right.")
                    .arg(brief(f.pull), brief(r.pull)),
                false);
        const bool isX = std::abs(f.growth.x - r.growth.x) > wrong;
        const double is = isX ? f.growth.x : f.growth.y;
        const double asked = isX ? r.growth.x : r.growth.y;
        return said(growthHeadline(is, asked),
                    FlightText::tr("For every m/s of velocity the acceleration is %1 m/s²; %2 is "
                                   "right.")
                        .arg(brief(is), brief(asked)),
                    false);
    }

    static QString growthHeadline(double is, double asked)
    {
        if (std::abs(asked) < wrong)
            return is < 0.0 ? FlightText::tr("Something slows %who down on the way")
                            : FlightText::tr("Something makes %who faster on the way");
        if (std::abs(is) < wrong)
            return asked < 0.0 ? FlightText::tr("Nothing slows %who down on the way")
                               : FlightText::tr("Nothing makes %who faster on the way");
        if (is * asked < 0.0)
            return asked < 0.0 ? FlightText::tr("What should slow %who down makes it faster")
                               : FlightText::tr("What should make %who faster slows it down");
        return FlightText::tr("What acts on the velocity of %who is %1 times as strong as it "
                              "should be")
            .arg(brief(is / asked));
    }

    /// Which integrator: how much of the acceleration reaches the position of the same step.
    /// \param isFallRight  else only a method that is known and is none of those asked for
    [[nodiscard]] std::optional<Said> method(bool isFallRight) const
    {
        const auto shares = m_ground.flights[static_cast<std::size_t>(m_i)].shares;
        for (const Vec2 g : m_ground.gravities) {
            const auto share = m_own.at(g, timestep(), m_i).share(timestep());
            if (!share)
                continue;
            const auto is = [&](double s) { return std::abs(*share - s) < 1e-3; };
            if (std::any_of(shares.begin(), shares.end(), is)
                || (!isFallRight && !isOtherMethod(g, *share)))
                return std::nullopt;
            const QString asked =
                shares.size() == 1 ? FlightText::tr("%1 is asked for.").arg(brief(shares.front()))
                                   : FlightText::tr("One of these is asked for.");
            return Said{headlineOf(*share, shares),
                        FlightText::tr("From rest under gravity %1 m/s² it goes on by %2 a Δt² in "
                                       "a step besides v Δt. Euler moves with the old velocity, 0; "
                                       "symplectic Euler with the new one, 1; the exact methods "
                                       "with ½.")
                                .arg(brief(g), brief(*share))
                            + QLatin1Char(' ') + asked,
                        moment(true, g), true};
        }
        return std::nullopt;
    }

    /// Whether that share is a method of its own, and not the right drift beside a wrong fall.
    [[nodiscard]] bool isOtherMethod(Vec2 g, double share) const
    {
        const Vec2 a = m_right.at(g, timestep(), m_i).acceleration;
        const Vec2 drift = m_own.at(g, timestep(), m_i).drift;
        const double asked = dot(drift, a) / (lengthSquared(a) * timestep() * timestep());
        const auto &shares = m_ground.flights[static_cast<std::size_t>(m_i)].shares;
        return lengthSquared(a) > 0.0 && (std::abs(share) < 1e-3 || std::abs(share - 1.0) < 1e-3)
               && std::none_of(shares.begin(), shares.end(),
                               [&](double s) { return std::abs(asked - s) < 1e-3; });
    }

    static QString headlineOf(double share, const std::vector<double> &wanted)
    {
        const auto is = [&](double s) { return std::abs(share - s) < 1e-3; };
        if (wanted.size() > 1)
            return FlightText::tr("The motion of %who is no known method");
        const QString asked = shareName(wanted.front());
        if (is(0.0) || is(0.5) || is(1.0))
            return FlightText::tr("The motion of %who is %1, not %2").arg(shareName(share), asked);
        return FlightText::tr("The motion of %who is no known method; %1 is asked for").arg(asked);
    }

    static QString shareName(double share)
    {
        if (std::abs(share) < 1e-3)
            return FlightText::tr("Euler");
        if (std::abs(share - 1.0) < 1e-3)
            return FlightText::tr("symplectic Euler");
        return FlightText::tr("the exact parabola (Verlet, Runge-Kutta 4)");
    }

    const MeasuredFlight &m_own;
    const MeasuredFlight &m_right;
    const Ground &m_ground;
    int m_i;
};

/// What is wrong with the methods of all circles together.
std::optional<LawDeviation> methodsTogether(const MeasuredFlight &own, const Ground &ground)
{
    const double h = ground.timesteps.front();
    std::vector<double> shares;
    std::vector<int> circles;
    for (std::size_t i = 0; i < ground.flights.size(); ++i) {
        const int circle = static_cast<int>(i);
        for (const Vec2 g : ground.gravities) {
            if (const auto share = own.at(g, h, circle).share(h)) {
                shares.push_back(*share);
                circles.push_back(circle);
                break;
            }
        }
    }
    if (shares.size() != ground.flights.size() || shares.size() < 2)
        return std::nullopt;
    const auto asks = [&](std::size_t i, double share) {
        const auto &all = ground.flights[i].shares;
        return std::any_of(all.begin(), all.end(),
                           [&](double s) { return std::abs(s - share) < 1e-3; });
    };
    LawDeviation deviation{
        Aspect::Motion, {}, {flightStage(ground, ground.gravities.front(), h), 2, circles, true}};
    const bool exchanged =
        asks(0, shares[1]) && asks(1, shares[0]) && !asks(0, shares[0]) && !asks(1, shares[1]);
    if (exchanged) {
        deviation.message =
            FlightText::tr("The circles have each other's method\n\nUnder gravity circle 1 goes on "
                           "by %1 a Δt² in a step besides v Δt, and circle 2 by %2 a Δt²; it "
                           "should be the other way round. Look at which circle goes with which "
                           "method.")
                .arg(brief(shares[0]), brief(shares[1]));
        return deviation;
    }
    if (ground.sameIntegrator && std::abs(shares[0] - shares[1]) > 1e-3 && asks(0, shares[0])
        && asks(1, shares[1])) {
        deviation.message =
            FlightText::tr("The circles move by different methods\n\nUnder gravity circle 1 goes "
                           "on by %1 a Δt² in a step besides v Δt, and circle 2 by %2 a Δt²; both "
                           "need the same. Look at which lines move which circle.")
                .arg(brief(shares[0]), brief(shares[1]));
        return deviation;
    }
    return std::nullopt;
}

QString withNames(QString text, const std::vector<int> &circles, std::size_t all)
{
    const QString names = circleNames(circles, all);
    return text.replace(QLatin1String("%who"), names);
}

} // namespace

std::vector<LawDeviation> flightDeviations(const MeasuredFlight &own, const MeasuredFlight &right,
                                           const Ground &ground)
{
    std::vector<std::pair<Said, std::vector<int>>> groups;
    for (std::size_t i = 0; i < ground.flights.size(); ++i) {
        const int circle = static_cast<int>(i);
        if (!ground.flights[i].asked || ground.timesteps.empty() || ground.gravities.empty())
            continue;
        for (const Said &said : FlightJudge(own, right, ground, circle).judge()) {
            const auto same = std::find_if(groups.begin(), groups.end(), [&](const auto &group) {
                return group.first.headline == said.headline;
            });
            if (same == groups.end())
                groups.push_back({said, {circle}});
            else
                same->second.push_back(circle);
        }
    }
    // Methods can be compared only where the rest is right.
    const bool onlyMethods = std::all_of(groups.begin(), groups.end(),
                                         [](const auto &group) { return group.first.isMethod; });
    const auto together = onlyMethods ? methodsTogether(own, ground) : std::nullopt;
    std::vector<LawDeviation> deviations;
    for (auto &[said, circles] : groups) {
        const QString headline = withNames(said.headline, circles, ground.flights.size());
        if (together && said.isMethod)
            continue;
        said.moment.circles = circles;
        deviations.push_back({Aspect::Motion,
                              headline + QStringLiteral("\n\n")
                                  + withNames(said.body, circles, ground.flights.size()),
                              said.moment});
    }
    if (together)
        deviations.push_back(*together);
    return deviations;
}

} // namespace cradle
