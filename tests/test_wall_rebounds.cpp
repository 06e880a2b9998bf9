// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_rebound_words.h"

#include "tests/made_walls.h"

#include <QTest>

using namespace cradle;
using MadeLaw = cradle::made::WallLaw;

/// What is said of what walls give back, of hits that were made up with a law of e.
class TestWallRebounds : public QObject
{
    Q_OBJECT
private slots:
    void lawIsTold_data();
    void lawIsTold();
    void withoutLossesIsTold_data();
    void withoutLossesIsTold();
    void lawsAreTriedToABlur();
    void velocityOfTheOtherIsTold();
    void partAlongTimesEIsTold();
    void ownSpeedIsOneSpeed();
    void heldIsTold();
};

namespace {

QString utf8(const char *text)
{
    return QString::fromUtf8(text);
}

std::function<double(double)> constant(double value)
{
    return [value](double) { return value; };
}

/// Those that do not come out as they should.
ReboundWords wordsOf(const MeasuredWalls &own, const MeasuredWalls &right, const Ground &ground)
{
    std::vector<std::size_t> odd;
    for (std::size_t i = 0; i < own.hits.size(); ++i) {
        if (length(own.hits[i].left - right.hits[i].left) > 1e-9 || own.hits[i].held)
            odd.push_back(i);
    }
    return odd.empty() ? ReboundWords{}
                       : reboundWords(WallComparison(own, right, ground), odd, odd.front());
}

ReboundWords wordsOf(const MadeLaw &law, bool hasE = true)
{
    return wordsOf(made::wallsOf(law, hasE), made::wallsOf({}, hasE), made::wallGround(hasE));
}

} // namespace

void TestWallRebounds::lawIsTold_data()
{
    QTest::addColumn<MadeLaw>("law");
    QTest::addColumn<QString>("headline");
    QTest::addColumn<bool>("isLaw");
    const auto row = [](const char *headline, const MadeLaw &law, bool isLaw = true) {
        QTest::newRow(headline) << law << utf8(headline) << isLaw;
    };
    const auto same = [](double e) { return e; };
    const auto minus = [](double e) { return -e; };
    row("Hits at the %walls turn the wrong part of the velocity of %who",
        {constant(-1.0), constant(-1.0)});
    row("Hits at the %walls turn the whole velocity of %who round", {same, minus});
    row("At the %walls e also shortens the part of %who along the wall", {same, same});
    row("At the %walls e acts on the wrong part of the velocity of %who", {constant(1.0), same});
    row("Hits at the %walls turn the part of %who along the wall round, too",
        {same, constant(-1.0)});
    row("Hits at the %walls take the part of %who along the wall away", {same, constant(0.0)});
    row("Hits at the %walls give %who 0.7 times the whole velocity back",
        {constant(0.7), constant(0.7)});
    row("Hits at the %walls change the part of %who along the wall", {same, constant(0.7)}, false);
    row("Hits at the %walls give %who all of the speed back", {constant(1.0)});
    row("At the %walls e acts on %who twice", {[](double e) { return e * e; }});
    row("At the %walls the root of e acts on %who", {[](double e) { return std::sqrt(e); }});
    row("Hits at the %walls take the part of %who along the normal away", {constant(0.0)});
    row("At the %walls 1 − e stands where e belongs, for %who", {[](double e) { return 1.0 - e; }});
    row("At the %walls 1 + e stands where e belongs, for %who", {[](double e) { return 1.0 + e; }});
    row("Hits at the %walls leave %who moving outward", {constant(-1.0)});
    row("Hits at the %walls slow %who and turn nothing round", {minus});
    row("At the %walls a number stands for e, for %who", {constant(0.7)});
    row("Hits at the %walls give %who 0.7 e of the speed back, not e",
        {[](double e) { return 0.7 * e; }});
    row("Hits at the %walls give %who another share of the speed than e",
        {[](double e) { return e == 1.0   ? 1.0
                               : e == 0.5 ? 0.3
                                          : 0.6; }}, false);
}

