// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/hit_kinds.h"

#include "tasks/judging/contact_comparison.h"
#include "tasks/judging/pair_words.h"
#include "tasks/judging/response_reading.h"

#include <cmath>
#include <set>

namespace cradle {

namespace {

/// Whether it says that one circle leaves as it should, and the other does not.
bool isAboutOneCircle(const LawDeviation &found)
{
    return found.suspect == Suspect::Answer && found.moment.circles.size() == 1;
}

bool areRightOfEquals(const std::vector<JudgedMeeting> &hits)
{
    return std::all_of(hits.begin(), hits.end(), [](const JudgedMeeting &one) {
        return one.isRight || !areAlike(one.hit->meeting);
    });
}

std::vector<JudgedMeeting> unequalOf(std::vector<JudgedMeeting> hits)
{
    std::erase_if(hits, [](const JudgedMeeting &one) { return areAlike(one.hit->meeting); });
    return hits;
}

} // namespace

/// Tells of what was found in how many of \p hits it is, where it is not in all.
void HitKinds::limit(const Kinds &hits)
{
    limitTo(m_said.deviations.front(), isOfMost(hits) ? ConditionText::tr("%1 (in most hits)")
                                                      : ConditionText::tr("%1 (in some hits)"));
}

/// \param text  with a place for the headline
void HitKinds::limitTo(LawDeviation &found, const QString &text)
{
    const qsizetype end = found.message.indexOf(QLatin1Char('\n'));
    found.message = text.arg(found.message.left(end)) + found.message.mid(end);
    found.isOfSome = true;
}

/// Whether what was found of two sizes is of masses, and all of \p hits follow some masses, but
/// not those; the headline is then that of no power.
bool HitKinds::areOtherMasses(const Kinds &hits)
{
    LawDeviation &found = m_said.deviations.front();
    // Where many come out right, it is no formula of the masses that is wrong.
    if (5 * rightOf(hits) > std::ssize(hits) || found.suspect != Suspect::Masses
        || m_ground.pair.densities.isVaried()
        || !std::all_of(hits.begin(), hits.end(), [](const JudgedMeeting &one) {
               const double closing = std::abs(one.hit->meeting.closing());
               return massRatio(*one.hit)
                      && std::abs(one.hit->rebound() - one.hit->meeting.restitution) * closing
                             < 0.01;
           }))
        return false;
    found.message = ConditionText::tr("The masses do not follow the radii as those of balls do")
                    + found.message.mid(found.message.indexOf(QLatin1Char('\n')));
    return true;
}

std::vector<LawDeviation> HitKinds::judge(std::vector<LawDeviation> given)
{
    m_said.deviations = std::move(given);
    judge();
    return std::move(m_said.deviations);
}

void HitKinds::judge()
{
    std::vector<LawDeviation> &found = m_said.deviations;
    // What is another answer in another step is none of these.
    if (!found.empty()
        && (found.front().topic == Topic::Timestep || found.front().topic == Topic::Depth))
        return;
    const auto isOfE = [](const LawDeviation &one) { return one.topic == Topic::Restitution; };
    if (std::any_of(found.begin(), found.end(), isOfE)) {
        const bool isFirst = isOfE(found.front());
        judgeRestitution();
        if (isFirst)
            return;
    }
    // Whoever is hit again while they part has more than one answer in it.
    if (found.empty() && m_own.pair().twice && !m_right.pair().twice)
        return;
    Kinds all = kinds();
    // All of these are first hits: what is wrong with them was not kept. Nor are they slow.
    const bool isOfMemory =
        !found.empty()
        && (found.front().suspect == Suspect::Kept || found.front().suspect == Suspect::Copy);
    const bool isOfSlow = !found.empty() && found.front().topic == Topic::Slowness;
    if (rightOf(all) < std::ssize(all) && (isOfMemory || (isOfSlow && rightOf(all) > 0)))
        found.clear();
    if (!found.empty()) {
        const double e = m_own.pair().equals.front().meeting.restitution;
        std::erase_if(all,
                      [&](const JudgedMeeting &one) { return one.hit->meeting.restitution != e; });
    }
    // What is said of masses holds where they differ.
    const bool isOfMasses = !found.empty() && areEqualsRight();
    Kinds hits = all;
    if (!found.empty())
        std::erase_if(hits, [&](const JudgedMeeting &one) {
            return areAlike(one.hit->meeting) == isOfMasses;
        });
    const auto right = rightOf(hits);
    if (right == std::ssize(hits)) {
        if (isOfMasses && right > 0 && !found.front().isOfSome && isAboutOneCircle(found.front()))
            limit(hits);
        return;
    }
    if (!found.empty())
        limitToE(isOfMasses);
    if (!found.empty() && right == 0)
        judgeAllWrong(hits);
    const bool isLaw = !found.empty() && isLawOf(hits);
    const auto division = isLaw ? std::nullopt : divisionOf(all);
    // Where no hit of equal circles comes out right, others may still show which do.
    const bool isOfAll = right == 0 && (isOfMasses || !division);
    if (!found.empty() && (isOfAll || areMasses(hits) || (isLaw && isOfMasses)))
        return;
    const auto isOne = [&](const JudgedMeeting &one) { return isOfOneCircle(*one.hit); };
    // Of a few that come out wrong it may be one circle by chance.
    const bool isOfFew = 2 * right > std::ssize(hits);
    if (isOfMasses && areRightOfEquals(all)
        && ((!isOfFew && std::all_of(all.begin(), all.end(), isOne)) || areShares(hits)
            || areOtherMasses(hits))) {
        found.resize(1);
        found.front().message += countOf(hits, std::nullopt);
        return;
    }
    if (!found.empty() && !division && !isOfMasses) {
        if (!isLaw && !found.front().isOfSome)
            limit(hits);
        found.front().message += countOf(hits, std::nullopt);
        return;
    }
    // Of equal circles all may come out right for another reason.
    const Kinds unequal = unequalOf(all);
    const auto among = division || !areRightOfEquals(all) ? std::nullopt : divisionOf(unequal);
    LawDeviation said = among ? kindsDeviation(unequal, among) : kindsDeviation(all, division);
    // Which of them act along the line of centres has been said of the contact.
    const auto contacts = contactDeviations(m_own.pair(), m_right.pair(), m_ground);
    if (found.empty() && said.topic == Topic::Direction
        && std::any_of(contacts.begin(), contacts.end(),
                       [](const LawDeviation &one) { return one.topic == Topic::Direction; }))
        return;
    found = {std::move(said)};
}

/// How many of \p hits come out right, and with which e, if others were tried, too; begins with a
/// blank.
QString HitKinds::countOf(const Kinds &hits, const std::optional<MeetingDivision> &division) const
{
    std::set<double> restitutions;
    for (const JudgedMeeting &one : hits)
        restitutions.insert(one.hit->meeting.restitution);
    const Kinds every = kinds();
    const bool isOfSome = std::any_of(every.begin(), every.end(), [&](const JudgedMeeting &one) {
        return !restitutions.contains(one.hit->meeting.restitution);
    });
    QStringList told;
    for (const double e : restitutions)
        told.append(brief(e));
    const QString of = told.join(QStringLiteral(", "));
    const auto right = static_cast<int>(rightOf(hits));
    const QString all = QString::number(hits.size());
    const bool isOfUnequal = unequalOf(hits).size() == hits.size();
    const QString text =
        division && isOfUnequal && isOfSome
            ? ConditionText::tr("Of %1 hits of unequal circles tried with e = %2, %n came out "
                                "right: %3.",
                                nullptr, right)
                  .arg(all, of, division->phrase)
        : division && isOfUnequal
            ? ConditionText::tr("Of %1 hits of unequal circles tried, %n came out right: %2.",
                                nullptr, right)
                  .arg(all, division->phrase)
        : division && isOfSome
            ? ConditionText::tr("Of %1 hits tried with e = %2, %n came out right: %3.", nullptr,
                                right)
                  .arg(all, of, division->phrase)
        : division ? ConditionText::tr("Of %1 hits tried, %n came out right: %2.", nullptr, right)
                         .arg(all, division->phrase)
        : isOfSome
            ? ConditionText::tr("Of %1 hits tried with e = %2, %n came out right.", nullptr, right)
                  .arg(all, of)
            : ConditionText::tr("Of %1 hits tried, %n came out right.", nullptr, right).arg(all);
    return QLatin1Char(' ') + text;
}

/// Where none of \p hits, not empty, comes out right: what was found of others need not be so in
/// them.
void HitKinds::judgeAllWrong(const Kinds &hits)
{
    const LawDeviation &found = m_said.deviations.front();
    if (found.isOfSome)
        return;
    const auto law = saidLaw();
    if (law && !follows(*law, besideRight(hits)))
        limit(hits);
    else if (isAboutOneCircle(found)
             && !std::all_of(hits.begin(), hits.end(),
                             [&](const JudgedMeeting &one) { return isOfOneCircle(*one.hit); }))
        limit(hits);
    else if (MassExponents(m_own.pair()).radius && !areMasses(hits))
        (void)areOtherMasses(hits);
}

/// The first of \p all whose numbers show that it comes out wrong; if none does, the one that is
/// most so.
const PairHit &HitKinds::clearlyWrong(const Kinds &all) const
{
    constexpr double clear = 0.02; // of the closing speed
    const PairHit *worst = nullptr;
    double most = 0.0;
    for (const JudgedMeeting &one : all) {
        if (one.isRight)
            continue;
        const PairVelocities a = one.hit->leftParts();
        const PairVelocities b = rightFor(one.hit->cameParts(), goodOf(*one.hit));
        const double off = (std::abs(a.along1 - b.along1) + std::abs(a.along2 - b.along2)
                            + std::abs(a.across1 - b.across1) + std::abs(a.across2 - b.across2))
                           / std::abs(one.hit->meeting.closing());
        if (!worst || off > most) {
            worst = one.hit;
            most = off;
        }
        if (off > clear)
            break;
    }
    return *worst;
}

LawDeviation HitKinds::kindsDeviation(const Kinds &all,
                                      const std::optional<MeetingDivision> &division) const
{
    const PairHit &hit = clearlyWrong(all);
    const auto law = lawOf(all);
    // Of unequal circles it counts how unequal they are.
    const bool isOfUnequal = unequalOf(all).size() == all.size();
    QString meeting = describeMeeting(hit, m_ground, isOfUnequal ? std::nullopt : division);
    if (m_ground.pair.restitutions.size() > 1)
        meeting += QStringLiteral(", e = ") + brief(hit.meeting.restitution);
    const QString seen = ConditionText::tr("This one came out wrong: %1.").arg(meeting)
                         + QLatin1Char(' ') + describeHit(hit, goodOf(hit));
    if (law)
        return responseDeviation(law->headline, seen + QLatin1Char(' ') + law->body, hit);
    LawDeviation said = responseDeviation(
        rightOf(all) == 0 ? ConditionText::tr("No hit that was tried comes out right")
                          : ConditionText::tr("Some hits of the two circles come out wrong"),
        seen + countOf(all, division), hit, Suspect::Formula);
    said.isConditional = true;
    if (division && division->kind == MeetingDivision::Kind::Side)
        said.topic = Topic::Direction;
    return said;
}

} // namespace cradle
