// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/contact_comparison.h"
#include "tasks/judging/likeness.h"
#include "tasks/judging/response_reading.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>

namespace cradle {

using Kind = MeetingDivision::Kind;

namespace {

/// What two velocities before a hit make of one after it, if that is the same in all hits:
///     v = c₁ u₁ + c₂ u₂
struct LinearAnswer {
    double of1 = 0.0;
    double of2 = 0.0;

    /// By least squares. \param parts  u₁, u₂ and v of each hit, any components
    static std::optional<LinearAnswer> of(const std::vector<std::array<double, 3>> &parts)
    {
        double a11 = 0.0;
        double a12 = 0.0;
        double a22 = 0.0;
        double b1 = 0.0;
        double b2 = 0.0;
        for (const auto &[u1, u2, v] : parts) {
            a11 += u1 * u1;
            a12 += u1 * u2;
            a22 += u2 * u2;
            b1 += u1 * v;
            b2 += u2 * v;
        }
        const double det = a11 * a22 - a12 * a12;
        if (det <= 0.01 * a11 * a22)
            return std::nullopt;
        const LinearAnswer found{(b1 * a22 - b2 * a12) / det, (a11 * b2 - a12 * b1) / det};
        for (const auto &[u1, u2, v] : parts) {
            if (!isAlike(found.made(u1, u2), v, 5e-3))
                return std::nullopt;
        }
        return found;
    }

