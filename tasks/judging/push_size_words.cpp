// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/brief_beside.h"
#include "tasks/judging/likeness.h"
#include "tasks/judging/response_law_words.h"
#include "tasks/judging/response_reading.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cradle {

/// Of a law that is told with two digits: what is left by another one that is near it, such as a
/// constant beside large velocities, is more.
constexpr double exact = 1e-3;

QString lawOfPart(const std::vector<EqualHit> &hits, int circle)
{
    const auto partOf = [&](const PairVelocities &v) { return circle == 0 ? v.along1 : v.along2; };
    // The least squares of c₁ u₁ + c₂ u₂ − u.
    double a11 = 0.0;
    double a12 = 0.0;
    double a22 = 0.0;
    double b1 = 0.0;
    double b2 = 0.0;
    for (const EqualHit &h : hits) {
        const double part = partOf(h.hit.leftParts());
        a11 += h.in.along1 * h.in.along1;
        a12 += h.in.along1 * h.in.along2;
        a22 += h.in.along2 * h.in.along2;
        b1 += h.in.along1 * part;
        b2 += h.in.along2 * part;
    }
    const double det = a11 * a22 - a12 * a12;
    if (det < 0.01 * a11 * a22 || a22 == 0.0)
        return {};
    const double of1 = (b1 * a22 - b2 * a12) / det;
    const double of2 = (a11 * b2 - a12 * b1) / det;
    const bool holds = std::all_of(hits.begin(), hits.end(), [&](const EqualHit &h) {
        // Where they do not exchange their parts, other numbers are right.
        return isAlike(of1 * h.in.along1 + of2 * h.in.along2, partOf(h.hit.leftParts()), exact)
               && isAlike(h.right.along1, h.in.along2, 5e-3);
    });
    if (!holds)
        return {};
    const auto number = [](double x) { return brief(std::round(x * 100.0) / 100.0); };
    return QLatin1Char(' ')
           + ResponseText::tr("In all these hits the new part of circle %1 along that line was %2 "
                              "times that of circle 1 before the hit and %3 times that of circle "
                              "2; right is %4 and %5 times.")
                 .arg(QString::number(circle + 1), number(of1), number(of2),
                      QString::number(circle), QString::number(1 - circle));
}

namespace {

/// How many times as large as it should be the push is that parts two circles.
double factorOf(const PairHit &own, const PairHit &right)
{
    const PairVelocities in = own.cameParts();
    return (own.leftParts().along1 - in.along1) / (rightFor(in, right).along1 - in.along1);
}

/// Hits of two programs.
using HitPair = std::pair<const PairHit *, const PairHit *>;

/// Those of two equal circles in very short steps; first the usual ones, whose circles are alike.
std::vector<HitPair> equalHits(const MeasuredPair &own, const MeasuredPair &right)
{
    std::vector<HitPair> all;
    const auto add = [&](const PairHit &mine, const PairHit &good) {
        if (mine.meeting.radius1 == mine.meeting.radius2
            && mine.meeting.density1 == mine.meeting.density2 && mine.isMet() && mine.isAligned()
            && good.isMet() && good.isAligned())
            all.emplace_back(&mine, &good);
    };
    for (const auto &[mine, good] :
         {std::pair(&own.equals, &right.equals), std::pair(&own.radii, &right.radii),
          std::pair(&own.densities, &right.densities)}) {
        for (std::size_t i = 0; i < mine->size(); ++i)
            add((*mine)[i], (*good)[i]);
    }
    if (own.larger && right.larger)
        add(*own.larger, *right.larger);
    return all;
}

/// Whether every push of equal circles changes their velocities by whole numbers of m/s, where
/// some should not.
bool areWhole(const std::vector<HitPair> &hits)
{
    constexpr double blur = 4e-3;    // the line of centres turns a little in a step
    constexpr double clearly = 0.05; // no whole number
    constexpr int fewest = 3;        // by chance
    int fractions = 0;
    for (const auto &[mine, good] : hits) {
        const PairVelocities in = mine->cameParts();
        const PairVelocities out = mine->leftParts();
        const PairVelocities right = rightFor(in, *good);
        const auto offWhole = [slowness = mine->slowness](double part) {
            const double push = slowness * part;
            return std::abs(push - std::round(push));
        };
        if (offWhole(out.along1 - in.along1) > blur || offWhole(out.along2 - in.along2) > blur)
            return false;
        fractions += offWhole(right.along1 - in.along1) > clearly ? 1 : 0;
    }
    return fractions >= fewest;
}

/// What is seen of pushes that differ for the same circles.
SizeOfPush otherSize(const std::vector<HitPair> &hits)
{
    SizeOfPush size{ResponseText::tr("The push has the wrong size")};
    if (areWhole(hits)) {
        size.seen = QLatin1Char(' ')
                    + ResponseText::tr("In all hits of equal circles tried the velocities changed "
                                       "along that line by whole numbers of m/s: look for what "
                                       "rounds a number, such as `//` or `math.floor`.");
        size.isRounded = true;
    }
    return size;
}

/// Between what the size of the push lies in steps of the usual length, if it is not the same in
/// all by some share of \p factor.
std::optional<std::pair<double, double>> rangeOfPush(const MeasuredPair &own,
                                                     const MeasuredPair &right, double factor)
{
    constexpr double blur = 0.1; // the line of centres turns in such a step
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t i = 0; i < own.contacts.size(); ++i) {
        const PairHit &mine = own.contacts[i];
        if (mine.meeting.radius1 != mine.meeting.radius2 || !mine.isMet()
            || !right.contacts[i].isMet())
            continue;
        least = std::min(least, factorOf(mine, right.contacts[i]));
        most = std::max(most, factorOf(mine, right.contacts[i]));
    }
    return most - least > blur * std::abs(factor) ? std::optional(std::pair(least, most))
                                                  : std::nullopt;
}

} // namespace

