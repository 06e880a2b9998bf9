// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/motion.h"
#include "tasks/judging/likeness.h"
#include "tasks/judging/pair_words.h"
#include "tasks/judging/response_laws.h"
#include "tasks/judging/response_reading.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct ResponseText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

/// Judges how the circles of a program answer a hit.
class ResponseJudge
{
public:
    ResponseJudge(const MeasuredPair &own, const MeasuredPair &right)
        : m_own(own)
        , m_right(right)
    {
    }

    [[nodiscard]] std::vector<LawDeviation> judge()
    {
        ReboundReading rebound = reboundDeviations(m_own, m_right);
        findLaw(rebound.explainsElastic);
        // An answer that never asks for masses or e is one fault, not three.
        if (!isWhole(m_own.radii, m_right.radii) || !isWhole(m_own.densities, m_right.densities)) {
            for (LawDeviation &mass : massDeviations(m_own, m_right))
                m_found.push_back(std::move(mass));
        }
        if (m_isRight && m_own.later && m_right.later && m_own.later->isFirstOdd()) {
            addLateE();
        } else if (!isWhole(m_own.rebounds, m_right.rebounds)) {
            for (LawDeviation &deviation : rebound.deviations)
                m_found.push_back(std::move(deviation));
        }
        if (m_found.empty() || isOnlyMasses(rebound))
            findOwn();
        if (m_found.empty())
            findUnequal();
        if (m_found.empty() && m_isRight)
            findLater();
        if (m_found.empty() && m_isRight)
            findSlow();
        return std::move(m_found);
    }

private:
    void add(const QString &headline, const QString &body, const PairHit &hit,
             Suspect suspect = Suspect::Answer)
    {
        m_found.push_back(responseDeviation(headline, body, hit, suspect));
    }

    /// The hits that two programs had along the same line.
    static std::vector<EqualHit> comparable(const std::vector<PairHit> &own,
                                            const std::vector<PairHit> &right)
    {
        std::vector<EqualHit> hits;
        for (std::size_t i = 0; i < own.size(); ++i) {
            if (own[i].isMet() && right[i].isMet() && own[i].isAligned() && right[i].isAligned())
                hits.push_back({own[i], own[i].cameParts(), right[i].leftParts()});
        }
        return hits;
    }

    /// Whether the law that was found explains these hits, too.
    [[nodiscard]] bool isWhole(const std::vector<PairHit> &own,
                               const std::vector<PairHit> &right) const
    {
        return m_law && (own.empty() || follows(*m_law, comparable(own, right)));
    }

    /// Whether hits of other masses and with other e follow it, too.
    [[nodiscard]] bool holdsEverywhere(const ResponseLaw &law) const
    {
        const auto holds = [&](const std::vector<PairHit> &own, const std::vector<PairHit> &right) {
            const std::vector<EqualHit> hits = comparable(own, right);
            return hits.empty() || follows(law, hits);
        };
        return holds(m_own.radii, m_right.radii) && holds(m_own.densities, m_right.densities)
               && holds(m_own.rebounds, m_right.rebounds);
    }

