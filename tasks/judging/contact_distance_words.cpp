// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/contact_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace cradle {

namespace {

class DistanceJudge : ContactComparison
{
public:
    using ContactComparison::ContactComparison;

    [[nodiscard]] std::vector<LawDeviation> judge()
    {
        findDistance();
        return std::move(m_found);
    }

private:
    void findDistance()
    {
        const auto sum = [](const PairHit &hit) { return hit.meeting.sum(); };
        if (fitsAll(sum))
            return findFineDistance();
        const PairHit &hit = farthestOff();
        const auto fits = [this](const ContactTest &test) { return fitsAll(test.distance); };
        if (!findTest(hit, fits))
            findOtherDistance(hit);
    }

    /// Where the steps of the meetings are too long to tell, what those of others in very short
    /// ones show, if they were far from where they are answered when these began.
    void findFineDistance()
    {
        constexpr double least = 0.01; // of r₁ + r₂
        std::vector<const PairHit *> all;
        for (const auto *hits : {&m_own.equals, &m_own.radii, &m_own.sizes}) {
            for (const PairHit &hit : *hits) {
                if (hit.isMet() && !hit.isAtOnce)
                    all.push_back(&hit);
            }
        }
        const auto off = [](const PairHit *hit) {
            return std::abs(0.5 * (hit->before + hit->reached) - hit->meeting.sum());
        };
        const auto at = std::max_element(
            all.begin(), all.end(), [&](const auto *a, const auto *b) { return off(a) < off(b); });
        if (at == all.end() || (*at)->fits((*at)->meeting.sum())
            || off(*at) < least * (*at)->meeting.sum())
            return;
        const PairHit &hit = **at;
        const auto fits = [&](const ContactTest &test) {
            return fitsAll(test.distance)
                   && std::all_of(all.begin(), all.end(),
                                  [&](const auto *h) { return h->fits(test.distance(*h)); });
        };
        if (findTest(hit, fits))
            return;
        const bool early = hit.reached > hit.meeting.sum();
        const bool isOfAll = std::all_of(all.begin(), all.end(), [&](const PairHit *h) {
            return !h->fits(h->meeting.sum()) && (h->reached > h->meeting.sum()) == early;
        });
        add(isOfAll ? (early ? ContactText::tr("The circles answer before they touch")
                             : ContactText::tr("The circles answer too late"))
            : early ? ContactText::tr("Some meetings are answered before they touch")
                    : ContactText::tr("Some meetings are answered too late"),
            seen(hit) + QLatin1Char(' ') + rimsTouch(hit), hit, Suspect::Reach);
    }

    /// Tells of the first test that \p fits. \return whether one does
    template <class Fits>
    bool findTest(const PairHit &hit, Fits fits)
    {
        for (const ContactTest &test : contactTests()) {
            if (!isTold(test.distance) || !fits(test))
                continue;
            QString body = test.body;
            body.replace(QLatin1String("%1"), brief(hit.meeting.sum()));
            body.replace(QLatin1String("%2"), brief(test.distance(hit)));
            if (!test.body.contains(QLatin1String("%2")))
                body += QLatin1Char(' ') + seen(hit);
            add(test.headline, body, hit, Suspect::Reach);
            if (test.isOfParts)
                m_found.back().topic = Topic::Distance;
            return true;
        }
        return false;
    }

    static QString rimsTouch(const PairHit &hit)
    {
        return ContactText::tr("Rims touch where the centres are r₁ + r₂ apart, here %1 m.")
            .arg(brief(hit.meeting.sum()));
    }

    /// Of all meetings, with other radii, too.
    [[nodiscard]] bool fitsAll(const std::function<double(const PairHit &)> &distance) const
    {
        const auto fits = [&](const PairHit &hit) {
            return !hit.isMet() || hit.fits(distance(hit));
        };
        return std::all_of(m_own.contacts.begin(), m_own.contacts.end(), fits)
               && std::all_of(m_own.otherRadii.begin(), m_own.otherRadii.end(), fits);
    }

    /// Whether circles of several radii show that \p distance: one pair, either of which may be
    /// circle 1, fits many formulas by chance. Where it is none, no meeting is answered.
    [[nodiscard]] bool isTold(const std::function<double(const PairHit &)> &distance) const
    {
        std::set<std::pair<double, double>> radii;
        for (const auto *hits : {&m_own.contacts, &m_own.otherRadii}) {
            for (const PairHit &hit : *hits) {
                const Meeting &m = hit.meeting;
                if (hit.isMet() || (!hit.answered && distance(hit) <= 0.0))
                    radii.insert({std::min(m.radius1, m.radius2), std::max(m.radius1, m.radius2)});
            }
        }
        return radii.size() > 1;
    }

    /// What is compared in all of \p hits besides \p known, from and to, m; nothing where that is
    /// no number, or some are not answered.
    [[nodiscard]] static std::optional<std::pair<double, double>>
    numberBeside(const std::vector<PairHit> &hits, double (*known)(const Meeting &))
    {
        double low = 0.0;
        double high = std::numeric_limits<double>::infinity();
        double late = high; // an answer may be a step late
        for (const PairHit &h : hits) {
            const double rest = known(h.meeting);
            low = std::max(low, h.reached - rest);
            high = std::min(high, h.before - rest);
            late = std::min(late, 2.0 * h.before - h.reached - rest);
        }
        high = low <= high ? high : late;
        const bool answersAll =
            std::all_of(hits.begin(), hits.end(), [](const PairHit &h) { return h.answered; });
        return answersAll && low <= high ? std::optional(std::pair(low, high)) : std::nullopt;
    }

