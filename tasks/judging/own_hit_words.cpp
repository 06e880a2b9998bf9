// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/figures.h"
#include "tasks/judging/response_law_words.h"
#include "tasks/judging/response_reading.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

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
    return responseDeviation(
        ResponseText::tr("The masses in your own scene are not those of its circles"),
        isElseRight
            ? ResponseText::tr("There circle 2 answers as if it were %1 times as heavy as "
                               "circle 1; with its radii %2 and %3 m and densities %4 and %5 "
                               "it is %6 times. In other scenes the masses come out right. A mass "
                               "that is worked out before radius and density are set keeps the "
                               "old value: look at the order in `on_load`.")
                  .arg(motion::figureBeside(*heavy, wanted), brief(m.radius1), brief(m.radius2),
                       brief(m.density1), brief(m.density2), motion::figureBeside(wanted, *heavy))
            : ResponseText::tr(
                  "There circle 2 answers as if it were %1 times as heavy as circle 1; "
                  "as your program does in other scenes, it would be %2 times. A mass "
                  "that is worked out before radius and density are set keeps the old "
                  "value: look at the order in `on_load`.")
                  .arg(motion::figureBeside(*heavy, wanted), motion::figureBeside(wanted, *heavy)),
        hit, Suspect::Masses);
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
    // An old value is that which the scene has before the program.
    const bool isOld = std::abs(parting / closing - hit.stage.preset.restitution) < 0.05;
    const QString seen =
        isOld
            ? ResponseText::tr("They met with %1 m/s and parted with %2 m/s, which is e = %3, and "
                               "`restitution` is %4. In other scenes they part with e times the "
                               "speed. A copy of e that is made before e is set keeps the old "
                               "value.")
            : ResponseText::tr("They met with %1 m/s and parted with %2 m/s, which is e = %3, and "
                               "`restitution` is %4. In other scenes they part with e times the "
                               "speed. Look at what the answer takes for e there, and at what is "
                               "asked before it.");
    return responseDeviation(
        ResponseText::tr("In your own scene the hit does not use the e that it has"),
        seen.arg(brief(closing), brief(parting), brief(parting / closing), brief(m.restitution)),
        hit, isOld ? Suspect::Copy : Suspect::Formula);
}

} // namespace cradle
