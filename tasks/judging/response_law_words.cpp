// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_law_words.h"

#include "tasks/judging/likeness.h"
#include "tasks/judging/response_reading.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Judges how equal circles answer a hit without losses.
class EqualJudge
{
public:
    EqualJudge(const MeasuredPair &own, const MeasuredPair &right)
        : m_own(own)
        , m_right(right)
    {
    }

    [[nodiscard]] EqualReading read(bool isExplained)
    {
        findLaw(isExplained);
        return std::move(m_reading);
    }

private:
    void add(const QString &headline, const QString &body, const PairHit &hit)
    {
        m_reading.said = responseDeviation(headline, body, hit);
    }

    /// The numbers of a hit, and of what circles it is.
    [[nodiscard]] QString describeEquals(const PairHit &hit, const PairHit &right) const
    {
        const QString what = m_own.rebounds.empty()
                                 ? ResponseText::tr("Here two circles of the same mass meet. ")
                                 : ResponseText::tr("Here two circles of the same mass meet, with "
                                                    "e = %1. ")
                                       .arg(brief(hit.meeting.restitution));
        return what + describeHit(hit, right);
    }

    /// Whether hits of other masses and with other e follow it, too.
    [[nodiscard]] bool holdsEverywhere(const ResponseLaw &law) const
    {
        const auto holds = [&](const std::vector<PairHit> &own, const std::vector<PairHit> &right) {
            const std::vector<EqualHit> hits = comparableHits(own, right);
            return hits.empty() || follows(law, hits);
        };
        return holds(m_own.radii, m_right.radii) && holds(m_own.densities, m_right.densities)
               && holds(m_own.rebounds, m_right.rebounds);
    }

    /// Whether two equal circles of another size follow it, too: one size fits many a factor.
    [[nodiscard]] bool holdsForSizes(const ResponseLaw &law) const
    {
        std::vector<EqualHit> hits;
        for (const EqualHit &one : comparableHits(m_own.radii, m_right.radii)) {
            const Meeting &m = one.hit.meeting;
            if (m.radius1 == m.radius2 && m.density1 == m.density2)
                hits.push_back(one);
        }
        if (m_own.larger && m_right.larger && m_own.larger->isMet() && m_own.larger->isAligned()
            && m_right.larger->isMet())
            hits.push_back({*m_own.larger, m_own.larger->cameParts(), m_right.larger->leftParts()});
        return hits.empty() || follows(law, hits);
    }

    void findLaw(bool explained)
    {
        const std::vector<EqualHit> hits = comparableHits(m_own.equals, m_right.equals);
        std::optional<std::size_t> worst;
        double most = 0.0;
        for (std::size_t i = 0; i < m_own.equals.size(); ++i) {
            const PairHit &own = m_own.equals[i];
            const PairHit &right = m_right.equals[i];
            if (!own.isMet() || !right.isMet() || !own.isAligned() || !right.isAligned())
                continue;
            const PairVelocities a = own.leftParts();
            const PairVelocities b = rightFor(own.cameParts(), right);
            if (isSameAnswer(a, b))
                continue;
            const double off = std::abs(a.along1 - b.along1) + std::abs(a.along2 - b.along2)
                               + std::abs(a.across1 - b.across1) + std::abs(a.across2 - b.across2);
            if (off > most) {
                most = off;
                worst = i;
            }
        }
        m_reading.isRight = !worst;
        if (!worst || hits.empty() || explained)
            return;
        const PairHit &hit = m_own.equals[*worst];
        const PairHit &right = m_right.equals[*worst];
        // Where both should stop, a law of exchange is not what is missed.
        if (std::all_of(hits.begin(), hits.end(), [](const EqualHit &h) {
                return isSameAnswer(h.right, PairVelocities{});
            })) {
            findStops(hits, hit);
            return;
        }
        for (const ResponseLaw &law : knownResponses()) {
            if (!follows(law, hits) || !holdsForSizes(law)
                || (law.isForEvery && !holdsEverywhere(law)))
                continue;
            add(law.headline, describeEquals(hit, right) + QLatin1Char(' ') + law.body, hit);
            m_reading.law = law;
            if (law.isOfE && !follows(law, comparableHits(m_own.rebounds, m_right.rebounds)))
                limitToE(hit);
            return;
        }
        m_reading.said = constantDeviation(m_own, hits, hit);
        if (!m_reading.said)
            findParts(hits, hit, right);
    }