void TestWallRebounds::lawIsTold()
{
    QFETCH(MadeLaw, law);
    const ReboundWords words = wordsOf(law);
    QTEST(words.headline, "headline");
    QTEST(words.isLaw, "isLaw");
}

void TestWallRebounds::withoutLossesIsTold_data()
{
    QTest::addColumn<double>("fast"); // of the speed, of the fast ones
    QTest::addColumn<double>("slow");
    QTest::addColumn<double>("along");
    QTest::addColumn<QString>("headline");
    const auto row = [](const char *headline, double fast, double slow, double along = 1.0) {
        QTest::newRow(headline) << fast << slow << along << utf8(headline);
    };
    row("Hits at the %walls give %who 0.7 times the speed back", 0.7, 0.7);
    row("Hits at the %walls give %who between 0.6 and 0.9 times the speed back", 0.6, 0.9);
    row("Hits at the %walls leave %who moving outward", -0.6, -0.9);
    row("Hits at the %walls give %who a speed of their own", 0.4, 1.0);
    row("Hits at the %walls turn the whole velocity of %who round", 1.0, 1.0, -1.0);
    row("Hits at the %walls take the part of %who along the wall away", 1.0, 1.0, 0.0);
    row("Hits at the %walls change the part of %who along the wall", 1.0, 1.0, 0.7);
}

void TestWallRebounds::withoutLossesIsTold()
{
    QFETCH(double, fast);
    QFETCH(double, slow);
    QFETCH(double, along);
    const MeasuredWalls right = made::wallsOf({}, false);
    MeasuredWalls own = right;
    for (WallHit &hit : own.hits)
        made::give(hit, dot(hit.came, outwardNormal(hit.wall)) > 1.0 ? fast : slow, along);
    // Of those that come out right, too, but for the last: all have this speed.
    std::vector<std::size_t> odd(own.hits.size());
    for (std::size_t i = 0; i < odd.size(); ++i)
        odd[i] = i;
    const Ground ground = made::wallGround(false);
    const ReboundWords words = reboundWords(WallComparison(own, right, ground), odd, 0);
    QTEST(words.headline, "headline");
}

/// A thousandth of the speed, and of what comes back of it.
void TestWallRebounds::lawsAreTriedToABlur()
{
    const QString twice = utf8("At the %walls e acts on %who twice");
    for (const double sign : {-1.0, 1.0}) {
        const auto law = [sign](double off) -> MadeLaw {
            return {[=](double e) { return e * e + (e == 0.5 ? sign * off : 0.0); }};
        };
        QCOMPARE(wordsOf(law(1.2e-3)).headline, twice);
        QVERIFY(wordsOf(law(1.3e-3)).headline != twice);
    }
}

/// To 0.02 m/s, where it had several speeds.
void TestWallRebounds::velocityOfTheOtherIsTold()
{
    const QString headline = utf8("At the %walls %who gets the velocity of the other circle");
    const MeasuredWalls right = made::wallsOf({});
    const auto saidOf = [&](double off, double more, bool disturbs = false) {
        MeasuredWalls own = right;
        for (std::size_t i = 0; i < own.hits.size(); ++i) {
            WallHit &hit = own.hits[i];
            const Vec2 n = outwardNormal(hit.wall);
            const double other = i == 3 ? 0.33 + more : 0.33;
            hit.otherFree.velocity = other * n + 0.1 * perpendicular(n);
            hit.left = -(other + off) * n + dot(hit.came, perpendicular(n)) * perpendicular(n);
            hit.back = (other + off) / dot(hit.came, n);
            hit.disturbs = disturbs;
        }
        return wordsOf(own, right, made::wallGround()).headline;
    };
    QCOMPARE(saidOf(0.0, 0.06), headline);
    QCOMPARE(saidOf(0.018, 0.06), headline);
    QCOMPARE(saidOf(-0.018, -0.06), headline);
    QVERIFY(saidOf(0.022, 0.06) != headline);
    QVERIFY(saidOf(-0.022, 0.06) != headline);
    QVERIFY(saidOf(0.0, 0.04) != headline);
    QVERIFY(saidOf(0.0, -0.04) != headline);
    QVERIFY(saidOf(0.0, 0.06, true) != headline);
}

