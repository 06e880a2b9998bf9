// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_words.h"

#include "tests/made_walls.h"

#include <QTest>

using namespace cradle;
using namespace cradle::made;

/// Two programs, of which the second is right, and what is done to the first.
struct BothWalls {
    MeasuredWalls own;
    MeasuredWalls right;
    Ground ground;
};
using WallSpoil = std::function<void(BothWalls &)>;
using WallReach = std::function<double(const WallHit &)>;

/// What is said of where walls turn circles and where they put them, of hits that were made up.
class TestWallPlaces : public QObject
{
    Q_OBJECT
private slots:
    void faultIsTold_data();
    void faultIsTold();
    void reachIsTold_data();
    void reachIsTold();
};

namespace {

QString utf8(const char *text)
{
    return QString::fromUtf8(text);
}

BothWalls rightWalls()
{
    BothWalls both{made::wallsOf({}), made::wallsOf({}), made::wallGround()};
    // One that is larger than the other circle, and three that are smaller.
    for (std::size_t i = 1; i < both.own.hits.size(); i += 3) {
        for (MeasuredWalls *walls : {&both.own, &both.right}) {
            WallHit &hit = walls->hits[i];
            hit.radius = 0.28;
            hit.otherRadius = 0.15;
            hit.before = hit.after = 0.285;
            hit.reached = hit.before - hit.travel;
        }
    }
    return both;
}

void turnAt(WallHit &hit, double distance)
{
    hit.before = distance + 0.005;
    hit.reached = hit.before - hit.travel;
    hit.after = hit.before;
}

void open(WallHit &hit)
{
    hit.turned = false;
    hit.left = hit.came;
}

} // namespace