    /// A number in place of both radii or of one. \return whether it is told
    bool findNumber(const std::vector<PairHit> &all, const PairHit &hit)
    {
        if (!isTold([](const PairHit &) { return 1.0; }))
            return false;
        if (const auto number = numberBeside(all, [](const Meeting &) { return 0.0; })) {
            add(ContactText::tr("The test of contact acts as if a number stood for r₁ + r₂"),
                ContactText::tr("With all radii tried they answer at the same distance, "
                                "between %1 and %2 m.")
                        .arg(brief(number->first), brief(number->second))
                    + QLatin1Char(' ') + seen(hit),
                hit, Suspect::Reach);
            return true;
        }
        for (const int circle : {1, 2}) {
            const auto number = circle == 1
                                    ? numberBeside(all, [](const Meeting &m) { return m.radius1; })
                                    : numberBeside(all, [](const Meeting &m) { return m.radius2; });
            if (!number)
                continue;
            const QString radius = QString::fromUtf8(circle == 1 ? "r₁" : "r₂");
            const QString other = QString::fromUtf8(circle == 1 ? "r₂" : "r₁");
            add(ContactText::tr("The test of contact acts as if a number stood for %1").arg(other),
                ContactText::tr(
                    "With all radii tried they answer where the distance of the centres "
                    "is between %1 + %2 m and %1 + %3 m.")
                        .arg(radius, brief(number->first), brief(number->second))
                    + QLatin1Char(' ') + seen(hit),
                hit, Suspect::Reach);
            return true;
        }
        return false;
    }

    /// Unequal circles show best whose radius counts.
    static double shows(const PairHit &h)
    {
        return h.meeting.radius1 == h.meeting.radius2 ? 0.1 : 1.0;
    }

    /// The contact whose answer is farthest from the right place.
    [[nodiscard]] const PairHit &farthestOff() const
    {
        return *std::max_element(
            m_own.contacts.begin(), m_own.contacts.end(), [](const PairHit &a, const PairHit &b) {
                const auto off = [](const PairHit &h) {
                    return h.isMet() && !h.fits(h.meeting.sum())
                               ? std::abs(h.before - h.meeting.sum()) * shows(h)
                               : -1.0;
                };
                return off(a) < off(b);
            });
    }

    static QString seen(const PairHit &hit)
    {
        const Meeting &m = hit.meeting;
        const QString least = brief(hit.reached);
        const QString most = brief(hit.before);
        const QString text =
            least == most
                ? ContactText::tr("With r₁ = %1 m and r₂ = %2 m, met at %3°, they answered when "
                                  "their centres were %4 m apart.")
                : ContactText::tr("With r₁ = %1 m and r₂ = %2 m, met at %3°, they answered when "
                                  "their centres were between %4 and %5 m apart.");
        const QString told = text.arg(brief(m.radius1), brief(m.radius2), brief(m.degrees), least);
        return least == most ? told : told.arg(most);
    }

    void findOtherDistance(const PairHit &hit)
    {
        auto all = m_own.contacts;
        // Who answers some in time and pushes in a wrong direction asks for approach along that.
        if (isDirectionWrong() && std::any_of(all.begin(), all.end(), [](const PairHit &h) {
                return h.isMet() && h.fits(h.meeting.sum());
            }))
            return;
        all.insert(all.end(), m_own.otherRadii.begin(), m_own.otherRadii.end());
        if (findNumber(all, hit))
            return;
        const bool early = hit.reached > hit.meeting.sum();
        // What comes right from some sides has the reach right; the distance is not.
        const bool isOfSides = std::any_of(all.begin(), all.end(), [&](const PairHit &h) {
            return h.meeting.radius1 == hit.meeting.radius1
                   && h.meeting.radius2 == hit.meeting.radius2 && isInTime(h);
        });
        QString body = seen(hit) + QLatin1Char(' ') + rimsTouch(hit);
        const auto inTime = std::count_if(m_own.contacts.begin(), m_own.contacts.end(), isInTime);
        const auto missed = std::count_if(m_own.contacts.begin(), m_own.contacts.end(),
                                          [](const PairHit &h) { return !h.answered; });
        if (missed > 0)
            body += QLatin1Char(' ')
                    + ContactText::tr("Of the %1 meetings that were tried %2 were answered in "
                                      "time; in %3 no velocity was changed.")
                          .arg(m_own.contacts.size())
                          .arg(inTime)
                          .arg(missed);
        else if (inTime > 0)
            body += QLatin1Char(' ')
                    + ContactText::tr("Of %1 meetings tried, %n were answered in time.", nullptr,
                                      static_cast<int>(inTime))
                          .arg(m_own.contacts.size());
        const bool isOfSome = inTime > 0 || missed > 0;
        const auto isOfOtherKind = [&](const PairHit &h) {
            return h.isMet() && !isInTime(h) && (h.reached > h.meeting.sum()) != early;
        };
        const bool areBoth =
            std::any_of(m_own.contacts.begin(), m_own.contacts.end(), isOfOtherKind);
        add(areBoth ? ContactText::tr("Some meetings are answered before they touch, others too "
                                      "late")
            : isOfSome && early ? ContactText::tr("Some meetings are answered before they touch")
            : isOfSome && inTime == 0
                ? ContactText::tr("The circles are answered too late, or not at all")
            : isOfSome ? ContactText::tr("Some meetings are answered too late")
            : early    ? ContactText::tr("The circles answer before they touch")
                       : ContactText::tr("The circles answer too late"),
            body, hit, Suspect::Reach);
        if (isOfSides)
            m_found.back().topic = Topic::Distance;
    }
};

} // namespace

std::vector<LawDeviation> distanceDeviations(const MeasuredPair &own, const MeasuredPair &right,
                                             const Ground &ground)
{
    return DistanceJudge(own, right, ground).judge();
}

} // namespace cradle
