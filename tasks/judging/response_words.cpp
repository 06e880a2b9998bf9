// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/hit_kinds.h"
#include "tasks/judging/pair_words.h"
#include "tasks/judging/response_law_words.h"
#include "tasks/judging/response_reading.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

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
        m_equal = equalReading(m_own, m_right, rebound.explainsElastic);
        if (auto stepped = m_equal.isRight ? std::nullopt : steppedDeviation(m_own, m_right, false);
            stepped && !(m_equal.law && stepped->topic == Topic::Depth)) {
            m_found.push_back(std::move(*stepped));
            return std::move(m_found);
        }
        take(m_equal.said);
        // An answer that never asks for masses or e is one fault, not three.
        if (!isWhole(m_own.radii, m_right.radii) || !isWhole(m_own.densities, m_right.densities)) {
            for (LawDeviation &mass : massDeviations(m_own, m_right, m_equal.isRight))
                m_found.push_back(std::move(mass));
            if (m_found.size() == 1 && m_equal.said) {
                for (LawDeviation &mass : massDeviationsBeside(m_own, m_right))
                    m_found.push_back(std::move(mass));
            }
        }
        if (m_equal.isRight && m_own.later && m_right.later && m_own.later->isFirstOdd()
            && m_own.later->isOfHistory() && isAnyFirstOdd()) {
            take(lateRestitution(m_own));
        } else if (!isWhole(m_own.rebounds, m_right.rebounds)) {
            for (LawDeviation &deviation : rebound.deviations)
                m_found.push_back(std::move(deviation));
        }
        if (m_own.areOfParting)
            return std::move(m_found);
        if (m_found.empty() && m_equal.isRight)
            take(sizeDeviation(m_own, m_right));
        const bool isElseRight = m_found.empty();
        if ((isElseRight || isOnlyMasses(rebound)) && m_equal.isRight
            && (!isElseRight || !wrongUnequal().first))
            take(ownDeviation(m_own, m_right, isElseRight));
        if (m_found.empty())
            findUnequal();
        if (m_found.empty() && m_equal.isRight)
            take(laterDeviation(m_own, m_right));
        if (m_found.empty() && m_equal.isRight)
            take(slowDeviation(m_own, m_right));
        return std::move(m_found);
    }