SizeOfPush sizeOfPush(const MeasuredPair &own, const MeasuredPair &right, const PairHit &hit,
                      const PairHit &good)
{
    const double factor = factorOf(hit, good);
    const Meeting &m = hit.meeting;
    bool isOfEverySize = false;
    for (const auto &[mine, theirs] : equalHits(own, right)) {
        const double other = factorOf(*mine, *theirs);
        const Meeting &o = mine->meeting;
        isOfEverySize = isOfEverySize || o.radius1 != m.radius1;
        if (isAlike(other / factor, 1.0, 0.01))
            continue;
        if (o.radius1 == m.radius1 && o.density1 == m.density1)
            return otherSize(equalHits(own, right));
        if (o.density1 == m.density1)
            return {
                ResponseText::tr("The push has a wrong size that depends on the radius"),
                QLatin1Char(' ')
                    + ResponseText::tr("With r = %1 m for both the push is %2 times as large "
                                       "as it should be, with r = %3 m it is %4 times.")
                          .arg(brief(m.radius1), brief(factor), brief(o.radius1), brief(other))};
        return {ResponseText::tr("The push has a wrong size that depends on the circles"),
                QLatin1Char(' ')
                    + ResponseText::tr("With r = %1 m and ρ = %2 for both the push is %3 times as "
                                       "large as it should be, with r = %4 m and ρ = %5 it is %6 "
                                       "times.")
                          .arg(brief(m.radius1), brief(m.density1), brief(factor), brief(o.radius1),
                               brief(o.density1), brief(other))};
    }
    for (std::size_t i = 0; i < own.contacts.size(); ++i) {
        const PairHit &mine = own.contacts[i];
        const PairHit &theirs = right.contacts[i];
        if (mine.meeting.radius1 != mine.meeting.radius2 || !mine.isMet() || !theirs.isMet())
            continue;
        // Of other circles the push may be another for that reason.
        if (!isOfEverySize && mine.meeting.radius1 != m.radius1)
            continue;
        // The line of centres turns in such a step, which blurs the numbers; what a timestep that
        // is more than a hundred times as long makes of the push is more.
        const double other = factorOf(mine, theirs);
        if (std::abs(other) < 3.0 * std::abs(factor) && std::abs(factor) < 3.0 * std::abs(other))
            continue;
        return {ResponseText::tr("The push has a wrong size that depends on the timestep"),
                QLatin1Char(' ')
                    + ResponseText::tr("With a timestep of %1 s the push is %2 times as large as "
                                       "it should be, and with %3 s about %4 times.")
                          .arg(briefTimestep(hit.stage.preset.timestep), brief(factor),
                               briefTimestep(mine.stage.preset.timestep), brief(other))};
    }
    if (const auto range = rangeOfPush(own, right, factor))
        return {ResponseText::tr("The push has the wrong size"),
                QLatin1Char(' ')
                    + ResponseText::tr("In meetings with a timestep of %1 s it was between %2 and "
                                       "%3 times as large as it should be.")
                          .arg(briefTimestep(own.contacts.front().stage.preset.timestep),
                               brief(range->first), brief(range->second))};
    bool isOfEveryE = true;
    for (std::size_t i = 0; i < own.rebounds.size(); ++i) {
        const PairHit &mine = own.rebounds[i];
        const PairHit &theirs = right.rebounds[i];
        isOfEveryE =
            isOfEveryE
            && (!mine.isMet() || !theirs.isMet() || isAlike(factorOf(mine, theirs), factor, 0.01));
    }
    return {
        ResponseText::tr("Equal circles get %1 times the right push").arg(briefBeside(factor, 1.0)),
        {},
        isOfEveryE};
}

} // namespace cradle
