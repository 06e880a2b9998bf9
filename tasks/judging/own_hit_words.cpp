// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/figures.h"
#include "tasks/judging/response_law_words.h"
#include "tasks/judging/response_reading.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Whether a ratio of masses is that of the circles with some radius or density that they had
/// before the program set it.
bool isOfOldValues(const PairHit &hit, double ratio, const MassExponents &masses)
{
    const Circle &first = hit.stage.preset.circles[0].body;
    const Circle &second = hit.stage.preset.circles[1].body;
    constexpr double sameRatio = 0.02;
    constexpr double nearer = 0.1; // than with the values that the program has set
    const auto offBy = [&](const Meeting &m) { return std::abs(masses.ratioOf(m) / ratio - 1.0); };
    for (unsigned old = 1; old < 16; ++old) {
        Meeting m = hit.meeting;
        m.radius1 = old & 1 ? first.radius : m.radius1;
        m.radius2 = old & 2 ? second.radius : m.radius2;
        m.density1 = old & 4 ? first.density : m.density1;
        m.density2 = old & 8 ? second.density : m.density2;
        if (offBy(m) < std::min(sameRatio, nearer * offBy(hit.meeting)))
            return true;
    }
    return false;
}

/// That the masses in \p hit are not those that the program has elsewhere.
std::optional<LawDeviation> ownMasses(const PairHit &hit, const MeasuredPair &own, bool isElseRight)
{
    const Meeting &m = hit.meeting;
    const auto heavy = massRatio(hit);
    const MassExponents p(own);
    if (!heavy || (!p.radius && !p.density))
        return std::nullopt;
    const double wanted = p.ratioOf(m);
    if (const auto equal = massRatio(own.equals.front());
        equal && std::abs(*equal - 1.0) > 1e-6 && std::abs(*heavy / wanted / *equal - 1.0) < 1e-6)
        return responseDeviation(
            ResponseText::tr("Two equal circles do not count as equally heavy"),
            ResponseText::tr("They answer as if circle 2 were %1 times as heavy as circle 1. "
                             "Compare the lines for the two masses, and those for the two pushes, "
                             "number by number.")
                .arg(motion::figureBeside(*equal, 1.0)),
            own.equals.front(), Suspect::Masses);
    if (std::abs(*heavy - wanted) <= (isHeadOn(hit) ? 1e-5 : 0.02) * wanted)
        return std::nullopt;
    const bool isOld = isOfOldValues(hit, *heavy, p);
    const QString seen =
        isElseRight
            ? ResponseText::tr("There circle 2 answers as if it were %1 times as heavy as "
                               "circle 1; with its radii %2 and %3 m and densities %4 and %5 "
                               "it is %6 times. In other scenes the masses come out right.")
                  .arg(motion::figureBeside(*heavy, wanted), brief(m.radius1), brief(m.radius2),
                       brief(m.density1), brief(m.density2), motion::figureBeside(wanted, *heavy))
            : ResponseText::tr("There circle 2 answers as if it were %1 times as heavy as "
                               "circle 1; as your program does in other scenes, it would be %2 "
                               "times.")
                  .arg(motion::figureBeside(*heavy, wanted), motion::figureBeside(wanted, *heavy));
    const QString look =
        isOld ? ResponseText::tr("So it is with radii or densities from before `on_load`: a mass "
                                 "that is worked out before they are set keeps the old value. Look "
                                 "at the order there, and at what is asked before the answer.")
              : ResponseText::tr("Look at what the answer takes for the masses there, and at what "
                                 "is asked before it.");
    return responseDeviation(
        ResponseText::tr("In your own scene the circles answer as if they had other masses"),
        seen + QLatin1Char(' ') + look, hit, isOld ? Suspect::Masses : Suspect::Formula);
}

} // namespace

std::optional<LawDeviation> ownDeviation(const MeasuredPair &own, const MeasuredPair &right,
                                         bool isElseRight)
{
    if (!own.own || !own.own->fits(own.own->meeting.sum()))
        return std::nullopt;
    const PairHit &hit = *own.own;
    const Meeting &m = hit.meeting;
    const Vec2 n = normalized(hit.push2());
    const double closing = dot(hit.came1 - hit.came2, n);
    const double parting = dot(hit.left2 - hit.left1, n);
    const auto masses = ownMasses(hit, own, isElseRight);
    const bool isRebound = std::abs(parting - m.restitution * closing) < 0.05 * closing;
    // Who does neither does something else than what it does in other scenes.
    if (masses || isRebound)
        return isRebound ? masses : std::nullopt;
    // What depends on the step has words of its own.
    const auto isRight = [](const PairHit &h) {
        const PairVelocities in = h.cameParts();
        const PairVelocities out = h.leftParts();
        const double came = in.along1 - in.along2;
        return h.isMet()
               && std::abs(out.along2 - out.along1 - h.meeting.restitution * came) < 1e-3 * came;
    };
    if (own.rebounds.empty() || closing < 1e-6
        || !std::all_of(own.rebounds.begin(), own.rebounds.end(), isRight)
        || steppedDeviation(own, right, true))
        return std::nullopt;
    // An old value is that which the scene has before the program, along every line of centres.
    const double before = hit.stage.preset.restitution;
    const bool isOld = std::abs(parting / closing - before) < 0.05 && own.ownTurned
                       && std::abs(own.ownTurned->rebound() - before) < 0.05;
    const QString seen =
        ResponseText::tr("They met with %1 m/s and parted with %2 m/s, which is e = %3, and "
                         "`restitution` is %4. In %5 hits tried in other scenes they part with e "
                         "times the speed.")
            .arg(brief(closing), brief(parting), brief(parting / closing), brief(m.restitution))
            .arg(own.rebounds.size());
    const QString look =
        isOld ? ResponseText::tr("A copy of e that is made before e is set keeps the old value.")
              : ResponseText::tr("Look at what the answer takes for e there, and at what is asked "
                                 "before it.");
    return responseDeviation(
        ResponseText::tr("In your own scene the hit does not use the e that it has"),
        seen + QLatin1Char(' ') + look, hit, isOld ? Suspect::Copy : Suspect::Formula);
}

} // namespace cradle