    /// The answers of equal circles, without losses.
    /// \param explained  what e does explains it
    void findLaw(bool explained)
    {
        const std::vector<EqualHit> hits = comparable(m_own.equals, m_right.equals);
        std::optional<std::size_t> worst;
        double most = 0.0;
        for (std::size_t i = 0; i < m_own.equals.size(); ++i) {
            const PairHit &own = m_own.equals[i];
            const PairHit &right = m_right.equals[i];
            if (!own.isMet() || !right.isMet() || !own.isAligned() || !right.isAligned())
                continue;
            if (isSameAnswer(own.leftParts(), right.leftParts()))
                continue;
            const PairVelocities a = own.leftParts();
            const PairVelocities b = right.leftParts();
            const double off = std::abs(a.along1 - b.along1) + std::abs(a.along2 - b.along2)
                               + std::abs(a.across1 - b.across1) + std::abs(a.across2 - b.across2);
            if (off > most) {
                most = off;
                worst = i;
            }
        }
        m_isRight = !worst;
        if (!worst || hits.empty() || explained)
            return;
        const PairHit &hit = m_own.equals[*worst];
        const PairHit &right = m_right.equals[*worst];
        // Where both should stop, a law of exchange is not what is missed.
        if (std::all_of(hits.begin(), hits.end(), [](const EqualHit &h) {
                return isSameAnswer(h.right, PairVelocities{});
            })) {
            add(ResponseText::tr("A hit does not stop both circles"), describeHit(hit, right), hit);
            return;
        }
        for (const ResponseLaw &law : knownResponses()) {
            if (!follows(law, hits) || (law.isForEvery && !holdsEverywhere(law)))
                continue;
            add(law.headline, describeHit(hit, right) + QLatin1Char(' ') + law.body, hit);
            m_law = law;
            return;
        }
        findParts(hits, hit, right);
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
            return near(out.across1, h.right.across1) && near(out.across2, h.right.across2);
        });
        const bool along = every([&](const EqualHit &h) {
            const PairVelocities out = h.hit.leftParts();
            return near(out.along1, h.right.along1) && near(out.along2, h.right.along2);
        });
        const bool momentum = every([&](const EqualHit &h) {
            return length(h.hit.push1() + h.hit.push2()) < 5e-3 * (1.0 + length(h.hit.push1()));
        });
        const auto ratio = fixedMassRatio(m_own);
        if (along)
            add(ResponseText::tr("The parts across the line of centres are changed"),
                describeHit(hit, right) + QLatin1Char(' ')
                    + ResponseText::tr("A smooth circle pushes along the line of centres only."),
                hit);
        else if (ratio)
            return; // massDeviations() says so
        else if (!momentum)
            add(ResponseText::tr("The pushes on the two circles are not equal and opposite"),
                describeHit(hit, right) + QLatin1Char(' ')
                    + ResponseText::tr("What one circle of the same mass gains, the other loses: "
                                       "else the total momentum changes."),
                hit);
        else if (!across)
            add(ResponseText::tr("The push does not act along the line of centres alone"),
                describeHit(hit, right) + QLatin1Char(' ')
                    + ResponseText::tr("The parts across it must stay as they were."),
                hit);
        else
            add(sizeHeadline(hits), describeHit(hit, right), hit);
        m_found.back().message += otherLine(hits, hit);
        m_found.back().moment.circles = wrongIn(hits);
        if (!along && momentum && !across)
            m_found.back().topic = Topic::Direction;
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

    static QString sizeHeadline(const std::vector<EqualHit> &hits)
    {
        const auto factorOf = [](const EqualHit &h) {
            return (h.hit.leftParts().along1 - h.in.along1) / (h.right.along1 - h.in.along1);
        };
        const double factor = factorOf(hits.front());
        const bool same = std::all_of(hits.begin(), hits.end(), [&](const EqualHit &h) {
            return isAlike(factorOf(h), factor, 0.01);
        });
        return same ? ResponseText::tr("Between equal circles the push is %1 times as large as it "
                                       "should be")
                          .arg(brief(factor))
                    : ResponseText::tr("The push along the line of centres has the wrong size");
    }

    /// The own scene must answer as all others do: else a mass or e was copied before it was set.
    void findOwn()
    {
        const bool isElseRight = m_found.empty();
        if (!m_own.own || !m_isRight || (isElseRight && wrongUnequal().first)
            || !m_own.own->fits(m_own.own->meeting.sum()))
            return;
        const PairHit &hit = *m_own.own;
        const Meeting &m = hit.meeting;
        const auto heavy = massRatio(hit);
        const MassExponents p(m_own);
        if (heavy && (p.radius || p.density)) {
            const double wanted = p.ratioOf(m);
            if (std::abs(*heavy - wanted) > (isHeadOn(hit) ? 1e-5 : 0.02) * wanted) {
                add(ResponseText::tr("The masses in your own scene are not those of its circles"),
                    isElseRight
                        ? ResponseText::tr(
                              "There circle 2 answers as if it were %1 times as heavy as "
                              "circle 1; with its radii %2 and %3 m and densities %4 and %5 "
                              "it is %6 times. Other scenes come out right. A mass that is "
                              "worked out before radius and density are set keeps the old "
                              "value: look at the order in `on_load`.")
                              .arg(motion::figureBeside(*heavy, wanted), brief(m.radius1),
                                   brief(m.radius2), brief(m.density1), brief(m.density2),
                                   motion::figureBeside(wanted, *heavy))
                        : ResponseText::tr(
                              "There circle 2 answers as if it were %1 times as heavy as circle 1; "
                              "as your program does in other scenes, it would be %2 times. A mass "
                              "that is worked out before radius and density are set keeps the old "
                              "value: look at the order in `on_load`.")
                              .arg(motion::figureBeside(*heavy, wanted),
                                   motion::figureBeside(wanted, *heavy)),
                    hit, Suspect::Masses);
                return;
            }
        }
        const Vec2 n = normalized(hit.push2());
        const double closing = dot(hit.came1 - hit.came2, n);
        const double parting = dot(hit.left2 - hit.left1, n);
        if (m_own.rebounds.empty() || closing < 1e-6
            || std::abs(parting / closing - m.restitution) < 0.01)
            return;
        add(ResponseText::tr("In your own scene the hit does not use the e that it has"),
            (isElseRight
                 ? ResponseText::tr("They met with %1 m/s and parted with %2 m/s, which is e = %3, "
                                    "and `restitution` is %4. Other scenes come out right. A copy "
                                    "of e that is made before e is set keeps the old value.")
                 : ResponseText::tr("They met with %1 m/s and parted with %2 m/s, which is e = %3, "
                                    "and `restitution` is %4. In other scenes they part with e "
                                    "times the speed. A copy of e that is made before e is set "
                                    "keeps the old value."))
                .arg(brief(closing), brief(parting), brief(parting / closing),
                     brief(m.restitution)),
            hit, Suspect::Copy);
    }

    /// Whether all that was found is that masses grow with other powers, and e is used as it should
    /// be.
    [[nodiscard]] bool isOnlyMasses(const ReboundReading &rebound) const
    {
        const MassExponents p(m_own);
        const auto isPower = [](double q) {
            return q > 0.4 && std::abs(2.0 * q - std::round(2.0 * q)) < 0.04;
        };
        return m_isRight && !m_law && rebound.deviations.empty() && p.radius && isPower(*p.radius)
               && (m_own.densities.empty() || (p.density && isPower(*p.density)))
               && std::all_of(m_found.begin(), m_found.end(), [](const LawDeviation &found) {
                      return found.suspect == Suspect::Masses;
                  });
    }

    /// What is remembered of a hit shows in the next.
    void findLater()
    {
        if (!m_own.later || !m_right.later)
            return;
        const PairHit &one = m_own.later->first;
        const PairHit &two = m_own.later->second;
        const Vec2 n1 = normalized(one.push2());
        const Vec2 n2 = normalized(two.push2());
        const auto off = [](Vec2 n, const PairHit &hit) {
            return std::min(std::abs(cross(n, hit.normal)), std::abs(cross(n, hit.nextNormal)));
        };
        if (off(n1, one) < 0.1 && off(n2, two) > 0.15 && length(n2 - n1) < 1e-3) {
            const auto degrees = [](Vec2 n) {
                return brief(std::atan2(n.y, n.x) * 180.0 / std::numbers::pi);
            };
            add(ResponseText::tr("A later hit is answered along the line of an earlier one"),
                ResponseText::tr("Two circles met with their line of centres at %1°, and again, "
                                 "back from a wall, with it at %2°. Both times they were pushed "
                                 "along %3°. Every hit has a normal of its own: work it out anew.")
                    .arg(degrees(one.normal), degrees(two.normal), degrees(n2)),
                two, Suspect::Kept);
            return;
        }
        const double e = one.meeting.restitution;
        const double first = one.rebound();
        const double second = two.rebound();
        if (off(n1, one) < 0.1 && off(n2, two) < 0.1 && std::abs(first - e) < 0.01
            && std::abs(second - e) > 0.03)
            add(ResponseText::tr("A later hit is answered with another e"),
                ResponseText::tr("With e = %1 two circles parted with %2 times the speed that they "
                                 "met with; in their second hit, back from a wall, it was %3 "
                                 "times. Look at what your program keeps from one hit to the next.")
                    .arg(brief(e), brief(first), brief(second)),
                two, Suspect::Kept);
    }

    /// What a program takes for e before its first hit is not what it takes after.
    void addLateE()
    {
        const PairHit &one = m_own.later->first;
        add(ResponseText::tr("e acts only after the first hit"),
            ResponseText::tr("With e = %1 two circles parted with %2 times the speed that they met "
                             "with; in their second hit, back from a wall, it was %3 times. Look "
                             "at when your answer learns what e is: that comes too late.")
                .arg(brief(one.meeting.restitution), brief(one.rebound()),
                     brief(m_own.later->second.rebound())),
            one, Suspect::Kept);
    }

    /// What a hit made, in units of the speed with which they came nearer: how a slow one differs
    /// is small beside 1 m/s.
    static PairVelocities inUnits(const PairHit &hit)
    {
        const PairVelocities left = hit.leftParts();
        const double unit = 1.0 / hit.meeting.closing();
        return {unit * left.along1, unit * left.across1, unit * left.along2, unit * left.across2};
    }

    /// What is right between fast circles may be another law between slow ones.
    void findSlow()
    {
        if (!m_own.slow || !m_right.slow || !m_own.slow->isMet() || !m_own.slow->isAligned()
            || !m_right.slow->isMet() || isSameAnswer(inUnits(*m_own.slow), inUnits(*m_right.slow)))
            return;
        const PairHit &hit = *m_own.slow;
        const double closing = m_own.equals.front().meeting.closing();
        add(ResponseText::tr("Circles that meet slowly are answered in another way"),
            ResponseText::tr("With e = %1: ").arg(brief(hit.meeting.restitution))
                + describeHit(hit, *m_right.slow) + QLatin1Char(' ')
                + ResponseText::tr("Where they meet with %1 m/s, it comes out right. The law is "
                                   "the same for every speed.")
                      .arg(brief(hit.slowness * closing)),
            hit, Suspect::Formula);
    }

    /// A hit of unequal circles that does not come out right, and how it should; null if none.
    [[nodiscard]] std::pair<const PairHit *, const PairHit *> wrongUnequal() const
    {
        for (const auto &[own, right] : {std::pair(&m_own.radii, &m_right.radii),
                                         std::pair(&m_own.densities, &m_right.densities)}) {
            for (std::size_t i = 0; i < own->size(); ++i) {
                const PairHit &hit = (*own)[i];
                const PairHit &good = (*right)[i];
                if (hit.answered && good.answered && hit.isAligned() && good.isAligned()
                    && !isSameAnswer(hit.leftParts(), good.leftParts()))
                    return {&hit, &good};
            }
        }
        return {nullptr, nullptr};
    }

    /// Equal circles come out right, unequal ones do not, in a way that no mass explains.
    void findUnequal()
    {
        const auto [hit, good] = wrongUnequal();
        if (!m_isRight || !hit)
            return;
        const Meeting &m = hit->meeting;
        const bool isLossy = m.restitution != m_own.equals.front().meeting.restitution;
        add(isLossy ? ResponseText::tr("With e = %1 a hit does not come out right")
                          .arg(brief(m.restitution))
                    : ResponseText::tr("Equal circles answer rightly, unequal ones do not"),
            ResponseText::tr("With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4, e = %5: ")
                    .arg(brief(m.radius1), brief(m.radius2), brief(m.density1), brief(m.density2),
                         brief(m.restitution))
                + describeHit(*hit, *good),
            *hit);
    }

    const MeasuredPair &m_own;
    const MeasuredPair &m_right;
    std::vector<LawDeviation> m_found;
    std::optional<ResponseLaw> m_law{}; ///< that equal circles follow, if it is a wrong one
    bool m_isRight = true;              ///< equal circles answer as they should, without losses
};

} // namespace

