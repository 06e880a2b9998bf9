// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/integrator_matching.h"

#include "model/files/preset_json.h"
#include "tasks/checks/check_kinds.h"
#include "tasks/checks/kinds.h"
#include "tasks/checks/motion.h"

#include <QCoreApplication>
#include <QJsonArray>

#include <algorithm>

namespace cradle {

namespace {

struct IntegratorText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

bool agrees(Integrator integrator, const Observation &o, int i, qint64 k, Vec2 gravity,
            double tolerance = motion::samePosition)
{
    const Circle &now = o.circle(i, k);
    const Motion next = advance(integrator, {now.position, now.velocity}, gravity, o.timestep());
    const double error = quickLength(o.circle(i, k + 1).position - next.position);
    return error <= tolerance * (1.0 + quickLength(now.position));
}

/// All integrators that step \p k agrees with.
std::vector<Integrator> agreeing(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    std::vector<Integrator> found;
    std::copy_if(std::begin(allIntegrators), std::end(allIntegrators), std::back_inserter(found),
                 [&](Integrator integrator) { return agrees(integrator, o, i, k, gravity); });
    return found;
}

/// In how many equal parts of a step the drift of one or the other Euler is \p share of a Δt².
std::optional<int> substepsOf(double share)
{
    constexpr double most = 1000.0;
    const double parts = 0.5 / std::abs(share - 0.5);
    const bool isWhole = std::abs(parts - std::round(parts)) < 1e-4 * parts;
    return parts < most && isWhole ? std::optional(static_cast<int>(std::round(parts)))
                                   : std::nullopt;
}

/// Whether the steps of circle \p i are of one or the other Euler in equal parts of a step: in n
/// parts the place gets (½ ± 1/2n) a Δt² besides v Δt.
class Substeps
{
public:
    /// \return whether the step after \p k goes on as those before
    bool take(const Observation &o, int i, qint64 k, Vec2 gravity, double tolerance)
    {
        const double h = o.timestep();
        const Circle &now = o.circle(i, k);
        const Vec2 drift = o.circle(i, k + 1).position - now.position - h * now.velocity;
        const Vec2 fall = h * h * gravity;
        if (!m_share) {
            m_share = lengthSquared(fall) > 0.0 ? dot(drift, fall) / lengthSquared(fall) : 0.0;
            if (const auto parts = substepsOf(*m_share)) {
                const double side = *m_share < 0.5 ? -0.5 : 0.5;
                m_share = 0.5 + side / *parts;
            } else {
                m_isOne = false;
            }
        }
        m_isOne = m_isOne
                  && quickLength(drift - *m_share * fall)
                         <= tolerance * (1.0 + quickLength(now.position));
        return m_isOne;
    }

private:
    std::optional<double> m_share{};
    bool m_isOne = true;
};

std::vector<Integrator> wantedIntegrators(const CheckSpec &check)
{
    std::vector<Integrator> wanted;
    for (const QJsonValue &name : valueOf(check, QStringLiteral("integrators")).toArray()) {
        if (const auto integrator = integratorFromName(name.toString()))
            wanted.push_back(*integrator);
    }
    return wanted;
}

Fault wrongAcceleration(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    const Vec2 change = o.circle(i, k + 1).velocity - o.circle(i, k).velocity;
    const Vec2 observed = change / o.timestep();
    const bool x = std::abs(observed.x - gravity.x) > std::abs(observed.y - gravity.y);
    return {.message = IntegratorText::tr("At step %1 the velocity of circle %2 changed by %3 m/s, "
                                          "an acceleration of %4 m/s²; %5 m/s² is right here")
                           .arg(QString::number(k + 1), QString::number(i + 1),
                                motion::figure(change), motion::figureBeside(observed, gravity),
                                motion::figureBeside(gravity, observed)),
            .expected = x ? gravity.x : gravity.y,
            .observed = x ? observed.x : observed.y,
            .unit = QStringLiteral("m/s²"),
            .step = k + 1,
            .circle = i};
}

/// What is wrong in a step that none of the \p wanted makes: told beside the one that comes
/// nearest.
Fault wrongPlace(const Observation &o, int i, qint64 k, Vec2 gravity,
                 const std::vector<Integrator> &wanted)
{
    const Circle &now = o.circle(i, k);
    const Vec2 observed = o.circle(i, k + 1).position - now.position;
    const auto way = [&](Integrator integrator) {
        return advance(integrator, {now.position, now.velocity}, gravity, o.timestep()).position
               - now.position;
    };
    const Integrator nearest =
        *std::min_element(wanted.begin(), wanted.end(), [&](Integrator a, Integrator b) {
            return quickLength(way(a) - observed) < quickLength(way(b) - observed);
        });
    const Vec2 right = way(nearest);
    const bool x = std::abs(observed.x - right.x) > std::abs(observed.y - right.y);
    QString message =
        (wanted.size() == 1
             ? IntegratorText::tr("At step %1 circle %2 moved by %3 m; by %4 it moves by %5 m")
             : IntegratorText::tr("At step %1 circle %2 moved by %3 m, as by no integrator that "
                                  "is right here; the nearest of them, %4, moves it by %5 m"))
            .arg(QString::number(k + 1), QString::number(i + 1),
                 motion::figureBeside(observed, right), motion::integratorName(nearest),
                 motion::figureBeside(right, observed));
    if (gravity == Vec2{}) {
        message =
            IntegratorText::tr("At step %1 circle %2 moved by %3 m; its velocity times the "
                               "timestep is %4 m")
                .arg(QString::number(k + 1), QString::number(i + 1),
                     motion::figureBeside(observed, right), motion::figureBeside(right, observed));
    }
    const std::vector<Integrator> instead = agreeing(o, i, k, gravity);
    if (!instead.empty())
        message += IntegratorText::tr(". In this step %1 does so").arg(namesOf(instead));
    return {.message = message,
            .expected = x ? right.x : right.y,
            .observed = x ? observed.x : observed.y,
            .unit = QStringLiteral("m"),
            .step = k + 1,
            .circle = i};
}

/// Of a scene's duration: what must be seen of the free motion where the check says nothing.
constexpr double leastShare = 0.1;

/// How many steps of circle \p i nothing can meet it in.
qint64 freeSteps(const CheckSpec &check, const Observation &o, int i, Vec2 gravity)
{
    qint64 steps = 0;
    for (qint64 k = 0; k < o.steps(); ++k)
        steps += motion::isFree(check, o, i, k, gravity) ? 1 : 0;
    return steps;
}

/// For how long a circle was near what it may hit, s.
struct Nearness {
    double wall = 0.0;
    double circle = 0.0;
};

Nearness nearnessOf(const Observation &o, int i, Vec2 gravity)
{
    Nearness near;
    for (qint64 k = 0; k < o.steps(); ++k) {
        near.wall += motion::isNearWall(o, i, k, gravity) ? o.timestep() : 0.0;
        near.circle += motion::isNearCircle(o, i, k, gravity) ? o.timestep() : 0.0;
    }
    return near;
}

/// What is missing to judge the motion of circle \p i, which was free for \p steps steps.
std::optional<Fault> tooLittle(const CheckSpec &check, const Observation &o, int i, qint64 steps,
                               Vec2 gravity)
{
    const double seen = static_cast<double>(steps) * o.timestep();
    const double wanted =
        check.parameters.value(QStringLiteral("free")).toDouble(leastShare * o.variant.duration);
    if (seen > wanted - o.timestep())
        return std::nullopt;
    const Nearness near = nearnessOf(o, i, gravity);
    return Fault{.message =
                     IntegratorText::tr("Circle %1 was free of walls and other circles for "
                                        "%2 s only; at least %3 s must be seen to judge its "
                                        "motion")
                         .arg(QString::number(i + 1), motion::figureBeside(seen, wanted),
                              motion::figureBeside(wanted, seen))
                     + IntegratorText::tr(". It was close to a wall for %1 s, and to another "
                                          "circle for %2 s: look at what it does there")
                           .arg(motion::figure(near.wall), motion::figure(near.circle)),
                 .expected = wanted,
                 .observed = seen,
                 .unit = QStringLiteral("s"),
                 .step = 0,
                 .circle = i};
}

} // namespace

QString namesOf(const std::vector<Integrator> &integrators)
{
    QStringList names;
    for (const Integrator integrator : integrators)
        names.append(motion::integratorName(integrator));
    return names.join(IntegratorText::tr(" or "));
}

std::vector<Integrator> matchingIntegrators(const CheckSpec &check, const Observation &o, int i,
                                            Vec2 gravity)
{
    std::vector<Integrator> left(std::begin(allIntegrators), std::end(allIntegrators));
    for (qint64 k = 0; k < o.steps() && !left.empty(); ++k) {
        if (!motion::isFree(check, o, i, k, gravity))
            continue;
        std::erase_if(left, [&](Integrator integrator) {
            return motion::isKicked(o, i, k, gravity) || !agrees(integrator, o, i, k, gravity);
        });
    }
    return left;
}

namespace kinds {

std::optional<Fault> integrates(const CheckSpec &check, const Observation &o)
{
    const Vec2 gravity = motion::gravityOf(check, o);
    const std::vector<Integrator> wanted = wantedIntegrators(check);
    const double tolerance = motion::toleranceOf(check);
    const bool isAnyMethod = !check.parameters.contains(QStringLiteral("integrators"));
    for (const int i : check.circles) {
        std::vector<Integrator> left = wanted;
        // Where no method is asked for, one in smaller steps is as good.
        bool isSubstepped = isAnyMethod;
        Substeps substeps;
        qint64 seen = 0;
        for (qint64 k = 0; k < o.steps(); ++k) {
            if (!motion::isFree(check, o, i, k, gravity))
                continue;
            ++seen;
            if (motion::isKicked(o, i, k, gravity, tolerance))
                return wrongAcceleration(o, i, k, gravity);
            std::erase_if(left, [&](Integrator integrator) {
                return !agrees(integrator, o, i, k, gravity, tolerance);
            });
            isSubstepped = isSubstepped && substeps.take(o, i, k, gravity, tolerance);
            if (left.empty() && !isSubstepped)
                return wrongPlace(o, i, k, gravity, wanted);
        }
        if (auto fault = tooLittle(check, o, i, seen, gravity))
            return fault;
    }
    return std::nullopt;
}

std::optional<Fault> sameIntegrator(const CheckSpec &check, const Observation &o)
{
    const Vec2 gravity = motion::gravityOf(check, o);
    std::vector<Integrator> first;
    for (const int i : check.circles) {
        if (auto fault = tooLittle(check, o, i, freeSteps(check, o, i, gravity), gravity))
            return fault;
        const std::vector<Integrator> own = matchingIntegrators(check, o, i, gravity);
        if (own.empty()) {
            return Fault{.message = IntegratorText::tr("Circle %1 moves by none of the four "
                                                       "integrators under gravity %2 m/s²")
                                        .arg(QString::number(i + 1), motion::figure(gravity)),
                         .step = 1};
        }
        if (first.empty())
            first = own;
        if (own != first) {
            return Fault{.message = IntegratorText::tr("Circle %1 moves by %2 and circle %3 by %4; "
                                                       "the same for both is right")
                                        .arg(QString::number(check.circles.front() + 1),
                                             namesOf(first), QString::number(i + 1), namesOf(own)),
                         .step = 1};
        }
    }
    return std::nullopt;
}

std::optional<Fault> closedForm(const CheckSpec &check, const Observation &o)
{
    const Vec2 gravity = motion::gravityOf(check, o);
    const double tolerance = motion::toleranceOf(check);
    for (const int i : check.circles) {
        const Circle &begin = o.circle(i, 0);
        qint64 k = 0;
        for (; k < o.steps() && motion::isFree(check, o, i, k, gravity); ++k) {
            const double t = o.states.time(k + 1);
            const Vec2 right = begin.position + t * begin.velocity + (0.5 * t * t) * gravity;
            const Vec2 observed = o.circle(i, k + 1).position;
            if (quickLength(observed - right) <= tolerance)
                continue;
            const bool x = std::abs(observed.x - right.x) > std::abs(observed.y - right.y);
            return Fault{.message =
                             IntegratorText::tr("At step %1 circle %2 is at %3 m; x₀ + v₀t + ½gt² "
                                                "is %4 m")
                                 .arg(QString::number(k + 1), QString::number(i + 1),
                                      motion::figureBeside(observed, right),
                                      motion::figureBeside(right, observed)),
                         .expected = x ? right.x : right.y,
                         .observed = x ? observed.x : observed.y,
                         .unit = QStringLiteral("m"),
                         .step = k + 1,
                         .circle = i};
        }
        if (auto fault = tooLittle(check, o, i, k, gravity))
            return fault;
    }
    return std::nullopt;
}

} // namespace kinds

} // namespace cradle
