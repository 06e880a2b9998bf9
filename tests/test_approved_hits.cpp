// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/changed_hits.h"
#include "tests/lab_test.h"
#include "tests/told_deviations.h"

#include "tasks/judging/measured_laws.h"
#include "tasks/judging/pair_words.h"

using namespace cradle;
using namespace cradle::approved;

/// What is said of hits of two circles that no program made: those of the reference answered by
/// other laws, some of them by others than the rest, with numbers changed a little or much. Hashes
/// of what is said of each law, and how often each headline is, are in tests/approved/hits.txt.
class TestApprovedHits : public QObject
{
    Q_OBJECT
private slots:
    void whatIsSaidOfHitsIsAsApproved();
};

namespace {

using Group = std::vector<PairHit *>;

/// All hits, part by part.
std::vector<Group> groupsOf(MeasuredPair &pair)
{
    std::vector<Group> groups;
    const auto add = [&](Group group) {
        if (!group.empty())
            groups.push_back(std::move(group));
    };
    for (auto *hits :
         {&pair.contacts, &pair.otherRadii, &pair.modes, &pair.equals, &pair.radii, &pair.sizes,
          &pair.densities, &pair.rebounds, &pair.inSteps, &pair.partings, &pair.varied}) {
        Group group;
        for (PairHit &hit : *hits)
            group.push_back(&hit);
        add(std::move(group));
    }
    for (auto *hit : {&pair.larger, &pair.twice, &pair.own, &pair.ownTurned, &pair.ranThroughAnew,
                      &pair.opposite, &pair.slow, &pair.fast, &pair.returning}) {
        if (*hit)
            add({&**hit});
    }
    if (pair.later) {
        add({&pair.later->first});
        add({&pair.later->second});
        add({&pair.later->anew});
    }
    if (pair.spread)
        add({&pair.spread->first, &pair.spread->last});
    return groups;
}

Vec2 turned(Vec2 v, double angle)
{
    return std::cos(angle) * v + std::sin(angle) * perpendicular(v);
}

/// Changes a number of a hit.
void changeNumber(PairHit &hit, std::size_t which, double by)
{
    const Vec2 n = hit.normal;
    switch (which) {
    case 0:
        hit.left1 += by * n;
        break;
    case 1:
        hit.left1 += by * perpendicular(n);
        break;
    case 2:
        hit.left2 += by * n;
        break;
    case 3:
        hit.left2 += by * perpendicular(n);
        break;
    case 4:
        hit.left1 = hit.came1 + (1.0 + by) * hit.push1();
        break;
    case 5:
        hit.left2 = hit.came2 + (1.0 + by) * hit.push2();
        break;
    case 6:
        hit.left1 = hit.came1 + (1.0 + by) * hit.push1();
        hit.left2 = hit.came2 + (1.0 + by) * hit.push2();
        break;
    case 7:
        hit.left1 = (1.0 + by) * hit.left1, hit.left2 = (1.0 + by) * hit.left2;
        break;
    case 8:
        hit.before += by;
        break;
    case 9:
        hit.reached += by;
        break;
    case 10:
        hit.before += by, hit.reached += by;
        break;
    case 11:
        hit.after += by;
        break;
    case 12:
        hit.normal = turned(n, by);
        break;
    case 13:
        hit.nextNormal = turned(hit.nextNormal, by);
        break;
    case 14:
        hit.left1 = hit.came1 + turned(hit.push1(), by);
        hit.left2 = hit.came2 + turned(hit.push2(), by);
        break;
    case 15:
        hit.came1 += by * n;
        break;
    case 16:
        hit.came2 += by * perpendicular(n);
        break;
    case 17:
        hit.left1 += by * hit.came2, hit.left2 += by * hit.came1;
        break;
    case 18:
        answer(hit, n, hit.meeting.restitution + by);
        break;
    case 19:
        hit.slowness *= 1.0 + by;
        break;
    default:
        break;
    }
}
constexpr std::size_t numbers = 20;

/// Changes what is known of a hit besides numbers.
void changeFact(PairHit &hit, std::size_t which)
{
    bool *const facts[] = {&hit.answered, &hit.parting,     &hit.moved1,  &hit.moved2,
                           &hit.stopped,  &hit.late,        &hit.again,   &hit.afterRest,
                           &hit.anew,     &hit.partsInside, &hit.isAtOnce};
    if (which < std::size(facts))
        *facts[which] = !*facts[which];
    else if (which < std::size(facts) + 2)
        hit.leaper = int(which - std::size(facts));
    else if (which == std::size(facts) + 2)
        hit.misplaced = Misplacement{Misplacement::Where::Away, 0.3};
    else
        hit.step += 1;
}
constexpr std::size_t facts = 15;

/// What is measured only of a program that answers some hits wrongly.
void addWhatIsMeasuredOfWrong(MeasuredPair &pair, Draws &draws)
{
    if (draws.oneOf(3)) {
        pair.otherRadii = pair.contacts;
        for (PairHit &hit : pair.otherRadii)
            hit.meeting.radius1 = 0.3, hit.meeting.radius2 = 0.15, meetAt(hit, 0.45);
    }
    if (draws.oneOf(4)) {
        for (const auto *hits : {&pair.modes, &pair.equals, &pair.contacts, &pair.radii})
            pair.varied.insert(pair.varied.end(), hits->begin(), hits->end());
    }
    if (draws.oneOf(20) && !pair.inSteps.empty()) {
        const PairHit &whole = pair.inSteps.front();
        pair.spread = SpreadPush{whole, whole};
        pair.spread->first.left1 = whole.came1 + 0.25 * whole.push1();
        pair.spread->first.left2 = whole.came2 + 0.25 * whole.push2();
    }
    pair.ownContacts = draws.oneOf(8) ? int(draws.below(4)) : pair.ownContacts;
    pair.ranThrough = draws.oneOf(20);
    pair.ranThroughAtOnce = pair.ranThrough && draws.oneOf(3);
    pair.areOfParting = draws.oneOf(20);
    if (pair.ranThrough && draws.oneOf(2))
        pair.ranThroughAnew = pair.equals.empty() ? pair.contacts.front() : pair.equals.front();
    if (pair.own && draws.oneOf(10))
        pair.ownTurned = pair.own;
}

/// New parts of some hits that are sums of old ones, turned and lengthened pushes, or distances
/// that are sums of radii.
void answerOtherwise(const Group &hits, Draws &draws)
{
    constexpr double factors[] = {0.0, 1.0, -1.0, 0.0, 0.5, 2.0, 0.0, 1.0, -0.5, 3.0};
    const auto factor = [&] { return factors[draws.below(std::size(factors))]; };
    if (draws.oneOf(2)) {
        double of[8];
        for (double &each : of)
            each = factor();
        const bool isOfE = draws.oneOf(3);
        for (PairHit *hit : hits) {
            const PairVelocities in = hit->cameParts();
            const double e = isOfE ? hit->meeting.restitution : 1.0;
            const Vec2 n = hit->normal;
            const Vec2 across = perpendicular(n);
            hit->left1 = e * (of[0] * in.along1 + of[1] * in.along2) * n
                         + (of[2] * in.across1 + of[3] * in.across2) * across;
            hit->left2 = e * (of[4] * in.along1 + of[5] * in.along2) * n
                         + (of[6] * in.across1 + of[7] * in.across2) * across;
        }
        return;
    }
    if (draws.oneOf(2)) {
        const double of1 = factor(), of2 = factor(), besides = 0.1 * factor();
        const double ofX = factor(), ofY = factor();
        const bool isOfLine = draws.oneOf(3);
        for (PairHit *hit : hits) {
            const Meeting &m = hit->meeting;
            const double line = std::abs(ofX * hit->normal.x + ofY * hit->normal.y);
            meetAt(*hit, (of1 * m.radius1 + of2 * m.radius2 + besides)
                             / (isOfLine ? std::max(line, 0.05) : 1.0));
        }
        return;
    }
    const double angle = std::atan(1.0) * double(draws.below(8));
    const double power = double(draws.below(5)) - 2.0;
    const std::size_t which = draws.below(4);
    for (PairHit *hit : hits) {
        const double base = which == 0   ? 0.5 * (hit->before + hit->reached)
                            : which == 1 ? hit->meeting.radius1
                            : which == 2 ? hit->meeting.density1
                                         : hit->meeting.restitution + 0.5;
        answer(*hit, std::pow(base, power) * turned(hit->normal, angle), hit->meeting.restitution);
    }
}

/// Some hits by \p law, and some of their numbers changed.
MeasuredPair changed(const MeasuredPair &right, const HitLaw &law, Draws &draws)
{
    MeasuredPair own = right;
    addWhatIsMeasuredOfWrong(own, draws);
    const std::vector<Group> groups = groupsOf(own);
    for (PairHit *hit : draws.someOf(groups))
        law.answer(*hit);
    if (draws.oneOf(4)) {
        const HitLaw &other = hitLaws[draws.below(std::size(hitLaws))];
        for (PairHit *hit : draws.someOf(groups))
            other.answer(*hit);
    }
    if (draws.oneOf(5))
        answerOtherwise(draws.someOf(groups), draws);
    if (!draws.oneOf(6)) {
        const std::size_t which = draws.below(numbers);
        const double by = draws.amount();
        for (PairHit *hit : draws.someOf(groups))
            changeNumber(*hit, which, by);
    }
    if (draws.oneOf(5)) {
        const std::size_t which = draws.below(facts);
        for (PairHit *hit : draws.someOf(groups))
            changeFact(*hit, which);
    }
    return own;
}

} // namespace