    [[nodiscard]] double made(double u1, double u2) const { return of1 * u1 + of2 * u2; }
};

/// Whether all \p hits of equal circles follow one sum of the two velocities, or of their parts
/// along the line of centres, that would leave \p in as it is.
bool leavesAsItCame(const std::vector<EqualHit> &hits, const PairVelocities &in)
{
    constexpr std::size_t fewest = 4; // less follow any
    if (hits.size() < fewest)
        return false;
    const auto leaves = [&](bool isWhole, bool isFirst) {
        std::vector<std::array<double, 3>> parts;
        for (const EqualHit &h : hits) {
            const PairVelocities v = h.hit.leftParts();
            const double across = isFirst ? v.across1 : v.across2;
            parts.push_back({h.in.along1, h.in.along2, isFirst ? v.along1 : v.along2});
            if (isWhole)
                parts.push_back({h.in.across1, h.in.across2, across});
            else if (!isAlike(across, isFirst ? h.in.across1 : h.in.across2, 5e-3))
                return false;
        }
        const auto answer = LinearAnswer::of(parts);
        const auto keeps = [&](double u1, double u2) {
            return isAlike(answer->made(u1, u2), isFirst ? u1 : u2, 5e-3);
        };
        return answer && keeps(in.along1, in.along2) && (!isWhole || keeps(in.across1, in.across2));
    };
    return (leaves(true, true) && leaves(true, false))
           || (leaves(false, true) && leaves(false, false));
}

} // namespace

DividedMeetings::DividedMeetings(const MeasuredPair &own, const MeasuredPair &right,
                                 const Ground &ground)
    : ContactComparison(own, right, ground)
{
    std::copy_if(own.varied.begin(), own.varied.end(), std::back_inserter(m_all),
                 [this](const PairHit &hit) { return !isPushless(hit); });
    m_division = divisionOf(m_all, arePushedAlong(right));
    for (const PairHit &hit : m_all) {
        if (!hit.stopped)
            (isRight(hit) ? m_answered : m_missed).push_back(&hit);
    }
}

bool DividedMeetings::isPushless(const PairHit &hit) const
{
    if (hit.answered || answersRightly())
        return false;
    const std::vector<EqualHit> hits = comparableHits(m_own.equals, m_right.equals);
    const PairVelocities &in = hit.meeting.velocities;
    const EqualHit here{hit, in, {in.along2, in.across1, in.along1, in.across2}};
    const Meeting &m = hit.meeting;
    const bool isOfEquals = m.radius1 == m.radius2 && m.density1 == m.density2;
    if (const auto law = isOfEquals ? unevenLaw(m_own, m_right) : std::nullopt;
        law && isSameAnswer(law->answer(here), in))
        return true;
    // Equal circles that each keep their velocity with one e are noticed with all others.
    const auto isMet = [](const PairHit &other) { return other.isMet(); };
    if (!answersAny(m_own.equals) && isOfEquals)
        return !m_own.rebounds.empty()
               && std::all_of(m_own.rebounds.begin(), m_own.rebounds.end(), isMet);
    if (m_own.radii.empty() && m_own.densities.empty() && leavesAsItCame(hits, in))
        return true;
    const auto laws = knownResponses();
    return std::any_of(laws.begin(), laws.end(), [&](const ResponseLaw &law) {
        return follows(law, hits) && isSameAnswer(law.answer(here), in);
    });
}

bool DividedMeetings::isRight(const PairHit &hit) const
{
    const bool isOfDirection = m_division && m_division->isOfDirection;
    return hit.isInTime() && (!isOfDirection || hit.isAlongCentres());
}

bool DividedMeetings::isOfWay() const
{
    return m_division && m_division->kind != Kind::Coming && m_division->kind != Kind::Size
           && !isDirectionWrong();
}

std::optional<LawDeviation> DividedMeetings::said(bool isKnown)
{
    const bool isComing = m_division && m_division->kind == Kind::Coming;
    const bool isSize = m_division && m_division->kind == Kind::Size;
    const auto isMet = [](const PairHit &hit) { return hit.isMet(); };
    if (m_answered.empty() || m_missed.empty()
        || !std::all_of(m_right.contacts.begin(), m_right.contacts.end(), isMet)
        || (isKnown && !isComing) || (isDirectionWrong() && !isComing && !isSize)
        || (!m_division && isHardlyMissed()))
        return std::nullopt;
    tell();
    return std::move(m_found.front());
}

/// Whether a wrong answer is to blame: few are missed, nothing divides them, and some that are
/// answered as they meet come out wrong.
bool DividedMeetings::isHardlyMissed() const
{
    const bool isAnswerRight = std::equal(
        m_own.equals.begin(), m_own.equals.end(), m_right.equals.begin(), m_right.equals.end(),
        [](const PairHit &a, const PairHit &b) {
            return !a.isMet() || !b.isMet() || isSameAnswer(a.leftParts(), b.leftParts());
        });
    return !isAnswerRight && 4 * m_missed.size() < m_answered.size();
}

void DividedMeetings::tell()
{
    const PairHit &missed = plainest(m_missed);
    const bool isOfDirection = m_division && m_division->isOfDirection;
    const bool isSide = m_division && m_division->kind == Kind::Side;
    QStringList body{ContactText::tr("This one came out wrong: %1.")
                         .arg(describeMeeting(missed, m_ground, m_division))};
    if (!m_division)
        body.append(ContactText::tr("This one was answered in time: %1.")
                        .arg(describeMeeting(plainest(m_answered), m_ground, m_division)));
    body.append(counted());
    body.append(isSide
                    ? ContactText::tr("Look at what changes from one side to the other: the sign "
                                      "of a difference, or an angle.")
                    : ContactText::tr("A hit is due where they overlap and come nearer along the "
                                      "line of centres, and nowhere else."));
    const bool answersAll = std::all_of(m_missed.begin(), m_missed.end(),
                                        [](const PairHit *hit) { return hit->answered; });
    add(isOfDirection ? ContactText::tr("Some hits do not act along the line of centres")
        : answersAll  ? ContactText::tr("Some hits of the two circles are answered too late")
                      : ContactText::tr("Some hits of the two circles are not answered"),
        body.join(QLatin1Char(' ')), whereTheyTouch(missed),
        isSide ? Suspect::Formula : Suspect::Question);
    if (isSide)
        m_found.back().topic = Topic::Direction;
}

QString DividedMeetings::counted() const
{
    const int right = static_cast<int>(m_answered.size());
    const QString all = QString::number(m_answered.size() + m_missed.size());
    const bool isAnyEarly =
        std::any_of(m_answered.begin(), m_answered.end(),
                    [](const PairHit *hit) { return hit->reached > hit->meeting.sum() + 1e-9; });
    if (isAnyEarly && m_division && !m_division->isOfDirection)
        return ContactText::tr("Of %1 meetings tried, %n were answered, in time or too early: %2.",
                               nullptr, right)
            .arg(all, m_division->phrase);
    if (isAnyEarly && !m_division)
        return ContactText::tr("Of %1 meetings tried, %n were answered, in time or too early.",
                               nullptr, right)
            .arg(all);
    if (!m_division)
        return ContactText::tr("Of %1 meetings tried, %n were answered in time.", nullptr, right)
            .arg(all);
    return (m_division->isOfDirection
                ? ContactText::tr("Of %1 meetings tried, %n were answered in time and along the "
                                  "line of centres: %2.",
                                  nullptr, right)
                : ContactText::tr("Of %1 meetings tried, %n were answered in time: %2.", nullptr,
                                  right))
        .arg(all, m_division->phrase);
}

/// One of \p hits, not empty, in which both move, if there is one.
const PairHit &DividedMeetings::plainest(const std::vector<const PairHit *> &hits)
{
    const auto found = std::find_if(hits.begin(), hits.end(), [](const PairHit *hit) {
        const PairVelocities &v = hit->meeting.velocities;
        return v.along1 != 0.0 && v.along2 != 0.0;
    });
    return found == hits.end() ? *hits.front() : **found;
}

QString describeMeeting(const PairHit &hit, const Ground &ground,
                        const std::optional<MeetingDivision> &division)
{
    const Meeting &m = hit.meeting;
    const Vec2 n{std::cos(m.degrees * std::numbers::pi / 180.0),
                 std::sin(m.degrees * std::numbers::pi / 180.0)};
    const auto velocity = [&](double along, double across) {
        return brief(hit.slowness * (along * n + across * perpendicular(n)));
    };
    QStringList parts{ContactText::tr("circle 1 came with %1 m/s, circle 2 with %2 m/s")
                          .arg(velocity(m.velocities.along1, m.velocities.across1),
                               velocity(m.velocities.along2, m.velocities.across2)),
                      ContactText::tr("their line of centres at %1°").arg(brief(m.degrees))};
    const auto maySplit = [&](Kind kind) { return !division || division->kind == kind; };
    if (maySplit(Kind::Place))
        parts.append(ContactText::tr("near %1 m").arg(brief(m.middle)));
    if (ground.pair.radii.isVaried() && maySplit(Kind::Size))
        parts.append(QStringLiteral("r₁ = %1, r₂ = %2 m").arg(brief(m.radius1), brief(m.radius2)));
    if (ground.pair.densities.isVaried() && maySplit(Kind::Size))
        parts.append(QStringLiteral("ρ₁ = %1, ρ₂ = %2").arg(brief(m.density1), brief(m.density2)));
    return parts.join(QStringLiteral(", "));
}

} // namespace cradle