void TestWallPlaces::faultIsTold_data()
{
    QTest::addColumn<WallSpoil>("spoil");
    QTest::addColumn<QString>("headline"); // empty: nothing is said
    QTest::addColumn<QString>("body");
    int rows = 0;
    const auto row = [&rows](const char *headline, const WallSpoil &spoil, const char *body = "") {
        QTest::addRow("%d. %s", ++rows, headline) << spoil << utf8(headline) << utf8(body);
    };
    row("", [](BothWalls &) {});
    const char *const restarted = "Hits at the left wall put circle 1 back to the start of the run";
    row(restarted, [](BothWalls &w) { w.own.hits[0].landed = {-1.0, 2.0}; });
    row(restarted, [](BothWalls &w) { w.own.hits[0].landed = {-1.0 + 0.9e-9, 2.0}; });
    row("", [](BothWalls &w) { w.own.hits[0].landed = {-1.0 + 1.1e-9, 2.0}; });
    row(restarted, [](BothWalls &w) {
        w.own.hits[0].landed = {-1.0, 2.0};
        w.own.hits[0].step = 3;
    });
    row("", [](BothWalls &w) {
        w.own.hits[0].landed = {-1.0, 2.0};
        w.own.hits[0].step = 2;
    });
    row("", [](BothWalls &w) { w.own.hits[0].landed = w.right.hits[0].landed = {-1.0, 2.0}; });
    // Farther than four steps of 0.025 m and one and a half radii of 0.2 m.
    row("Hits at the left wall put circle 1 somewhere else",
        [](BothWalls &w) { w.own.hits[0].leap = 0.401; });
    row("", [](BothWalls &w) { w.own.hits[0].leap = 0.399; });
    row("", [](BothWalls &w) { w.own.hits[0].leap = w.right.hits[0].leap = 0.401; });
    const auto putAt = [](double after) -> WallSpoil {
        return [after](BothWalls &w) { w.own.hits[0].after = after; };
    };
    // It would have come to 0.18 m.
    const char *const out = "Hits at the left wall put circle 1 further out";
    row(out, putAt(0.17));
    row(out, putAt(0.18 - 1.2e-6));
    row("", putAt(0.18 - 0.8e-6));
    row("", [](BothWalls &w) { w.own.hits[0].after = w.right.hits[0].after = 0.17; });
    // It was at 0.205 m, and goes 0.025 m in a step; a millimetre is borne.
    const char *const in = "Hits at the left wall put circle 1 too far in";
    row(in, putAt(0.2315));
    row("", putAt(0.2305));
    row("", [](BothWalls &w) { w.own.hits[0].after = w.right.hits[0].after = 0.3; });
    const auto corner = [](Vec2 left, bool isRight) -> WallSpoil {
        return [=](BothWalls &w) {
            WallHit hit = wallHit(Wall::Right, 1.0, 1.0, 1.0);
            hit.turnsBoth = isRight;
            w.right.corners = {hit, hit};
            hit.came = {1.0, 1.0};
            hit.left = left;
            hit.turnsBoth = false;
            w.own.corners = {w.right.corners[0], hit};
        };
    };
    const char *const oneWall = "In a corner only one part of the velocity of circle 1 turns round";
    row(oneWall, corner({-1.0, 1.0}, true));
    row(oneWall, corner({1.0, -1.0}, true));
    row("", corner({-1.0, 1.0}, false));
    row("", corner({1.0, 1.0}, true));
    row("", corner({-1.0, 0.0}, true));
    row("", corner({0.0, -1.0}, true));
    const char *const again = "Circle 1 was turned round again while it left a wall";
    row(again, [](BothWalls &w) { w.own.hits[4].again = 1; });
    for (const bool isAnew : {false, true}) {
        row(
            again,
            [isAnew](BothWalls &w) {
                w.own.hits[4].again = 1;
                w.own.hits[4].isAgainAnew = isAnew;
            },
            isAnew ? "ask which way it moves" : "in a run that begins there it goes on");
    }
    row("", [](BothWalls &w) { w.own.hits[4].again = w.right.hits[4].again = 1; });
    const auto drop = [](const Drop &own, const Drop &right = {}) -> WallSpoil {
        return [=](BothWalls &w) {
            w.own.drops = {Drop{}, own};
            w.right.drops = {Drop{}, right};
        };
    };
    row(again, drop({.again = 1}));
    row("", drop({.again = 1}, {.again = 1}));
    const char *const sinks = "The floor does not hold circle 1 up";
    row(sinks, drop({.restitution = 0.5, .depth = 0.021, .sinks = true}));
    row("", drop({.restitution = 0.5, .depth = 0.019, .sinks = true}));
    row("", drop({.restitution = 0.5, .depth = 0.021, .sinks = false}));
    row("", drop({.restitution = 1.0, .depth = 0.021, .sinks = true}));
    row("", drop({.restitution = 0.5, .depth = 0.05, .sinks = true}, {.depth = 0.021}));
    row(sinks, drop({.restitution = 0.5, .depth = 0.05, .sinks = true}, {.depth = 0.019}));
    row("", [](BothWalls &w) {
        w.own.drops = {{.restitution = 0.5, .depth = 0.021, .sinks = true}};
        w.right.drops = {Drop{}};
        w.ground = made::wallGround(false);
    });
    row("At every wall circle 1 went out", [](BothWalls &w) {
        for (WallHit &hit : w.own.hits)
            open(hit);
    });
    row("At the left wall circle 1 went out", [](BothWalls &w) {
        for (WallHit &hit : w.own.hits) {
            if (hit.wall == Wall::Left)
                open(hit);
        }
    });
    row("Some hits of circle 1 at the left wall are not answered",
        [](BothWalls &w) { open(w.own.hits[0]); });
    row("", [](BothWalls &w) {
        open(w.own.hits[0]);
        w.own.hits[0].missed = true;
    });
    row("", [](BothWalls &w) {
        open(w.own.hits[0]);
        open(w.right.hits[0]);
    });
    row("Something away from every wall changes the velocity of circle 1", [](BothWalls &w) {
        turnAt(w.own.hits[0], 2.0);
        w.own.hits[0].step = 1;
        w.own.hits[0].left = 0.9 * w.own.hits[0].left;
        w.own.hits[0].kicks = true;
    });
}

