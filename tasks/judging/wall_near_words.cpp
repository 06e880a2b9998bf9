// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/brief_beside.h"
#include "tasks/judging/wall_comparison.h"

namespace cradle {

namespace {

/// Judges the steps before a hit at a wall and after it, which should be those of free flight.
class NearJudge : WallComparison
{
public:
    explicit NearJudge(const WallComparison &walls)
        : WallComparison(walls)
    {
    }

    [[nodiscard]] std::vector<LawDeviation> before() const
    {
        return told(&WallHit::near, [this](const WallHit &hit, const Whose &whose) {
            const WallStep &seen = *hit.near;
            const bool isTurn = length(seen.now.velocity - seen.free.velocity)
                                > 1e-6 * (1.0 + length(seen.free.velocity));
            const Vec2 is = isTurn ? seen.now.velocity : seen.now.position - seen.was.position;
            const Vec2 asked = isTurn ? seen.free.velocity : seen.free.position - seen.was.position;
            const QString text =
                isTurn ? WallText::tr("With its rim %1 m from the %2 and %3 m/s, circle %4 had %5 "
                                      "m/s one step of %6 s later; in free flight it has %7 m/s.")
                       : WallText::tr("With its rim %1 m from the %2 and %3 m/s, circle %4 went %5 "
                                      "m in a step of %6 s; in free flight it goes %7 m.");
            const double room = hit.stage.preset.halfWidth - seen.was.radius
                                - dot(outwardNormal(hit.wall), seen.was.position);
            return deviation(
                WallText::tr("Near the %walls the steps of %who are made in another way"),
                text.arg(brief(room), motion::wallName(hit.wall), brief(seen.was.velocity))
                        .arg(hit.circle + 1)
                        .arg(briefBeside(is, asked), briefTimestep(hit.stage.preset.timestep),
                             briefBeside(asked, is))
                    + QLatin1Char(' ')
                    + WallText::tr("Look at what your program asks there before its rim is at the "
                                   "wall."),
                at(hit, seen), whose, Suspect::Question, !isTurn);
        });
    }

    [[nodiscard]] std::vector<LawDeviation> after() const
    {
        return told(&WallHit::unchanged, [this](const WallHit &hit, const Whose &whose) {
            const WallStep &seen = *hit.unchanged;
            const Vec2 is = seen.now.position - seen.was.position;
            const Vec2 asked = seen.free.position - seen.was.position;
            return deviation(
                WallText::tr("After hits at the %walls the way of %who is not v Δt"),
                WallText::tr("Turned round at the %1, circle %2 has %3 m/s; in the next step of "
                             "%4 s it went %5 m, and by that velocity it is %6 m.")
                        .arg(motion::wallName(hit.wall))
                        .arg(hit.circle + 1)
                        .arg(brief(seen.was.velocity), briefTimestep(hit.stage.preset.timestep),
                             briefBeside(is, asked), briefBeside(asked, is))
                    + QLatin1Char(' ') + whyUnchanged(hit),
                at(hit, seen), whose, Suspect::Kept, true);
        });
    }

private:
    /// What is kept of the steps before has a part in it only if a run that begins with that step
    /// makes another one.
    static QString whyUnchanged(const WallHit &hit)
    {
        return hit.isAnewSo
                   ? WallText::tr("So it goes in a run that begins there, too: look at what your "
                                  "program does with a circle that is at a wall and moves away "
                                  "from it.")
                   : WallText::tr(
                       "A velocity or an old place that your program keeps in a variable "
                       "of its own must change at a hit, too.");
    }
    static WallHit at(WallHit hit, const WallStep &seen)
    {
        hit.step = seen.step;
        return hit;
    }

    /// What is said of all hits with such a step where the reference has none.
    template <class Say>
    [[nodiscard]] std::vector<LawDeviation> told(std::optional<WallStep> WallHit::*part,
                                                 Say say) const
    {
        const auto isOdd = [&](std::size_t i) {
            // Who is put further out, or past another wall, has yet to come back: told of where it
            // was put.
            const WallHit &hit = m_own.hits[i];
            return hit.*part && !(rightOf(i).*part) && !hit.kicks && !hit.isPutOut()
                   && !hit.isLeap();
        };
        std::vector<LawDeviation> found;
        for (const Whose &each : whose(isOdd)) {
            std::size_t first = 0;
            while (!isOdd(first) || m_own.hits[first].circle != each.circles.front())
                ++first;
            found.push_back(say(m_own.hits[first], each));
            found.back().family = QStringLiteral("near");
        }
        return found;
    }
};

} // namespace

std::vector<LawDeviation> nearDeviations(const WallComparison &walls)
{
    return NearJudge(walls).before();
}

std::vector<LawDeviation> unchangedDeviations(const WallComparison &walls)
{
    return NearJudge(walls).after();
}

} // namespace cradle