    /// What is not so with another e is told of the one that was tried.
    void limitToE(const PairHit &hit)
    {
        QString &message = m_reading.said->message;
        const qsizetype end = message.indexOf(QLatin1Char('\n'));
        if (m_own.rebounds.empty())
            return;
        message = ResponseText::tr("%1 (with e = %2)")
                      .arg(message.left(end), brief(hit.meeting.restitution))
                  + message.mid(end);
        m_reading.said->isOfSome = true;
    }

    /// Both should stop, and do not always.
    void findStops(const std::vector<EqualHit> &hits, const PairHit &hit)
    {
        const auto every = [&](auto &&holds) {
            return std::all_of(hits.begin(), hits.end(),
                               [&](const EqualHit &h) { return holds(h.hit); });
        };
        const auto rests = [](Vec2 velocity) { return length(velocity) < 5e-3; };
        for (const auto &[part, headline] :
             {std::pair(Vec2{1.0, 0.0}, ResponseText::tr("A hit stops the x parts alone")),
              std::pair(Vec2{0.0, 1.0}, ResponseText::tr("A hit stops the y parts alone"))}) {
            const Vec2 kept = perpendicular(part);
            if (every([&](const PairHit &one) {
                    return length(one.left1 - dot(one.came1, kept) * kept) < 5e-3
                           && length(one.left2 - dot(one.came2, kept) * kept) < 5e-3;
                })) {
                add(headline,
                    describeStops(hit) + QLatin1Char(' ')
                        + ResponseText::tr("Both parts of a velocity have to become 0."),
                    hit);
                return;
            }
        }
        const bool isNever =
            every([&](const PairHit &one) { return !rests(one.left1) && !rests(one.left2); });
        // More than a remainder of what it came with.
        const auto goesOn = [](Vec2 came, Vec2 left) {
            return length(left) >= 0.05 * length(came);
        };
        const bool stops1 = every(
            [&](const PairHit &one) { return rests(one.left1) && goesOn(one.came2, one.left2); });
        const bool stops2 = every(
            [&](const PairHit &one) { return rests(one.left2) && goesOn(one.came1, one.left1); });
        add(stops1    ? ResponseText::tr("A hit stops circle 1 and not circle 2")
            : stops2  ? ResponseText::tr("A hit stops circle 2 and not circle 1")
            : isNever ? ResponseText::tr("The circles do not stop in a hit")
                      : ResponseText::tr("Not every hit stops both circles"),
            describeStops(hit) + QLatin1Char(' ') + ResponseText::tr("A hit has to stop both."),
            hit);
        m_reading.said->isOfSome = !isNever;
    }

    static QString describeStops(const PairHit &hit)
    {
        return ResponseText::tr("Circle 1 came with %1 m/s and left with %2 m/s, circle 2 came "
                                "with %3 m/s and left with %4 m/s.")
            .arg(brief(hit.slowness * hit.came1), brief(hit.slowness * hit.left1),
                 brief(hit.slowness * hit.came2), brief(hit.slowness * hit.left2));
    }