void TestWallPlaces::faultIsTold()
{
    QFETCH(WallSpoil, spoil);
    QFETCH(QString, headline);
    QFETCH(QString, body);
    BothWalls both = rightWalls();
    spoil(both);
    const auto found = wallDeviations(both.own, both.right, both.ground);
    QCOMPARE(headlinesOf(found), headline.isEmpty() ? QStringList() : QStringList(headline));
    QVERIFY(found.empty() || found.front().message.contains(body));
    // Nothing is known of a circle that the reference is not judged by.
    both.right.judged = {1};
    QVERIFY(wallDeviations(both.own, both.right, both.ground).empty());
}

void TestWallPlaces::reachIsTold_data()
{
    QTest::addColumn<WallReach>("reach");
    QTest::addColumn<QString>("headline");
    QTest::addColumn<QString>("body");
    int rows = 0;
    const auto row = [&rows](const char *headline, const WallReach &reach, const char *body = "") {
        QTest::addRow("%d. %s", ++rows, headline) << reach << utf8(headline) << utf8(body);
    };
    using Hit = const WallHit &;
    const auto fixed = [](double length) -> WallReach { return [length](Hit) { return length; }; };
    const char *const number = "At the walls a number stands for the radius of circle 1";
    const char *const early = "Hits at the walls turn circle 1 round too early";
    const char *const late = "Hits at the walls turn circle 1 round too late";
    row("At the walls the centre of circle 1 is asked for, not the rim", fixed(0.0));
    row("At the walls the radius of another circle stands for that of circle 1",
        [](Hit h) { return h.otherRadius; });
    row("At the walls the larger radius stands for that of circle 1",
        [](Hit h) { return std::max(h.radius, h.otherRadius); });
    row("At the walls the smaller radius stands for that of circle 1",
        [](Hit h) { return std::min(h.radius, h.otherRadius); });
    row(
        late, [](Hit h) { return 0.5 * h.radius; }, "half of that");
    row(number, fixed(0.2), "its centre is 0.2 m from the wall");
    row(number, fixed(0.45), "with the radius 0.2 m as with 0.28 m");
    row(
        early, [](Hit h) { return 2.0 * h.radius; }, "twice the radius");
    row("Hits at the walls turn circle 1 round at the far side of the rim",
        [](Hit h) { return -h.radius; });
    row(
        early, [](Hit h) { return h.radius + 0.1; }, "It should turn when its rim is there.");
    row(
        late, [](Hit h) { return h.radius - 0.14; }, "It should turn when its rim is there.");
    row("Hits at the walls turn circle 1 round at the wrong place",
        [](Hit h) { return h.wall == Wall::Left ? h.radius + 0.1 : h.radius - 0.14; });
    row(
        "Some hits at the left wall turn circle 1 round too early",
        [](Hit h) { return h.wall == Wall::Left && h.restitution == 0.5 ? 1.0 : h.radius; },
        "Of 3 hits tried there, 2 came at the rim.");
    row(
        "Some hits at the left wall turn circle 1 round too late",
        [](Hit h) { return h.wall == Wall::Left && h.restitution == 0.5 ? 0.1 : h.radius; },
        "Of 3 hits tried there, 2 came at the rim.");
}

void TestWallPlaces::reachIsTold()
{
    QFETCH(WallReach, reach);
    QFETCH(QString, headline);
    QFETCH(QString, body);
    BothWalls both = rightWalls();
    for (WallHit &hit : both.own.hits)
        turnAt(hit, reach(hit));
    const auto found = wallDeviations(both.own, both.right, both.ground);
    QCOMPARE(headlinesOf(found), QStringList(headline));
    QVERIFY2(found.front().message.contains(body), qPrintable(found.front().message));
    QCOMPARE(found.front().suspect, Suspect::Reach);
    QCOMPARE(found.front().isEverywhere, headline.contains(utf8("walls")));
}

QTEST_GUILESS_MAIN(TestWallPlaces)
#include "test_wall_places.moc"