void TestApprovedHits::whatIsSaidOfHitsIsAsApproved()
{
    const Lab lab = *readLab(QLatin1String(shippedLab));
    ToldDeviations told(QStringLiteral("hits.txt"));
    unsigned seed = 0;
    for (const char *step : {"L42T17", "L42T12", "L42T8"}) {
        const Task &task = lab.tasks[std::size_t(lab.indexOf(QLatin1String(step)))];
        const Ground ground(task, task.preset);
        const MeasuredLaws laws(&task.solution, ground);
        const MeasuredPair &right = laws.pair();
        QVERIFY(right.isJudged);
        for (const HitLaw &law : hitLaws) {
            Draws draws(++seed);
            for (int i = 0; i < 200; ++i) {
                const MeasuredPair own = changed(right, law, draws);
                told.add(contactDeviations(own, right, ground));
                told.add(responseDeviations(own, right, ground));
                told.add(own.contactIsLike(right));
                told.add(own.sequelIsLike(right));
                told.add(own.responseIsLike(right));
            }
            const QString odd = told.endPart(task.id + QLatin1Char(' ') + QLatin1String(law.name));
            QVERIFY2(odd.isEmpty(), qPrintable(odd));
        }
    }
    const QString difference = told.end();
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

QTEST_GUILESS_MAIN(TestApprovedHits)
#include "test_approved_hits.moc"