/// Who turns the part along the wall round, times e, has the parts mixed up.
void TestWallRebounds::partAlongTimesEIsTold()
{
    const QString headline = utf8("At the %walls the parts of the velocity of %who are mixed up");
    const MeasuredWalls right = made::wallsOf({});
    const auto saidOf = [&](double factor) {
        MeasuredWalls own = right;
        for (WallHit &hit : own.hits) {
            const Vec2 n = outwardNormal(hit.wall);
            const double along = std::abs(dot(hit.came, perpendicular(n)));
            made::give(hit, factor * hit.restitution * along / dot(hit.came, n), 1.0);
        }
        return wordsOf(own, right, made::wallGround()).headline;
    };
    QCOMPARE(saidOf(1.0), headline);
    QVERIFY(saidOf(1.2) != headline);
}

/// To a fiftieth, of speeds that differ by more than a tenth.
void TestWallRebounds::ownSpeedIsOneSpeed()
{
    const QString headline = utf8("Hits at the %walls give %who a speed of their own");
    const MeasuredWalls right = made::wallsOf({}, false);
    const auto saidOf = [&](double off, double others) {
        MeasuredWalls own = right;
        for (std::size_t i = 0; i < own.hits.size(); ++i) {
            WallHit &hit = own.hits[i];
            const Vec2 n = outwardNormal(hit.wall);
            if (others > 0.0)
                hit.came = (i == 3 ? others * 1.5 : 1.5) * n;
            const double left = i == 2 ? 0.8 * (1.0 + off) : 0.8;
            made::give(hit, left / dot(hit.came, n), 1.0);
        }
        return wordsOf(own, right, made::wallGround(false)).headline;
    };
    QCOMPARE(saidOf(0.0, 0.0), headline);
    QCOMPARE(saidOf(0.019, 0.0), headline);
    QCOMPARE(saidOf(-0.019, 0.0), headline);
    QVERIFY(saidOf(0.021, 0.0) != headline);
    QVERIFY(saidOf(-0.021, 0.0) != headline);
    QCOMPARE(saidOf(0.0, 1.11), headline);
    QCOMPARE(saidOf(0.0, 0.89), headline);
    QVERIFY(saidOf(0.0, 1.09) != headline);
    QVERIFY(saidOf(0.0, 0.91) != headline);
}

void TestWallRebounds::heldIsTold()
{
    const MeasuredWalls right = made::wallsOf({});
    MeasuredWalls own = right;
    for (const bool stays : {false, true}) {
        own.hits[0].turned = false;
        own.hits[0].held = true;
        own.hits[0].stays = stays;
        const ReboundWords words = wordsOf(own, right, made::wallGround());
        QCOMPARE(words.headline, utf8("Hits at the %walls hold %who and turn no velocity round"));
        QCOMPARE(words.why.contains(utf8("In every step")), stays);
    }
    own.hits[0].goesBack = true;
    QCOMPARE(wordsOf(own, right, made::wallGround()).headline,
             utf8("At the %walls the way of %who turns round, not its velocity"));
    own.hits[0].turnsLater = 2;
    own.hits[0].stage.preset.timestep = 0.01;
    const ReboundWords words = wordsOf(own, right, made::wallGround());
    QCOMPARE(words.headline, utf8("Hits at the %walls turn the velocity of %who round too late"));
    QVERIFY(words.why.contains(utf8("away from the wall only 0.02 s later.")));
}

QTEST_GUILESS_MAIN(TestWallRebounds)
#include "test_wall_rebounds.moc"
