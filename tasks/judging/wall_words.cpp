// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_words.h"

#include "tasks/checks/motion.h"

#include <QCoreApplication>

#include <algorithm>
#include <functional>
#include <set>

namespace cradle {

namespace {

struct WallText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

/// Two programs may differ by so much at a wall under gravity or without: see MeasuredWalls::blur.
bool isNear(double a, double b, double blur)
{
    return std::abs(a - b) <= blur * (1.0 + std::abs(b));
}

/// Judges the walls of one program.
class WallJudge
{
public:
    WallJudge(const MeasuredWalls &own, const MeasuredWalls &right, const Ground &ground)
        : m_own(own)
        , m_right(right)
        , m_ground(ground)
    {
    }

    [[nodiscard]] std::vector<LawDeviation> judge()
    {
        findMissing();
        findReach();
        findLeap();
        findAnswer();
        findDisturbed();
        findCorners();
        findNoWayBack();
        return std::move(m_found);
    }

private:
    void add(const QString &headline, const QString &body, const WallHit &hit,
             const std::vector<int> &circles, bool isPosition = false)
    {
        const QString names = circleNames(circles, m_ground.flights.size());
        QString message = headline + QStringLiteral("\n\n") + body;
        message.replace(QLatin1String("%who"), names);
        m_found.push_back({Aspect::Walls,
                           message,
                           {hit.stage, std::max<qint64>(hit.step, 1), {hit.circle}, isPosition}});
    }

    [[nodiscard]] double blur() const { return std::max(m_own.blur, m_right.blur); }

    /// The hit of the reference in the same stage.
    [[nodiscard]] const WallHit &rightOf(std::size_t i) const { return m_right.hits[i]; }

    void findMissing()
    {
        std::vector<std::pair<int, std::set<Wall>>> open;
        const WallHit *first = nullptr;
        for (std::size_t i = 0; i < m_own.hits.size(); ++i) {
            const WallHit &hit = m_own.hits[i];
            if (hit.missed || hit.turned || hit.held || !rightOf(i).turned)
                continue;
            first = first ? first : &hit;
            if (open.empty() || open.back().first != hit.circle)
                open.push_back({hit.circle, {}});
            open.back().second.insert(hit.wall);
        }
        if (open.empty())
            return;
        const bool all = std::all_of(open.begin(), open.end(),
                                     [](const auto &each) { return each.second.size() == 4; });
        std::vector<int> circles;
        for (const auto &[circle, walls] : open)
            circles.push_back(circle);
        if (all) {
            add(WallText::tr("No wall turns %who round"),
                WallText::tr("Thrown at each of the four walls, %1 m/s fast, it goes on through "
                             "them. After every move each circle needs its questions: is its rim "
                             "past a wall?")
                    .arg(brief(
                        length(first->stage.preset.circles[static_cast<std::size_t>(first->circle)]
                                   .body.velocity))),
                *first, circles, true);
            return;
        }
        for (std::size_t i = 0; i < open.size(); ++i) {
            const auto &[circle, walls] = open[i];
            std::vector<int> same{circle};
            for (std::size_t j = i + 1; j < open.size(); ++j) {
                if (open[j].second == walls)
                    same.push_back(open[j].first);
            }
            std::erase_if(open, [&, w = walls, c = circle](const auto &each) {
                return each.first != c && each.second == w;
            });
            const auto at = std::find_if(m_own.hits.begin(), m_own.hits.end(), [&](const auto &h) {
                return h.circle == same.front() && !h.turned && !h.held && !h.missed;
            });
            add(WallText::tr("Nothing turns %who round here: %1").arg(namesOf(open[i].second)),
                WallText::tr("A circle that is thrown there leaves the square. A square has four "
                             "walls: look at the question that your "
                             "program asks for each."),
                *at, same, true);
        }
    }