private:
    void take(std::optional<LawDeviation> deviation)
    {
        if (deviation)
            m_found.push_back(std::move(*deviation));
    }

    /// Whether other first hits with the e of that one come out with another, too: else something
    /// else is odd about it.
    [[nodiscard]] bool isAnyFirstOdd() const
    {
        const double e = m_own.later->first.meeting.restitution;
        return std::any_of(m_own.rebounds.begin(), m_own.rebounds.end(), [&](const PairHit &hit) {
            return hit.isMet() && hit.meeting.restitution == e
                   && std::abs(hit.rebound() - e) > 0.03;
        });
    }

    /// Whether the law that was found explains these hits, too.
    [[nodiscard]] bool isWhole(const std::vector<PairHit> &own,
                               const std::vector<PairHit> &right) const
    {
        return m_equal.law && (own.empty() || follows(*m_equal.law, comparableHits(own, right)));
    }

    /// Whether all that was found is that masses grow with other powers or stand for each other,
    /// and e is used as it should be.
    [[nodiscard]] bool isOnlyMasses(const ReboundReading &rebound) const
    {
        const MassExponents p(m_own);
        const auto isPower = [](double q) {
            return std::abs(q) > 0.4 && std::abs(2.0 * q - std::round(2.0 * q)) < 0.04;
        };
        return m_equal.isRight && !m_equal.law && rebound.deviations.empty() && !unsharedHit(m_own)
               && p.radius && isPower(*p.radius)
               && (m_own.densities.empty() || (p.density && isPower(*p.density)));
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
                    && !isSameAnswer(hit.leftParts(), rightFor(hit.cameParts(), good)))
                    return {&hit, &good};
            }
        }
        return {nullptr, nullptr};
    }

    /// Whether all hits of unequal circles come out wrong.
    [[nodiscard]] bool isNoUnequalRight() const
    {
        for (const auto &[own, right] : {std::pair(&m_own.radii, &m_right.radii),
                                         std::pair(&m_own.densities, &m_right.densities)}) {
            for (const EqualHit &one : comparableHits(*own, *right)) {
                if (!areAlike(one.hit.meeting) && isSameAnswer(one.hit.leftParts(), one.right))
                    return false;
            }
        }
        return true;
    }

    /// Equal circles come out right, unequal ones do not, in a way that no mass explains.
    void findUnequal()
    {
        const auto [hit, good] = wrongUnequal();
        // Whoever is hit again while they part has more than one answer in it.
        if (!m_equal.isRight || !hit || (m_own.twice && !m_right.twice))
            return;
        const Meeting &m = hit->meeting;
        // Where equal circles keep their velocities without losses, nothing is known of them.
        const bool isOfE = m.restitution != m_own.equals.front().meeting.restitution
                           || comparableHits(m_own.equals, m_right.equals).empty();
        take(responseDeviation(
            isOfE ? ResponseText::tr("With e = %1 a hit does not come out right")
                        .arg(brief(m.restitution))
            : isNoUnequalRight()
                ? ResponseText::tr("Equal circles answer rightly, no unequal ones tried do")
                : ResponseText::tr("Equal circles answer rightly, not all unequal ones do"),
            ResponseText::tr("With r₁ = %1 and r₂ = %2 m, ρ₁ = %3 and ρ₂ = %4, e = %5: ")
                    .arg(brief(m.radius1), brief(m.radius2), brief(m.density1), brief(m.density2),
                         brief(m.restitution))
                + describeHit(*hit, *good),
            *hit));
    }

    const MeasuredPair &m_own;
    const MeasuredPair &m_right;
    std::vector<LawDeviation> m_found;
    EqualReading m_equal{};
};

/// \p pair with all velocities turned round, those of circles that move apart: what one impulse
/// gives is turned round with them.
MeasuredPair turnedRound(MeasuredPair pair)
{
    for (auto *hits : {&pair.equals, &pair.radii, &pair.sizes, &pair.densities, &pair.rebounds}) {
        for (PairHit &hit : *hits) {
            hit.meeting.velocities = faster(hit.meeting.velocities, -1.0);
            for (Vec2 *velocity : {&hit.came1, &hit.came2, &hit.left1, &hit.left2})
                *velocity = -*velocity;
        }
    }
    return pair;
}

/// Whose hits the numbers of \p found are, where circles that meet are not answered.
void tellParting(std::vector<LawDeviation> &found)
{
    for (LawDeviation &each : found)
        each.message.replace(
            QStringLiteral("\n\n"),
            QStringLiteral("\n\n")
                + ResponseText::tr(
                    "Seen of circles that move apart, which your program answers as if "
                    "they met; right is what the answer should make of these "
                    "velocities.")
                + QLatin1Char(' '));
}

} // namespace

PairVelocities rightFor(const PairVelocities &in, const PairHit &right)
{
    const Meeting &m = right.meeting;
    const PairVelocities came = right.cameParts();
    const PairVelocities left = right.leftParts();
    const double closing = came.along1 - came.along2;
    const double push1 = left.along1 - came.along1;
    const double push2 = left.along2 - came.along2;
    const double ratio = std::pow(m.radius2 / m.radius1, 3) * m.density2 / m.density1;
    const double blur = 1e-6 * std::abs(closing);
    const bool isImpulse = std::abs(push1 + ratio * push2) <= blur
                           && std::abs(left.across1 - came.across1) <= blur
                           && std::abs(left.across2 - came.across2) <= blur;
    if (!isImpulse || blur == 0.0)
        return left;
    const double share = (in.along1 - in.along2) / closing;
    return {in.along1 + share * push1, in.across1, in.along2 + share * push2, in.across2};
}

