// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_kinds.h"
#include "tasks/checks/contacts.h"
#include "tasks/checks/figures.h"
#include "tasks/checks/kinds.h"
#include "tasks/checks/motion.h"

#include <QCoreApplication>
#include <QJsonArray>

#include <utility>

namespace cradle::kinds {

namespace {

struct ConserveText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

/// Less than this share of the energy is no loss that a student set.
constexpr double visibleLoss = 1e-6;

struct Balance {
    Vec2 momentumBefore{};
    Vec2 momentumAfter{};
    double scale = 0.0; ///< the sum of the momenta's lengths, kg m/s
    double energyBefore = 0.0;
    double energyAfter = 0.0;
};

Balance balanceOf(const Observation &o, const motion::Contact &c)
{
    const double ma = mass(o.circle(0, c.step));
    const double mb = mass(o.circle(1, c.step));
    return {.momentumBefore = ma * c.beforeA + mb * c.beforeB,
            .momentumAfter = ma * c.afterA + mb * c.afterB,
            .scale = ma * length(c.beforeA) + mb * length(c.beforeB),
            .energyBefore = 0.5 * (ma * lengthSquared(c.beforeA) + mb * lengthSquared(c.beforeB)),
            .energyAfter = 0.5 * (ma * lengthSquared(c.afterA) + mb * lengthSquared(c.afterB))};
}

Fault noContact()
{
    return {.message =
                ConserveText::tr("In this scene no hit changed the velocities of the circles; one "
                                 "should"),
            .step = 0};
}

/// That they never met in a scene in which they should pass through each other.
Fault neverMet()
{
    return {.message = ConserveText::tr("In this scene the circles never met, so nothing shows "
                                        "whether they pass through each other"),
            .step = 0};
}

/// Whether they cannot have touched in the step of \p contact.
bool isFarApart(const Observation &o, const motion::Contact &contact, Vec2 gravity)
{
    return contact.nearest > motion::travel(o, 0, contact.step, gravity)
                                 + motion::travel(o, 1, contact.step, gravity);
}

/// Whether they were coming no nearer when that step began.
bool isParting(const Observation &o, const motion::Contact &contact)
{
    const Vec2 d = o.circle(1, contact.step).position - o.circle(0, contact.step).position;
    return dot(contact.beforeB - contact.beforeA, d) >= 0.0;
}

std::vector<motion::Contact> contacts(const CheckSpec &check, const Observation &o)
{
    return motion::contactsOf(o, 0, 1, motion::gravityOf(check, o));
}

/// The same without those in whose step a wall may push, too.
std::vector<motion::Contact> contactsInTheOpen(const CheckSpec &check, const Observation &o)
{
    const Vec2 gravity = motion::gravityOf(check, o);
    auto found = contacts(check, o);
    std::erase_if(found, [&](const motion::Contact &contact) {
        return motion::isBesideWall(o, 0, 1, contact, gravity);
    });
    return found;
}

} // namespace

std::optional<Fault> conserves(const CheckSpec &check, const Observation &o)
{
    if (contacts(check, o).empty())
        return noContact();
    const double kept = motion::toleranceOf(check);
    const bool energy = valueOf(check, QStringLiteral("energy")).toBool();
    const Vec2 gravity = motion::gravityOf(check, o);
    for (const motion::Contact &contact : contactsInTheOpen(check, o)) {
        const Balance b = balanceOf(o, contact);
        if (length(b.momentumAfter - b.momentumBefore) > kept * b.scale) {
            const bool x = std::abs(b.momentumAfter.x - b.momentumBefore.x)
                           > std::abs(b.momentumAfter.y - b.momentumBefore.y);
            if (auto fault = motion::steadyFaultOf(o, 0, 1, gravity))
                return fault;
            const QString text =
                isFarApart(o, contact, gravity)
                    ? ConserveText::tr("At step %1, where the circles do not touch, the total "
                                       "momentum changed from %2 to %3 kg m/s; it should stay")
                : isParting(o, contact)
                    ? ConserveText::tr("At step %1, while the circles did not come nearer, the "
                                       "total momentum changed from %2 to %3 kg m/s; it should "
                                       "stay")
                    : ConserveText::tr("At step %1 the hit changed the total momentum from %2 to "
                                       "%3 kg m/s; it should stay");
            return Fault{.message =
                             text.arg(QString::number(contact.step + 1),
                                      motion::figureBeside(b.momentumBefore, b.momentumAfter),
                                      motion::figureBeside(b.momentumAfter, b.momentumBefore)),
                         .expected = x ? b.momentumBefore.x : b.momentumBefore.y,
                         .observed = x ? b.momentumAfter.x : b.momentumAfter.y,
                         .unit = QStringLiteral("kg m/s"),
                         .step = contact.step + 1};
        }
        if (energy && std::abs(b.energyAfter - b.energyBefore) > kept * b.energyBefore) {
            if (auto fault = motion::steadyFaultOf(o, 0, 1, gravity))
                return fault;
            const QString text =
                isFarApart(o, contact, gravity)
                    ? ConserveText::tr("At step %1, where the circles do not touch, the kinetic "
                                       "energy changed from %2 to %3 J; it should stay")
                : isParting(o, contact)
                    ? ConserveText::tr("At step %1, while the circles did not come nearer, the "
                                       "kinetic energy changed from %2 to %3 J; it should stay")
                    : ConserveText::tr("At step %1 the hit changed the kinetic energy from %2 to "
                                       "%3 J; it should stay");
            return Fault{.message = text.arg(QString::number(contact.step + 1),
                                             motion::figureBeside(b.energyBefore, b.energyAfter),
                                             motion::figureBeside(b.energyAfter, b.energyBefore)),
                         .expected = b.energyBefore,
                         .observed = b.energyAfter,
                         .unit = QStringLiteral("J"),
                         .step = contact.step + 1};
        }
    }
    return std::nullopt;
}

std::optional<Fault> afterContact(const CheckSpec &check, const Observation &o)
{
    const auto found = contacts(check, o);
    if (found.empty())
        return noContact();
    const double tolerance = motion::toleranceOf(check);
    const QJsonArray wanted = check.parameters.value(QStringLiteral("velocities")).toArray();
    const std::pair<int, Vec2> leaving[] = {{0, found.front().afterA}, {1, found.front().afterB}};
    for (const auto &[circle, observed] : leaving) {
        const QJsonArray v = wanted.at(circle).toArray();
        const Vec2 expected{v.at(0).toDouble(), v.at(1).toDouble()};
        if (v.isEmpty() || length(observed - expected) <= tolerance)
            continue;
        if (auto fault = motion::steadyFaultOf(o, 0, 1, motion::gravityOf(check, o)))
            return fault;
        const bool x = std::abs(observed.x - expected.x) > std::abs(observed.y - expected.y);
        return Fault{.message = ConserveText::tr("At step %1 circle %2 left the first hit with %3 "
                                                 "m/s; %4 m/s is right")
                                    .arg(QString::number(found.front().step + 1),
                                         QString::number(circle + 1),
                                         motion::figureBeside(observed, expected),
                                         motion::figureBeside(expected, observed)),
                     .expected = x ? expected.x : expected.y,
                     .observed = x ? observed.x : observed.y,
                     .unit = QStringLiteral("m/s"),
                     .step = found.front().step + 1};
    }
    return std::nullopt;
}

std::optional<Fault> losesEnergy(const CheckSpec &check, const Observation &o)
{
    const Vec2 gravity = motion::gravityOf(check, o);
    auto found = contacts(check, o);
    std::erase_if(found, [&](const motion::Contact &contact) {
        return isFarApart(o, contact, gravity) || isParting(o, contact);
    });
    if (found.empty())
        return noContact();
    const Balance b = balanceOf(o, found.front());
    if (b.energyAfter < b.energyBefore * (1.0 - visibleLoss))
        return std::nullopt;
    if (auto fault = motion::steadyFaultOf(o, 0, 1, gravity))
        return fault;
    return Fault{.message =
                     ConserveText::tr("At step %1 the kinetic energy was %2 J before the hit "
                                      "and %3 J after it; with e below 1 it should be less")
                         .arg(QString::number(found.front().step + 1),
                              motion::figureBeside(b.energyBefore, b.energyAfter),
                              motion::figureBeside(b.energyAfter, b.energyBefore)),
                 .expected = b.energyBefore,
                 .observed = b.energyAfter,
                 .unit = QStringLiteral("J"),
                 .step = found.front().step + 1};
}

std::optional<Fault> passesThrough(const CheckSpec &check, const Observation &o)
{
    const Vec2 gravity = motion::gravityOf(check, o);
    bool met = false;
    for (qint64 k = 0; k < o.steps(); ++k) {
        const Circle &a = o.circle(0, k);
        const Circle &b = o.circle(1, k);
        met = met || length(b.position - a.position) < a.radius + b.radius;
        for (int i = 0; i < 2; ++i) {
            if (!motion::isKicked(o, i, k, gravity) || motion::isNearWall(o, i, k, gravity))
                continue;
            if (auto fault = motion::steadyFault(o, i, gravity))
                return fault;
            return Fault{.message = ConserveText::tr("At step %1 the velocity of circle %2 changed "
                                                     "from %3 to %4 m/s; the circles should pass "
                                                     "through each other unchanged")
                                        .arg(QString::number(k + 1), QString::number(i + 1),
                                             motion::figureBeside(o.circle(i, k).velocity,
                                                                  o.circle(i, k + 1).velocity),
                                             motion::figureBeside(o.circle(i, k + 1).velocity,
                                                                  o.circle(i, k).velocity)),
                         .step = k + 1};
        }
    }
    return met ? std::nullopt : std::optional(neverMet());
}

} // namespace cradle::kinds