    static QString namesOf(const std::set<Wall> &walls)
    {
        QStringList names;
        for (const Wall wall : walls)
            names.append(motion::wallName(wall));
        return names.join(QStringLiteral(", "));
    }

    /// A length that a program may take for the radius.
    struct Reach {
        std::function<double(const WallHit &)> distance;
        QString headline;
        QString body;
    };

    [[nodiscard]] bool fitsAll(const Reach &reach, int circle) const
    {
        return std::all_of(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &hit) {
            return hit.circle != circle || !(hit.turned || hit.held)
                   || hit.fits(reach.distance(hit));
        });
    }

    static std::vector<Reach> reaches()
    {
        const auto fixed = [](double length) {
            return [length](const WallHit &) { return length; };
        };
        return {
            {fixed(0.0), WallText::tr("At the walls the centre of %who is asked for, not the rim"),
             WallText::tr("It turns only when its centre is past the wall, with its rim one "
                          "radius, %1 m, outside. A wall meets a body where the body ends.")},
            {[](const WallHit &hit) { return hit.otherRadius; },
             WallText::tr("At the walls %who has the radius of another circle"),
             WallText::tr("Its radius is %1 m, and it turns when its centre is %2 m from the wall: "
                          "the radius of the other circle in that scene. Look at whose radius "
                          "stands in the questions.")},
            {fixed(0.2), WallText::tr("At the walls a number stands for the radius of %who"),
             WallText::tr("Its radius is %1 m in that scene, and yet it turns when its centre is "
                          "0.2 m from the wall. Take the radius that the circle has.")},
            {[](const WallHit &hit) { return 2.0 * hit.radius; },
             WallText::tr("The walls turn %who round too early"),
             WallText::tr("Its radius is %1 m, and it turns when its centre is %2 m from the wall: "
                          "twice the radius. From the centre to the rim it is one.")},
            {[](const WallHit &hit) { return -hit.radius; },
             WallText::tr("The walls turn %who round at the far side of the rim"),
             WallText::tr("It turns when its centre is one radius, %1 m, past the wall. Of its two "
                          "ends the near one touches first: look at the sign in front of the "
                          "radius.")}};
    }

    void findReach()
    {
        const Reach rim{[](const WallHit &hit) { return hit.radius; }, {}, {}};
        std::vector<std::pair<QString, std::vector<int>>> said;
        std::vector<std::pair<QString, const WallHit *>> bodies;
        for (const int circle : m_own.judged) {
            if (fitsAll(rim, circle))
                continue;
            const auto at = std::find_if(m_own.hits.begin(), m_own.hits.end(), [&](const auto &h) {
                return h.circle == circle && (h.turned || h.held) && !h.fits(h.radius);
            });
            if (!m_right.hits[static_cast<std::size_t>(at - m_own.hits.begin())].fits(at->radius))
                continue; // the reference does not turn at the rim either
            m_isElsewhere = true;
            const auto [headline, body] = reachWords(*at, circle);
            const auto same =
                std::find_if(said.begin(), said.end(),
                             [&, h = headline](const auto &s) { return s.first == h; });
            if (same != said.end()) {
                same->second.push_back(circle);
                continue;
            }
            said.push_back({headline, {circle}});
            bodies.push_back({body, &*at});
        }
        for (std::size_t i = 0; i < said.size(); ++i)
            add(said[i].first, bodies[i].first, *bodies[i].second, said[i].second);
    }

    [[nodiscard]] std::pair<QString, QString> reachWords(const WallHit &hit, int circle) const
    {
        for (const Reach &reach : reaches()) {
            if (fitsAll(reach, circle)) {
                QString body = reach.body;
                body.replace(QLatin1String("%1"), brief(hit.radius));
                body.replace(QLatin1String("%2"), brief(reach.distance(hit)));
                return {reach.headline, body};
            }
        }
        const bool early = hit.reached > hit.radius;
        return {early ? WallText::tr("The walls turn %who round too early")
                      : WallText::tr("The walls turn %who round too late"),
                WallText::tr("Its radius is %1 m, and at the %2 it turns when its centre is "
                             "between %3 and %4 m from the wall. It should turn when its rim is "
                             "there.")
                    .arg(brief(hit.radius), motion::wallName(hit.wall), brief(hit.reached),
                         brief(hit.before))};
    }

