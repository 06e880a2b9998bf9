// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/rebound_laws.h"
#include "tasks/judging/response_law_words.h"
#include "tasks/judging/response_reading.h"

#include <algorithm>

namespace cradle {

namespace {

constexpr auto eItself = [](double e) { return e; }; ///< what is right

/// Reads what e does from hits with several of its values.
class ReboundJudge
{
public:
    ReboundJudge(const MeasuredPair &own, const MeasuredPair &right)
        : m_own(own)
        , m_right(right)
    {
        // Whose masses are wrong has been said; they share the push by those.
        const double heavy = fixedMassRatio(own).value_or(1.0);
        for (const PairHit &hit : own.rebounds)
            m_all.push_back(reboundOf(hit, heavy));
        for (const PairHit &hit : own.equals)
            m_elastic.push_back(reboundOf(hit, heavy));
    }

    [[nodiscard]] ReboundReading read()
    {
        const auto answered = [](const PairHit &hit) { return hit.isMet() && hit.isAligned(); };
        if (m_all.empty() || m_elastic.empty()
            || std::none_of(m_own.rebounds.begin(), m_own.rebounds.end(), answered))
            return {};
        m_shown = mostWrong([](const PairHit &own, const PairHit &right) {
            return length(own.left1 - right.left1) + length(own.left2 - right.left2);
        });
        const auto one = [](double) { return 1.0; };
        m_isElastic = followEach(m_elastic, &Rebound::first, one)
                      && followEach(m_elastic, &Rebound::second, one);
        findAcross();
        if (!m_isDone)
            findAlong();
        return std::move(m_reading);
    }

private:
    /// The hit that differs most from the right one, by \p difference.
    template <class Difference>
    [[nodiscard]] std::size_t mostWrong(Difference difference) const
    {
        std::size_t worst = 0;
        double most = -1.0;
        for (std::size_t i = 0; i < m_own.rebounds.size(); ++i) {
            const PairHit &own = m_own.rebounds[i];
            const PairHit &right = m_right.rebounds[i];
            const double off = difference(own, right);
            if (own.isMet() && off > most) {
                most = off;
                worst = i;
            }
        }
        return worst;
    }

    /// Whether \p law holds for both circles, also where e is 1.
    template <class First, class Second>
    [[nodiscard]] bool isLaw(First first, Second second) const
    {
        return followEach(m_all, &Rebound::first, first)
               && followEach(m_all, &Rebound::second, second)
               && followEach(m_elastic, &Rebound::first, first)
               && followEach(m_elastic, &Rebound::second, second);
    }

    void add(const QString &headline, const QString &why = {})
    {
        const PairHit &hit = m_own.rebounds[m_shown];
        const QString what =
            ReboundText::tr("With e = %1: ").arg(brief(hit.meeting.restitution))
            + describeHit(hit, m_right.rebounds[m_shown], !m_reading.deviations.empty());
        m_reading.deviations.push_back(responseDeviation(
            headline, why.isEmpty() ? what : what + QLatin1Char(' ') + why, hit, Suspect::Formula));
        m_reading.deviations.back().topic = Topic::Restitution;
    }

    void findAcross()
    {
        const auto kept = [](double) { return 1.0; };
        const bool one = followEach(m_all, &Rebound::across1, eItself);
        const bool two = followEach(m_all, &Rebound::across2, eItself);
        if (!m_isElastic || (!one && !two))
            return;
        if (one != two) {
            const int circle = one ? 0 : 1;
            if (isTimesE(circle, m_own, m_right)) {
                add(ReboundText::tr("e multiplies the whole velocity of circle %1 after the hit")
                        .arg(circle + 1),
                    ReboundText::tr("e belongs to the rebound along the line of centres alone."));
                m_isDone = followEach(m_all, one ? &Rebound::second : &Rebound::first, eItself);
            } else if (followEach(m_all, one ? &Rebound::across2 : &Rebound::across1, kept))
                add(ReboundText::tr("e also shortens the part of circle %1 across the line of "
                                    "centres")
                        .arg(circle + 1),
                    ReboundText::tr("Nothing pushes there: it stays as it was."));
            return;
        }
        if (followEach(m_all, &Rebound::sum, eItself)) {
            add(ReboundText::tr("e multiplies the whole velocities after the hit"),
                ReboundText::tr("e belongs to the rebound along the line of centres alone; the "
                                "total momentum stays."));
            m_isDone = true;
            return;
        }
        add(ReboundText::tr("e also shortens the parts across the line of centres"),
            ReboundText::tr("Nothing pushes there: they stay as they were."));
    }

