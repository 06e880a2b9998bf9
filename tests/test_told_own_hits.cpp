// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_words.h"

#include "tests/told_meeting.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// The numbers that findings on hits of the own scene tell, which others do not show.
class TestToldOwnHits : public ToldMeeting
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void oldMassesOfTheOwnSceneAreTold();
    void oldRestitutionOfTheOwnSceneIsTold();
    void oldRadiusOfTheOwnSceneIsTold();
    void lateByTheNormalIsNoOldRadius();
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

const QString e = QStringLiteral("restitution");
const QString equal = QStringLiteral("1"); // masses

} // namespace

/// Worked out before the radius was set: then both had the same.
void TestToldOwnHits::oldMassesOfTheOwnSceneAreTold()
{
    const QString start = QStringLiteral(
        "gravity = vec(0, 0) circle1.radius, circle2.radius = 0.2, 0.2 "
        "circle1.density, circle2.density = 4, 4 "
        "mass = {} for i, c in ipairs(circles) do mass[i] = c.density * c.radius ^ 3 end "
        "circle2.radius = 0.3 "
        "circle1.position, circle1.velocity = vec(-1, 0.1), vec(2, 0) "
        "circle2.position, circle2.velocity = vec(1, 0), vec(0, 0)");
    const QString said =
        body("L42T16", {.mass = text("mass[c.index]"), .e = e},
             text("In your own scene the circles answer as if they had other masses"), start);
    const auto n =
        numbersIn(said, "There circle 2 answers as if it were # times as heavy as circle "
                        "1; with its radii # and # m and densities # and # it is # "
                        "times.");
    QVERIFY2(n.size() == 6, qPrintable(said));
    QVERIFY(isNear(n[0], 1.0));
    QCOMPARE(n[1], 0.2);
    QCOMPARE(n[2], 0.3);
    QVERIFY(n[3] == 4.0 && n[4] == 4.0);
    QVERIFY(isNear(n[5], 3.375));
    QVERIFY2(said.contains(text("So it is with radii or densities from before")), qPrintable(said));
    // What the scene has not had before is none such.
    const QString other =
        body("L42T16",
             {.mass = text("(c.radius == 0.31 and 5 or 1) * c.density * c.radius ^ 3"), .e = e},
             text("In your own scene the circles answer as if they had other masses"),
             QString(start).replace(QLatin1String("0.3 "), QLatin1String("0.31 ")));
    QVERIFY2(other.contains(text("Look at what the answer takes for the masses")),
             qPrintable(other));
}

void TestToldOwnHits::oldRestitutionOfTheOwnSceneIsTold()
{
    const QString start =
        QStringLiteral("restitution = 1 kept = restitution restitution = 0.5 gravity = vec(0, 0) "
                       "circle1.position, circle1.velocity = vec(-1, 0.1), vec(2, 0) "
                       "circle2.position, circle2.velocity = vec(1, 0), vec(0, 0)");
    const QString headline = text("In your own scene the hit does not use the e that it has");
    // A normal that is shorter the deeper they overlap is no old copy.
    QVERIFY(body("L42T16", {.normal = text("d / reach"), .e = e}, headline, start).isEmpty());
    const QString said = body("L42T16", {.e = text("kept")}, headline, start);
    const auto n = numbersIn(said, "They met with # m/s and parted with # m/s, which is e = #, and "
                                   "`restitution` is #.");
    QVERIFY2(n.size() == 4, qPrintable(said));
    QVERIFY(n[0] > 1.5 && n[0] < 2.0); // nearly all of 2 m/s
    QVERIFY(isNear(n[1], n[0]));
    QVERIFY(isNear(n[2], 1.0));
    QCOMPARE(n[3], 0.5);
    QVERIFY2(said.contains(text("A copy of e")), qPrintable(said));
    // What the scene has not had before is no old value.
    const QString other = body(
        "L42T16", {.e = text("(p.position.y < 0.3 and p.radius == 0.2 and 0.1 or restitution)")},
        headline, start);
    QVERIFY2(other.contains(text("which is e = 0.1, and `restitution` is 0.5.")),
             qPrintable(other));
    QVERIFY2(!other.contains(text("A copy of e")), qPrintable(other));
    // Nor is what counts along one line of centres alone.
    const QString level =
        body("L42T16",
             {.e = text("(math.abs(q.position.y - p.position.y) < 1e-6 and 1 or restitution)")},
             headline,
             QString(start).replace(QLatin1String("vec(-1, 0.1)"), QLatin1String("vec(-1, 0)")));
    QVERIFY2(level.contains(text("which is e = 1, and `restitution` is 0.5.")), qPrintable(level));
    QVERIFY2(level.contains(text("Look at what the answer takes for e there")), qPrintable(level));
}

/// Circle 2 has another radius before `on_load` sets it.
void TestToldOwnHits::oldRadiusOfTheOwnSceneIsTold()
{
    const QString said = body(
        "L42T13", {.touch = text("d:length() < p.radius + (kept or q.radius)"), .mass = equal},
        text("In your own scene the circles answer too late"),
        text("kept = circle2.radius == 0.2 and 0.2 "
             "circle1.position, circle1.velocity = vec(-3, 2), vec(2, 0) "
             "circle2.position, circle2.velocity = vec(0, 2), vec(0, 0) circle2.radius = 0.4"));
    const auto n =
        numbersIn(said, "With r₁ = # m and r₂ = # m they answered when their centres were "
                        "between # and # m apart; rims touch where that is # m.");
    QVERIFY2(n.size() == 5, qPrintable(said));
    QVERIFY(isNear(n[4], 0.6));
    QVERIFY(n[2] <= 0.4 && n[3] < 0.5);
    // How fast they come has no part in it.
    QVERIFY2(said.contains(text("m. In scenes that have their radii before your program begins "
                                "they answer in time. Look at when")),
             qPrintable(said));
}

/// A wrong normal asks for approach along another line: the hit of the own scene may be late.
void TestToldOwnHits::lateByTheNormalIsNoOldRadius()
{
    const HitLaw law{.normal = text("vec(math.cos(math.deg(math.atan(d.y, d.x))), "
                                    "math.sin(math.deg(math.atan(d.y, d.x))))"),
                     .mass = equal};
    QVERIFY(body("L42T11", law, text("In your own scene the circles answer too late"), {}, 1)
                .isEmpty());
}

QTEST_GUILESS_MAIN(TestToldOwnHits)
#include "test_told_own_hits.moc"