    void findAnswer()
    {
        std::vector<std::size_t> odd;
        for (std::size_t i = 0; i < m_own.hits.size(); ++i) {
            const WallHit &hit = m_own.hits[i];
            const WallHit &right = rightOf(i);
            // It may have come to another place, and have been hit there.
            if ((hit.isLeap() && !right.isLeap()) || (hit.kicks && !right.kicks))
                continue;
            if (hit.held && right.turned)
                odd.push_back(i);
            else if (hit.turned && right.turned
                     && (!isNear(hit.back, right.back, blur())
                         || !isNear(hit.along, right.along, blur())))
                odd.push_back(i);
        }
        if (odd.empty())
            return;
        std::set<int> circles;
        std::set<Wall> walls;
        for (const std::size_t i : odd) {
            circles.insert(m_own.hits[i].circle);
            walls.insert(m_own.hits[i].wall);
        }
        // The hit that shows most: one with losses, if those are what is wrong.
        const std::size_t at = *std::min_element(odd.begin(), odd.end(), [&](auto a, auto b) {
            const auto rank = [&](std::size_t i) {
                const double e = m_own.hits[i].restitution;
                return std::abs(e - 0.5);
            };
            return rank(a) < rank(b);
        });
        const WallHit &hit = m_own.hits[at];
        const WallHit &right = rightOf(at);
        const auto [headline, why] = answerWords(odd, hit, right);
        const QString where = walls.size() < wallsLike(hit)
                                  ? WallText::tr("So it is here: %1. ").arg(namesOf(walls))
                                  : QString();
        add(headline, seenAt(hit, right) + QLatin1Char(' ') + where + why, hit,
            {circles.begin(), circles.end()}, hit.held);
    }

    /// e is a word of the steps that ask for it.
    [[nodiscard]] bool rebounds() const { return m_ground.walls.restitutions.size() > 1; }

    [[nodiscard]] QString seenAt(const WallHit &hit, const WallHit &right) const
    {
        const Vec2 n = outwardNormal(hit.wall);
        const Vec2 t = perpendicular(n);
        const Vec2 good = -right.back * dot(hit.came, n) * n + right.along * dot(hit.came, t) * t;
        return (rebounds() ? WallText::tr("With e = %1: ").arg(brief(hit.restitution)) : QString())
               + WallText::tr("It came to the %1 with %2 m/s and left it with %3 m/s; %4 m/s is "
                              "right.")
                     .arg(motion::wallName(hit.wall), brief(hit.came), brief(hit.left),
                          brief(good));
    }

    /// At how many walls circles were shot under the same conditions as \p hit.
    [[nodiscard]] std::size_t wallsLike(const WallHit &hit) const
    {
        std::set<Wall> walls;
        for (std::size_t i = 0; i < m_own.hits.size(); ++i) {
            if (m_own.hits[i].restitution == hit.restitution && rightOf(i).turned)
                walls.insert(m_own.hits[i].wall);
        }
        return walls.size();
    }

    /// Whether the ratio \p part is \p law of the restitution in all hits by those circles and at
    /// those walls of which some are at \p odd.
    template <class Part, class Law>
    bool follows(const std::vector<std::size_t> &odd, Part part, Law law) const
    {
        return std::all_of(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &hit) {
            const bool isMeant = std::any_of(odd.begin(), odd.end(), [&](std::size_t i) {
                return m_own.hits[i].circle == hit.circle && m_own.hits[i].wall == hit.wall;
            });
            return !isMeant || hit.isLeap() || !(hit.turned || hit.held)
                   || isNear(part(hit), law(hit.restitution), blur());
        });
    }