    void findAlong()
    {
        const auto one = [](double) { return 1.0; };
        if (isLaw(eItself, eItself))
            return;
        // A fault across must not choose a hit at which the parts along come out right.
        m_shown = mostWrong([](const PairHit &own, const PairHit &right) {
            const PairVelocities a = own.leftParts();
            const PairVelocities b = right.leftParts();
            return std::abs(a.along1 - b.along1) + std::abs(a.along2 - b.along2);
        });
        if (isLaw(eItself, one))
            return add(ReboundText::tr("Along the normal only circle 1 feels e"));
        if (isLaw(one, eItself))
            return add(ReboundText::tr("Along the normal only circle 2 feels e"));
        if (findWholePart() || findFactor())
            return;
        findNumbers();
    }

    /// The new part along the line of centres is multiplied by e, with what both have in common.
    bool findWholePart()
    {
        const bool one = isTimesE(0, m_own, m_right);
        const bool two = isTimesE(1, m_own, m_right);
        if (!m_isElastic || (!one && !two) || (!one && !followEach(m_all, &Rebound::first, eItself))
            || (!two && !followEach(m_all, &Rebound::second, eItself)))
            return false;
        add(one && two
                ? ReboundText::tr("e multiplies both whole new parts")
                : ReboundText::tr("e multiplies the whole new part of circle %1").arg(one ? 1 : 2),
            ReboundText::tr("e belongs to the rebound along the line of centres alone; the "
                            "total momentum stays."));
        return true;
    }

    bool findFactor()
    {
        for (const FactorLaw &law : factorLaws()) {
            const bool one = isLaw(law.rebound, eItself);
            const bool two = isLaw(eItself, law.rebound);
            if (!one && !two && !isLaw(law.rebound, law.rebound))
                continue;
            if (one != two && !isOfMasses(law.rebound, one ? 1 : 2, m_own, m_right)) {
                add(ReboundText::tr("Of two equal circles only circle %1 leaves as it should")
                        .arg(one ? 2 : 1));
                m_reading.explainsElastic = !m_isElastic;
                return true;
            }
            add(one || two ? ReboundText::tr("%1, for circle %2 alone")
                                 .arg(law.headline, QString::number(one ? 1 : 2))
                           : law.headline);
            m_reading.explainsElastic = !m_isElastic;
            return true;
        }
        return findLine();
    }

    bool findLine()
    {
        const auto push = lineOfPush(m_own, m_all, m_elastic);
        if (!push)
            return false;
        add(pushHeadline(*push));
        m_reading.explainsElastic = !m_isElastic;
        return true;
    }

    /// What no other law tells. They may part as fast as they should: that is the mean of both.
    void addOdd()
    {
        if (auto unanswered = m_isElastic ? unansweredRebound(m_own, m_right) : std::nullopt) {
            m_reading.deviations.push_back(std::move(*unanswered));
            return;
        }
        // Whoever is hit again while they part has more than one answer in it.
        if (m_own.twice && !m_right.twice)
            return;
        const bool isRebound = std::all_of(m_all.begin(), m_all.end(), [](const Rebound &r) {
            return std::abs(0.5 * (r.first + r.second) - r.e) < reboundBlur;
        });
        if (isRebound)
            add(ReboundText::tr("e acts on more than the rebound"),
                ReboundText::tr("The circles part e times as fast as they met, as they should; but "
                                "what both have together, their momentum, changes, too."));
        else
            add(ReboundText::tr("e does not act on the rebound as it should"), rightOnes());
    }