LawDeviation responseDeviation(const QString &headline, const QString &body, const PairHit &hit,
                               Suspect suspect)
{
    return {Aspect::Response,
            headline + QStringLiteral("\n\n") + body,
            {hit.stage, std::max<qint64>(hit.step, 1), {0, 1}, false},
            suspect};
}

QString describeHit(const PairHit &hit, const PairHit &right, bool alongAlone)
{
    const PairVelocities in = hit.cameParts();
    const PairVelocities out = hit.leftParts();
    const PairVelocities good = rightFor(in, right);
    const auto told = [&](double part, double wanted) {
        return brief(hit.slowness
                     * hit.seenPart(part, {wanted, 0.0, in.along1, in.across1, in.along2,
                                           in.across2, good.along1, good.along2}));
    };
    const auto partsOf = [&](double PairVelocities::*one, double PairVelocities::*two) {
        return QStringList{told(in.*one, in.*one),     told(in.*two, in.*two),
                           told(out.*one, good.*one),  told(out.*two, good.*two),
                           told(good.*one, good.*one), told(good.*two, good.*two)};
    };
    const QStringList along = partsOf(&PairVelocities::along1, &PairVelocities::along2);
    const QStringList across = partsOf(&PairVelocities::across1, &PairVelocities::across2);
    const auto isRight = [](const QStringList &parts) {
        return parts[2] == parts[4] && parts[3] == parts[5];
    };
    const auto said = [](const QString &text, const QStringList &parts) {
        return text.arg(parts[0], parts[1], parts[2], parts[3], parts[4], parts[5]);
    };
    QStringList sentences;
    if (alongAlone || !isRight(along) || isRight(across))
        sentences.append(
            said(ResponseText::tr(
                     "Along the line of centres, from 1 to 2, circle 1 came with %1 m/s and "
                     "circle 2 with %2 m/s; they left with %3 and %4; %5 and %6 are right."),
                 along));
    if (!alongAlone && !isRight(across))
        sentences.append(said(
            ResponseText::tr("Across the line of centres circle 1 came with %1 m/s and circle 2 "
                             "with %2 m/s; they left with %3 and %4; %5 and %6 are right."),
            across));
    return sentences.join(QLatin1Char(' '));
}

std::vector<LawDeviation> responseDeviations(const MeasuredPair &own, const MeasuredPair &right,
                                             const Ground &ground)
{
    const auto answered = [](const PairHit &hit) { return hit.isMet(); };
    if (!right.isJudged || !ground.pair.asked)
        return {};
    if (auto spread = own.areOfParting ? std::nullopt : spreadDeviation(own, right))
        return {std::move(*spread)};
    // Equal circles may then keep their velocities, or stop the program: by what it divides them.
    if (auto uneven = own.areOfParting ? std::nullopt : unevenDeviation(own, right))
        return {std::move(*uneven)};
    if (!own.isJudged)
        return {};
    if (std::none_of(own.equals.begin(), own.equals.end(), answered)
        && std::none_of(own.rebounds.begin(), own.rebounds.end(), answered))
        return {};
    if (!own.areOfParting)
        return ResponseJudge(own, right).judge();
    const MeasuredPair turned = turnedRound(right);
    const std::vector<EqualHit> equals = comparableHits(own.equals, turned.equals);
    // Who pushes by the size of the closing speed alone makes something else of those that meet.
    if (std::any_of(equals.begin(), equals.end(), [](const EqualHit &h) {
            return isSameAnswer(h.hit.leftParts(), pushed(h, -1.0));
        }))
        return {};
    std::vector<LawDeviation> found = ResponseJudge(own, turned).judge();
    tellParting(found);
    return found;
}

} // namespace cradle