    [[nodiscard]] std::pair<QString, QString>
    answerWords(const std::vector<std::size_t> &odd, const WallHit &hit, const WallHit &right) const
    {
        const auto back = [](const WallHit &h) { return h.back; };
        const auto along = [](const WallHit &h) { return h.along; };
        const auto one = [](double) { return 1.0; };
        const auto minusOne = [](double) { return -1.0; };
        const auto zero = [](double) { return 0.0; };
        const auto same = [](double e) { return e; };
        const QString normalOnly = WallText::tr("A smooth wall pushes along its normal only.");
        if (hit.held)
            return {WallText::tr("The walls hold %who and turn no velocity round"),
                    WallText::tr("It is put back in every step and runs into the wall again.")};
        if (follows(odd, back, minusOne) && follows(odd, along, minusOne))
            return {WallText::tr("The walls turn the wrong part of the velocity of %who"),
                    WallText::tr("The normal of the side walls points along x, that of floor and "
                                 "ceiling along y.")};
        if (follows(odd, along, [&](double e) { return rebounds() ? -e : -1.0; })
            && follows(odd, back, [&](double e) { return rebounds() ? e : 1.0; }))
            return {WallText::tr("The walls turn the whole velocity of %who round"), normalOnly};
        if (rebounds() && follows(odd, along, same) && follows(odd, back, same))
            return {WallText::tr("At the walls e also shortens the part of %who along the wall"),
                    normalOnly};
        if (rebounds() && follows(odd, along, same) && follows(odd, back, one))
            return {WallText::tr("At the walls e acts on the wrong part of the velocity of %who"),
                    normalOnly};
        if (follows(odd, along, minusOne))
            return {WallText::tr("The walls turn the part of %who along the wall round, too"),
                    normalOnly};
        if (follows(odd, along, zero))
            return {WallText::tr("The walls take the part of %who along the wall away"),
                    normalOnly};
        if (!isNear(hit.along, right.along, blur()))
            return {WallText::tr("The walls change the part of %who along the wall"), normalOnly};
        return backWords(odd, hit);
    }

    [[nodiscard]] std::pair<QString, QString> backWords(const std::vector<std::size_t> &odd,
                                                        const WallHit &hit) const
    {
        const auto back = [](const WallHit &h) { return h.back; };
        for (const BackLaw &law : backLaws()) {
            if ((rebounds() || !law.hasE) && follows(odd, back, law.back))
                return {law.headline, law.why};
        }
        const auto number = [&](double) { return hit.back; };
        if (odd.size() > 2 && rebounds() && follows(odd, back, number))
            return {
                WallText::tr("At the walls a number stands for e, for %who"),
                WallText::tr("Whatever e is, %1 of the speed comes back.").arg(brief(hit.back))};
        if (const auto speed = ownSpeed(odd))
            return {WallText::tr("The walls give %who a speed of their own"),
                    WallText::tr("However fast it comes, it leaves the wall with %1 m/s: work the "
                                 "new velocity out from the old one.")
                        .arg(brief(*speed))};
        if (hit.back < 0.0)
            return {WallText::tr("The walls do not turn %who round"),
                    WallText::tr("Its velocity still points into the wall: look at the sign.")};
        return {WallText::tr("The walls give %who %1 times the speed back").arg(brief(hit.back)),
                WallText::tr("Look at the factor in front of the part that you turn round.")};
    }

    /// What may stand where the speed that comes back does.
    struct BackLaw {
        double (*back)(double e);
        bool hasE; ///< it says something of e
        QString headline;
        QString why;
    };