    /// No law that is known: which of the things that a hit keeps does it not keep?
    void findParts(const std::vector<EqualHit> &hits, const PairHit &hit, const PairHit &right)
    {
        const auto every = [&](auto &&holds) {
            return std::all_of(hits.begin(), hits.end(), holds);
        };
        const auto near = [](double a, double b) { return isAlike(a, b, 5e-3); };
        const bool across = every([&](const EqualHit &h) {
            const PairVelocities out = h.hit.leftParts();
            // A line of centres that has turned a little turns a push that is much too strong.
            const double turned = 1e-3 * length(h.hit.push1());
            return isAlike(out.across1, h.right.across1, 5e-3 + turned)
                   && isAlike(out.across2, h.right.across2, 5e-3 + turned);
        });
        const bool along = every([&](const EqualHit &h) {
            const PairVelocities out = h.hit.leftParts();
            return near(out.along1, h.right.along1) && near(out.along2, h.right.along2);
        });
        const bool momentum = every([&](const EqualHit &h) {
            return length(h.hit.push1() + h.hit.push2()) < 5e-3 * (1.0 + length(h.hit.push1()));
        });
        const auto ratio = fixedMassRatio(m_own);
        const auto keeps = [&](double PairVelocities::*part) {
            return every(
                [&](const EqualHit &h) { return near(h.hit.leftParts().*part, h.right.*part); });
        };
        if (along) {
            const bool isFirstKept = keeps(&PairVelocities::across1);
            const bool isOfBoth = !isFirstKept && !keeps(&PairVelocities::across2);
            add(isOfBoth ? ResponseText::tr("The parts across the line of centres are changed")
                         : ResponseText::tr("Circle %1 does not keep its part across in a hit")
                               .arg(isFirstKept ? 2 : 1),
                describeEquals(hit, right) + QLatin1Char(' ')
                    + ResponseText::tr("A smooth circle pushes along the line of centres only."),
                hit);
            if (isOfBoth)
                m_reading.said->topic = Topic::Across;
        } else if (ratio)
            return; // massDeviations() says so
        else if (const std::vector<int> wrong = wrongIn(hits); !momentum && wrong.size() == 1)
            add(m_own.radii.empty() && m_own.densities.empty()
                    ? ResponseText::tr("Only circle %1 leaves a hit as it should")
                          .arg(2 - wrong.front())
                    : ResponseText::tr("Of two equal circles only circle %1 leaves as it should")
                          .arg(2 - wrong.front()),
                describeEquals(hit, right) + lawOfPart(hits, wrong.front()), hit);
        else if (!momentum) {
            add(ResponseText::tr("The two pushes are not equal and opposite"),
                describeEquals(hit, right) + QLatin1Char(' ')
                    + ResponseText::tr("What one circle of the same mass gains, the other loses: "
                                       "else the total momentum changes."),
                hit);
            m_reading.said->topic = Topic::Momentum;
        } else if (!across)
            add(ResponseText::tr("The push is not along the line of centres"),
                describeEquals(hit, right) + QLatin1Char(' ')
                    + ResponseText::tr("The parts across it must stay as they were."),
                hit);
        else {
            const SizeOfPush size = sizeOfPush(m_own, m_right, hit, right);
            add(size.headline, describeEquals(hit, right) + size.seen, hit);
            if (size.isRounded)
                m_reading.said->topic = Topic::Rounding;
            if (!size.isOfEveryE)
                limitToE(hit);
        }
        m_reading.said->message += otherLine(hits, hit);
        m_reading.said->moment.circles = wrongIn(hits);
        if (!along && momentum && !across)
            m_reading.said->topic = Topic::Direction;
    }

    /// The circles that do not leave every hit as they should, from 0.
    static std::vector<int> wrongIn(const std::vector<EqualHit> &hits)
    {
        std::vector<int> wrong;
        for (const int circle : {0, 1}) {
            const auto isRight = [&](const EqualHit &h) {
                PairVelocities out = h.hit.leftParts();
                (circle == 0 ? out.along2 : out.along1) =
                    circle == 0 ? h.right.along2 : h.right.along1;
                (circle == 0 ? out.across2 : out.across1) =
                    circle == 0 ? h.right.across2 : h.right.across1;
                return isSameAnswer(out, h.right);
            };
            if (!std::all_of(hits.begin(), hits.end(), isRight))
                wrong.push_back(circle);
        }
        return wrong;
    }

    /// Of a hit that comes out wrong, where along another line of centres all come out right.
    static QString otherLine(const std::vector<EqualHit> &hits, const PairHit &hit)
    {
        const auto isThere = [&](const EqualHit &h) {
            return h.hit.meeting.degrees == hit.meeting.degrees;
        };
        const auto other = std::find_if_not(hits.begin(), hits.end(), isThere);
        if (other == hits.end() || !std::all_of(hits.begin(), hits.end(), [&](const EqualHit &h) {
                return isThere(h) != isSameAnswer(h.hit.leftParts(), h.right);
            }))
            return {};
        return QLatin1Char(' ')
               + ResponseText::tr("Here the line of centres was at %1°; with %2° the hits come out "
                                  "right.")
                     .arg(brief(hit.meeting.degrees), brief(other->hit.meeting.degrees));
    }

    const MeasuredPair &m_own;
    const MeasuredPair &m_right;
    EqualReading m_reading;
};

} // namespace

EqualReading equalReading(const MeasuredPair &own, const MeasuredPair &right, bool isExplained)
{
    return EqualJudge(own, right).read(isExplained);
}

} // namespace cradle