    /// With which e it comes out right; empty if with none of those below 1.
    [[nodiscard]] QString rightOnes() const
    {
        QStringList all;
        for (const Rebound &r : m_all) {
            if (std::abs(r.first - r.e) < reboundBlur && std::abs(r.second - r.e) < reboundBlur)
                all.append(brief(r.e));
        }
        return all.isEmpty() ? QString()
                             : ReboundText::tr("With e = %1 it comes out right.")
                                   .arg(all.join(QStringLiteral(", ")));
    }

    /// Whether each keeps its velocity with e = 1, and they part with no other e either.
    [[nodiscard]] bool isApproach() const
    {
        const auto none = [](double) { return -1.0; };
        return followEach(m_elastic, &Rebound::first, none)
               && followEach(m_elastic, &Rebound::second, none)
               && m_all[m_shown].first < -5.0 * reboundBlur
               && std::all_of(m_all.begin(), m_all.end(), [](const Rebound &r) {
                      return r.first < reboundBlur && std::abs(r.first - r.second) < reboundBlur;
                  });
    }

    void findNumbers()
    {
        const auto kept = [](double) { return 1.0; };
        const bool across = followEach(m_all, &Rebound::across1, kept)
                            && followEach(m_all, &Rebound::across2, kept)
                            && followEach(m_elastic, &Rebound::across1, kept)
                            && followEach(m_elastic, &Rebound::across2, kept);
        const double first = m_all.front().first;
        const double second = m_all.front().second;
        const auto fixed = [](double value) { return [value](double) { return value; }; };
        const bool isNear = across && isApproach();
        if (!isNear && (m_all.size() < 2 || !across || !isLaw(fixed(first), fixed(second)))) {
            // What is wrong already where e is 1 has been named; it hides what e does.
            if (m_isElastic)
                addOdd();
            return;
        }
        const auto number = [](double value) { return brief(std::round(value * 100.0) / 100.0); };
        if (std::abs(first - second) < reboundBlur) {
            // A law without any rebound is one of its own.
            if (!isNear && std::abs(first) < reboundBlur)
                return;
            if (isNear || first < -reboundBlur)
                add(ReboundText::tr("After a hit the circles still run into each other"),
                    faintPush(m_own.rebounds[m_shown]));
            else if (first > 1.0 + reboundBlur)
                add(ReboundText::tr("After a hit the circles part faster than they met"));
            else if (m_own.own && m_own.own->isMet()
                     && std::abs(m_own.own->rebound() - first) > 3.0 * reboundBlur)
                addOdd();
            else
                add(ReboundText::tr("A number stands for e in the hit of two circles"),
                    ReboundText::tr("With every e tried the rebound is that of e = %1.")
                        .arg(number(first)));
        } else if (std::min(first, second) < -reboundBlur
                   || std::max(first, second) > 1.0 + reboundBlur) {
            // No e is like that: something else is wrong with the push.
            addOdd();
        } else {
            add(ReboundText::tr("Numbers stand for e in the hit of two circles"),
                ReboundText::tr(
                    "With every e tried circle 1 answers as with e = %1 and circle 2 as "
                    "with e = %2.")
                    .arg(number(first), number(second)));
        }
        m_reading.explainsElastic = true;
    }

    const MeasuredPair &m_own;
    const MeasuredPair &m_right;
    std::vector<Rebound> m_all;
    std::vector<Rebound> m_elastic;
    std::size_t m_shown = 0;
    bool m_isElastic = true; ///< where e is 1, the parts along the normal come out right
    bool m_isDone = false;
    ReboundReading m_reading;
};

} // namespace

ReboundReading reboundDeviations(const MeasuredPair &own, const MeasuredPair &right)
{
    return ReboundJudge(own, right).read();
}

} // namespace cradle