    static std::vector<BackLaw> backLaws()
    {
        const QString look = WallText::tr("Look at the sign: the velocity still points into the "
                                          "wall.");
        return {{[](double) { return 1.0; }, true,
                 WallText::tr("The walls give %who all of the speed back"),
                 WallText::tr("e is not used at these walls.")},
                {[](double e) { return e * e; }, true,
                 WallText::tr("At the walls e acts on %who twice"),
                 WallText::tr("Heights go with e², speeds with e.")},
                {[](double e) { return std::sqrt(e); }, true,
                 WallText::tr("At the walls the root of e acts on %who"),
                 WallText::tr("Heights go with e², speeds with e.")},
                {[](double) { return 0.0; }, false, WallText::tr("The walls stop %who"),
                 WallText::tr("Nothing brings it back.")},
                {[](double e) { return 1.0 - e; }, true,
                 WallText::tr("At the walls 1 − e stands where e belongs, for %who"),
                 WallText::tr("1 − e is what is lost; e is what is left.")},
                {[](double e) { return 1.0 + e; }, true,
                 WallText::tr("The walls make %who faster: 1 + e stands where e belongs"),
                 WallText::tr("1 + e is the whole change of the velocity, e what comes back.")},
                {[](double) { return -1.0; }, false,
                 WallText::tr("The walls do not turn %who round"), look},
                {[](double e) { return -e; }, true,
                 WallText::tr("The walls slow %who and turn nothing round"), look}};
    }

    /// The speed that all leave a wall with, though they came with several.
    [[nodiscard]] std::optional<double> ownSpeed(const std::vector<std::size_t> &odd) const
    {
        const auto speedOf = [](Vec2 v, const WallHit &hit) {
            return std::abs(dot(v, outwardNormal(hit.wall)));
        };
        const WallHit &first = m_own.hits[odd.front()];
        const double left = speedOf(first.left, first);
        bool several = false;
        for (const std::size_t i : odd) {
            const WallHit &hit = m_own.hits[i];
            if (std::abs(speedOf(hit.left, hit) - left) > 0.02 * left)
                return std::nullopt;
            several |= std::abs(speedOf(hit.came, hit) / speedOf(first.came, first) - 1.0) > 0.1;
        }
        return several ? std::optional(left) : std::nullopt;
    }

    void findLeap()
    {
        for (std::size_t i = 0; i < m_own.hits.size(); ++i) {
            const WallHit &hit = m_own.hits[i];
            if (!hit.isLeap() || rightOf(i).isLeap())
                continue;
            add(WallText::tr("A hit at a wall puts %who somewhere else"),
                WallText::tr("At the %1 it was put %2 m away from its own path, at %3 m. Each "
                             "circle goes back to its *own* place: look at which old position it "
                             "gets.")
                    .arg(motion::wallName(hit.wall), brief(hit.leap), brief(hit.landed)),
                hit, {hit.circle}, true);
            return;
        }
    }

    void findDisturbed()
    {
        const auto disturbs = [](const WallHit &hit) { return hit.disturbs; };
        const auto at = std::find_if(m_own.hits.begin(), m_own.hits.end(), disturbs);
        const auto leaps = [](const WallHit &hit) { return hit.isLeap(); };
        if (at == m_own.hits.end() || std::any_of(m_own.hits.begin(), m_own.hits.end(), leaps)
            || std::any_of(m_right.hits.begin(), m_right.hits.end(), disturbs))
            return;
        add(WallText::tr("A hit of one circle at a wall also stops the other on its way"),
            WallText::tr("While %1 was answered by the %2, the other circle, far from every wall, "
                         "did not go on freely. Each circle is put back on its own: look at whose "
                         "positions your wall changes.")
                .arg(circleNames({at->circle}, 0), motion::wallName(at->wall)),
            *at, {at->circle}, true);
    }