LawDeviation responseDeviation(const QString &headline, const QString &body, const PairHit &hit,
                               Suspect suspect)
{
    return {Aspect::Response,
            headline + QStringLiteral("\n\n") + body,
            {hit.stage, std::max<qint64>(hit.step, 1), {0, 1}, false},
            suspect};
}

QString describeHit(const PairHit &hit, const PairHit &right)
{
    const PairVelocities in = hit.cameParts();
    const PairVelocities out = hit.leftParts();
    const PairVelocities good = right.leftParts();
    // The line of centres turns a little in a step: what that makes is no part of a velocity.
    const double blur = 2e-3 * std::max(length(hit.came1), length(hit.came2));
    const auto seen = [&](double part) {
        for (const double known :
             {0.0, in.along1, in.across1, in.along2, in.across2, good.along1, good.along2}) {
            if (std::abs(part - known) < blur)
                return known;
        }
        return part;
    };
    const auto pair = [&](double along, double across) {
        return ResponseText::tr("%1 along, %2 across")
            .arg(brief(hit.slowness * seen(along)), brief(hit.slowness * seen(across)));
    };
    return ResponseText::tr(
               "Velocities in m/s along the line of centres (from 1 to 2) and across it: circle 1 "
               "came with %1, circle 2 with %2; they left with %3 and with %4; right is %5 and "
               "%6.")
        .arg(pair(in.along1, in.across1), pair(in.along2, in.across2),
             pair(out.along1, out.across1), pair(out.along2, out.across2),
             pair(good.along1, good.across1), pair(good.along2, good.across2));
}

std::vector<LawDeviation> responseDeviations(const MeasuredPair &own, const MeasuredPair &right,
                                             const Ground &ground)
{
    const auto answered = [](const PairHit &hit) { return hit.isMet(); };
    if (!own.isJudged || !right.isJudged || !ground.pair.asked
        || (std::none_of(own.equals.begin(), own.equals.end(), answered)
            && std::none_of(own.rebounds.begin(), own.rebounds.end(), answered)))
        return {};
    return ResponseJudge(own, right).judge();
}

} // namespace cradle
