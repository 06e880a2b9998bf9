// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/changed_walls.h"
#include "tests/lab_test.h"
#include "tests/told_deviations.h"

#include "tasks/judging/measured_laws.h"
#include "tasks/judging/wall_words.h"

using namespace cradle;
using namespace cradle::approved;

/// What is said of hits at walls that no program made: those of the reference answered by other
/// laws, some of them by others than the rest, with numbers changed a little or much. Hashes of
/// what is said of each law, and how often each headline is, are in tests/approved/wall-hits.txt.
class TestApprovedWallHits : public QObject
{
    Q_OBJECT
private slots:
    void whatIsSaidOfHitsIsAsApproved();
};

namespace {

using Group = std::vector<WallHit *>;

/// All hits, part by part, wall by wall and circle by circle.
std::vector<Group> groupsOf(MeasuredWalls &walls)
{
    std::vector<Group> parts;
    for (auto *hits : {&walls.hits, &walls.corners, &walls.slow, &walls.alike, &walls.denser,
                       &walls.slower, &walls.slanted, &walls.far, &walls.middle}) {
        Group part;
        for (WallHit &hit : *hits)
            part.push_back(&hit);
        parts.push_back(part);
    }
    std::vector<Group> groups = parts;
    for (const Wall wall : allWalls) {
        for (int circle = -1; circle < 2; ++circle) {
            Group group;
            for (const Group &part : parts)
                std::copy_if(part.begin(), part.end(), std::back_inserter(group),
                             [&](const WallHit *hit) {
                                 return hit->wall == wall && (circle < 0 || hit->circle == circle);
                             });
            groups.push_back(std::move(group));
        }
    }
    std::erase_if(groups, [](const Group &group) { return group.empty(); });
    return groups;
}

/// What is measured only of a program that answers some hits wrongly.
void addWhatIsMeasuredOfWrong(MeasuredWalls &walls, Draws &draws)
{
    for (auto *hits : {&walls.denser, &walls.slower, &walls.slanted, &walls.far, &walls.middle}) {
        if (draws.oneOf(3))
            *hits = walls.slow;
    }
    for (WallHit &hit : walls.slower)
        hit.came = 0.6 * hit.came, hit.left = 0.6 * hit.left;
    for (WallHit &hit : walls.slanted)
        leaveWith(hit, hit.back, hit.along);
    if (draws.oneOf(3)) {
        walls.alike = walls.hits;
        for (WallHit &hit : walls.alike)
            hit.otherRadius = hit.radius;
    }
    if (draws.oneOf(20) && !walls.hits.empty())
        walls.lent.push_back({walls.hits.front(), 1});
    if (!walls.drops.empty() && draws.oneOf(10)) {
        Drop &drop = walls.drops[draws.below(walls.drops.size())];
        drop.again = int(draws.below(3));
        drop.isAgainAnew = draws.oneOf(2);
        drop.depth = std::abs(draws.amount());
        drop.sinks = draws.oneOf(2);
    }
    if (draws.oneOf(20))
        walls.blur = std::abs(draws.amount());
}

/// Steps that are not those of free flight, before a hit or after it.
void addSteps(const Group &hits, Draws &draws)
{
    const double by = draws.amount();
    const bool isBefore = draws.oneOf(2);
    const bool isAnewSo = draws.oneOf(2);
    for (WallHit *hit : hits) {
        (isBefore ? hit->near : hit->unchanged) = strayStep(*hit, by);
        hit->isAnewSo = isAnewSo;
    }
}

/// Some hits by \p law, and some of their numbers changed.
MeasuredWalls changed(const MeasuredWalls &right, const WallAnswer &law, Draws &draws)
{
    MeasuredWalls own = right;
    addWhatIsMeasuredOfWrong(own, draws);
    const std::vector<Group> groups = groupsOf(own);
    for (WallHit *hit : draws.someOf(groups))
        law.answer(*hit);
    if (draws.oneOf(4)) {
        const WallAnswer &other = wallAnswers[draws.below(std::size(wallAnswers))];
        for (WallHit *hit : draws.someOf(groups))
            other.answer(*hit);
    }
    if (!draws.oneOf(6)) {
        const std::size_t which = draws.below(wallNumbers);
        const double by = draws.amount();
        for (WallHit *hit : draws.someOf(groups))
            changeNumber(*hit, which, by);
    }
    if (draws.oneOf(5)) {
        const std::size_t which = draws.below(wallFacts);
        for (WallHit *hit : draws.someOf(groups))
            changeFact(*hit, which);
    }
    if (draws.oneOf(12))
        addSteps(draws.someOf(groups), draws);
    return own;
}

} // namespace

void TestApprovedWallHits::whatIsSaidOfHitsIsAsApproved()
{
    ToldDeviations told(QStringLiteral("wall-hits.txt"));
    unsigned seed = 0;
    for (const auto &[folder, step] :
         {std::pair(shippedLab, "L42T17"), std::pair(shippedLab, "L42T5"),
          std::pair(shippedLab, "L42T7"), std::pair(bouncingBallLab, "BALL2")}) {
        const Lab lab = *readLab(QLatin1String(folder));
        const Task &task = lab.tasks[std::size_t(lab.indexOf(QLatin1String(step)))];
        const Ground ground(task, task.preset);
        const MeasuredLaws laws(&task.solution, ground);
        const MeasuredWalls &right = laws.walls();
        for (const WallAnswer &law : wallAnswers) {
            Draws draws(++seed);
            for (int i = 0; i < 150; ++i) {
                const MeasuredWalls own = changed(right, law, draws);
                told.add(wallDeviations(own, right, ground));
                if (const auto late = lateInCorner(own, right, ground))
                    told.add({*late});
                told.add(own.isLike(right));
            }
            const QString odd = told.endPart(task.id + QLatin1Char(' ') + QLatin1String(law.name));
            QVERIFY2(odd.isEmpty(), qPrintable(odd));
        }
    }
    const QString difference = told.end();
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

QTEST_GUILESS_MAIN(TestApprovedWallHits)
#include "test_approved_wall_hits.moc"