    void findCorners()
    {
        // What a single wall does wrong a corner shows, too.
        if (!m_found.empty())
            return;
        for (std::size_t i = 0; i < m_own.corners.size(); ++i) {
            const WallHit &hit = m_own.corners[i];
            const WallHit &right = m_right.corners[i];
            if (!right.turnsBoth || hit.missed || !hit.turned || hit.turnsBoth)
                continue;
            add(WallText::tr("In a corner only one part of the velocity of %who turns round"),
                WallText::tr("It came with %1 m/s and left with %2 m/s, and the other part did "
                             "not turn round later. Both walls are hit in the same step, and the "
                             "second must go on from what the first has made, not from the "
                             "velocity before.")
                    .arg(brief(hit.came), brief(hit.left)),
                hit, {hit.circle});
            return;
        }
    }

    void findNoWayBack()
    {
        const bool rightTurns = std::any_of(m_right.drops.begin(), m_right.drops.end(),
                                            [](const Drop &drop) { return drop.again > 0; });
        for (std::size_t i = 0; i < m_own.hits.size(); ++i) {
            const WallHit &hit = m_own.hits[i];
            if (hit.again == 0 || rightOf(i).again > 0)
                continue;
            addAgain(hit.circle, hit.stage, hit.step);
            return;
        }
        for (std::size_t i = 0; i < m_own.drops.size(); ++i) {
            const Drop &drop = m_own.drops[i];
            if (drop.again > 0 && !rightTurns) {
                addAgain(drop.circle, drop.stage, drop.step);
                return;
            }
            // A floor that gives all back is not asked to hold what lies on it.
            if (!rebounds() || drop.restitution == 1.0)
                continue;
            // Deeper than what a few steps of gravity can hide.
            const double deep = 0.02;
            if (drop.sinks && drop.depth > deep && m_right.drops[i].depth < deep && m_found.empty()
                && !m_isElsewhere) {
                m_found.push_back(
                    {Aspect::Course,
                     WallText::tr("The floor does not hold circle %1 up\n\nAfter %2 s near the "
                                  "floor its rim is %3 m below it: it turns, but nothing puts it "
                                  "back, and gravity pulls it deeper in every step. Put the circle "
                                  "back where it touches.")
                         .arg(drop.circle + 1)
                         .arg(brief(static_cast<double>(drop.step) * drop.stage.preset.timestep),
                              brief(drop.depth)),
                     {drop.stage, drop.step, {drop.circle}, true}});
                return;
            }
        }
    }

    void addAgain(int circle, const Stage &stage, qint64 step)
    {
        // Who turns at another place than the rim may be outside still for that reason alone.
        if (m_isElsewhere)
            return;
        m_found.push_back(
            {Aspect::Walls,
             WallText::tr("Circle %1 is turned round again while it leaves the wall\n\nIts rim was "
                          "still outside, it moved inward already, and it was turned into the wall "
                          "once more (step %2 of a low drop or slow shot). Put it back inside, or "
                          "ask which way it moves before you turn it.")
                 .arg(circle + 1)
                 .arg(step),
             {stage, step, {circle}, false}});
    }

    const MeasuredWalls &m_own;
    const MeasuredWalls &m_right;
    const Ground &m_ground;
    std::vector<LawDeviation> m_found;
    bool m_isElsewhere = false; ///< walls turn circles at another place than the rim
};

/// What \p law says of \p circles.
MeasuredWalls only(MeasuredWalls law, const std::vector<int> &circles)
{
    const auto isOther = [&](const auto &seen) {
        return std::find(circles.begin(), circles.end(), seen.circle) == circles.end();
    };
    std::erase_if(law.hits, isOther);
    std::erase_if(law.corners, isOther);
    std::erase_if(law.drops, isOther);
    std::erase_if(law.judged, [&](int circle) {
        return std::find(circles.begin(), circles.end(), circle) == circles.end();
    });
    return law;
}

} // namespace

std::vector<LawDeviation> wallDeviations(const MeasuredWalls &own, const MeasuredWalls &right,
                                         const Ground &ground)
{
    const auto [mine, theirs] = std::pair(only(own, right.judged), only(right, own.judged));
    if (mine.judged.empty())
        return {};
    return WallJudge(mine, theirs, ground).judge();
}

} // namespace cradle
