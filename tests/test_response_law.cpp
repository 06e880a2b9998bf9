// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/law_programs.h"

#include "tasks/reading/lab_list.h"
#include "tests/text.h"

using namespace cradle;
using namespace cradle::programs;

/// What is said of the answer to a hit is what is wrong with it: direction, masses, e.
class TestResponseLaw : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void faultIsNamed_data();
    void faultIsNamed();
    void stepThatStopsBothSaysSo();
    void contactAndAnswerAreNamedBoth_data();
    void contactAndAnswerAreNamedBoth();
    void aNumberIsToldFromRadii_data();
    void aNumberIsToldFromRadii();
    void lineOfCentresThatComesOutRightIsSaid_data();
    void lineOfCentresThatComesOutRightIsSaid();
    void circleThatLeavesAsItShouldIsNotBlamed();
};

namespace {

const QString e = QStringLiteral("restitution");

} // namespace

void TestResponseLaw::faultIsNamed_data()
{
    QTest::addColumn<QString>("hit");
    QTest::addColumn<QStringList>("said");
    const auto rows = [](const char *name, const HitLaw &law, const QStringList &said) {
        for (const HitWay &way : hitWays)
            QTest::addRow("%s, %s", name, way.name) << hitOf(way, law) << said;
    };
    const auto answer = [&](const char *name, const char *lua, const char *said) {
        rows(name, {.e = e, .answer = text(lua)}, {text(said)});
    };
    const QString area = text("The mass grows with r to the power of 2, not 3");
    const QString squared = text("e is squared in the hit of two circles");
    rows("area", {.mass = text("c.density * c.radius ^ 2"), .e = e}, {area});
    rows("no density", {.mass = text("c.radius ^ 3"), .e = e},
         {text("The hits do not depend on the densities")});
    rows("inverted", {.mass = text("1 / (c.density * c.radius ^ 3)"), .e = e},
         {text("Each circle answers as if it had the mass of the other")});
    answer("turned whole",
           "local j = (1 + e) / (1 / m1 + 1 / m2) local w = p.velocity - q.velocity "
           "p.velocity = p.velocity - j / m1 * w q.velocity = q.velocity + j / m2 * w",
           "The whole relative velocity is turned round");
    answer("half of e",
           "local j = (1 + e / 2) * closing / (1 / m1 + 1 / m2) "
           "p.velocity = p.velocity - j / m1 * n q.velocity = q.velocity + j / m2 * n",
           "The push is multiplied by 1 + 0.5 e instead of 1 + e");
    answer("less with more e",
           "local j = (2.5 - e / 2) * closing / (1 / m1 + 1 / m2) "
           "p.velocity = p.velocity - j / m1 * n q.velocity = q.velocity + j / m2 * n",
           "The push is multiplied by 2.5 − 0.5 e instead of 1 + e");
    answer("not with e = 0",
           "if e > 0 then local j = (1 + e) * closing / (1 / m1 + 1 / m2) "
           "p.velocity = p.velocity - j / m1 * n q.velocity = q.velocity + j / m2 * n end",
           "With e = 0 a hit changes no velocity");
    answer("the radius of the other in one mass",
           "m1 = p.density * q.radius ^ 3 local j = (1 + e) * closing / (1 / m1 + 1 / m2) "
           "p.velocity = p.velocity - j / m1 * n q.velocity = q.velocity + j / m2 * n",
           "The hits do not depend on the radii");
    answer("with a curve of e",
           "local j = (1 + e / 2 + e ^ 3 / 4) * closing / (1 / m1 + 1 / m2) "
           "p.velocity = p.velocity - j / m1 * n q.velocity = q.velocity + j / m2 * n",
           "Equal circles get 0.875 times the right push (with e = 1)");
    answer("brackets",
           "p.velocity = p.velocity - (1 + e * closing * m2 / (m1 + m2)) * n "
           "q.velocity = q.velocity + (1 + e * closing * m1 / (m1 + m2)) * n",
           "The push has the wrong size");
    answer("by the density",
           "local j = (1 + 1 / q.density) * closing / (1 / m1 + 1 / m2) "
           "p.velocity = p.velocity - j / m1 * n q.velocity = q.velocity + j / m2 * n",
           "e does not act on the rebound as it should");
    answer("radii exchanged",
           "m1, m2 = p.density * q.radius ^ 3, q.density * p.radius ^ 3 "
           "local j = (1 + e) * closing / (1 / m1 + 1 / m2) p.velocity = p.velocity - j / m1 * n "
           "q.velocity = q.velocity + j / m2 * n",
           "Each circle answers as if it had the other's radius");
    answer("densities exchanged",
           "m1, m2 = q.density * p.radius ^ 3, p.density * q.radius ^ 3 "
           "local j = (1 + e) * closing / (1 / m1 + 1 / m2) p.velocity = p.velocity - j / m1 * n "
           "q.velocity = q.velocity + j / m2 * n",
           "Each circle answers as if it had the other's density");
    rows("e squared", {.e = text("restitution ^ 2")}, {squared});
    rows("no e", {}, {text("e changes nothing in the hits tried")});
    rows("minus e", {.e = text("-restitution")},
         {text("The sign of e is wrong in the hit of two circles")});
    rows("area and e squared",
         {.mass = text("c.density * c.radius ^ 2"), .e = text("restitution ^ 2")}, {area, squared});
    answer("swap", "p.velocity, q.velocity = q.velocity, p.velocity",
           "The circles exchange their whole velocities");
    answer("no temp", "p.velocity = q.velocity q.velocity = p.velocity",
           "Both circles leave with the velocity of circle 2");
    answer("stop", "p.velocity, q.velocity = vec(0, 0), vec(0, 0)", "A hit stops both circles");
    answer("masses exchanged in the rebound",
           "local a, b, m = p.velocity:dot(n), q.velocity:dot(n), m1 + m2 "
           "local u = (m1 * a + m2 * b) / m "
           "p.velocity = p.velocity + (u + e * m1 * (b - a) / m - a) * n "
           "q.velocity = q.velocity + (u + e * m2 * (a - b) / m - b) * n",
           "In the rebound the two shares are exchanged");
    answer(
        "one after the other",
        "local a, b, m = p.velocity:dot(n), q.velocity:dot(n), m1 + m2 "
        "a = a - (1 + e) * m2 / m * (a - b) p.velocity = p.velocity + (a - p.velocity:dot(n)) * n "
        "b = b + (1 + e) * m1 / m * (a - b) q.velocity = q.velocity + (b - q.velocity:dot(n)) * n",
        "The velocity of circle 2 is worked out from what circle 1 has become");
    answer("circle 1 alone",
           "local j = (1 + e) * closing / (1 / m1 + 1 / m2) p.velocity = p.velocity - j / m1 * n",
           "A hit leaves circle 2 as it was");
    // With e = 1 circle 1 keeps its velocity, and with no other e.
    answer("e of circle 1 with the wrong sign",
           "local u = (m1 * p.velocity + m2 * q.velocity):dot(n) / (m1 + m2) "
           "local a, b = p.velocity:dot(n), q.velocity:dot(n) "
           "p.velocity = p.velocity + (u + e * (a - u) - a) * n "
           "q.velocity = q.velocity + (u + e * (u - b) - b) * n",
           "The sign of e is wrong in the hit of two circles, for circle 1 alone");
    answer("e across, circle 1",
           "local j = (1 + e) * closing / (1 / m1 + 1 / m2) local t = vec(-n.y, n.x) "
           "p.velocity = p.velocity - j / m1 * n - (1 - e) * p.velocity:dot(t) * t "
           "q.velocity = q.velocity + j / m2 * n",
           "e also shortens the part of circle 1 across the line of centres");
    answer("one as off a wall", "p.velocity = p.velocity - 2 * p.velocity:dot(n) * n",
           "Circle 1 bounces as off a wall, and circle 2 stays as it was");
    answer("twice the push",
           "local j = 2 * (1 + e) * closing / (1 / m1 + 1 / m2) "
           "p.velocity = p.velocity - j / m1 * n q.velocity = q.velocity + j / m2 * n",
           "Equal circles get 2 times the right push");
    rows("mirrored", {.normal = text("vec(d.x, -d.y):normalized()"), .e = e},
         {text("The normal is mirrored: the sign of its y is wrong")});
    rows("x and y exchanged", {.normal = text("vec(d.y, d.x):normalized()"), .e = e},
         {text("The parts x and y of the normal are exchanged")});
    rows("along x", {.normal = text("vec(d.x > 0 and 1 or -1, 0)"), .e = e},
         {text("The x parts change hands, not those along the line of centres")});
}

void TestResponseLaw::faultIsNamed()
{
    QFETCH(QString, hit);
    QFETCH(QStringList, said);
    const LawBench step(task(QStringLiteral("L42T16")));
    const QString program = written(withHit(hit), structures[3]);
    QCOMPARE(step.contact(program) + step.response(program), said);
}

void TestResponseLaw::stepThatStopsBothSaysSo()
{
    const LawBench step(task(QStringLiteral("L42T9")));
    for (const char *answer : {"p.velocity, q.velocity = q.velocity, p.velocity",
                               "p.velocity, q.velocity = -p.velocity, -q.velocity",
                               "p.velocity = q.velocity q.velocity = p.velocity"}) {
        const HitLaw law{.answer = text(answer)};
        const QString program = written(withHit(hitOf(hitWays[0], law)), structures[0]);
        QCOMPARE(step.response(program), QStringList(text("The circles do not stop in a hit")));
    }
    const HitLaw some{.answer =
                          text("if n.x > 0 then p.velocity, q.velocity = vec(0, 0), vec(0, 0) "
                               "else q.velocity = p.velocity end")};
    const QString program = written(withHit(hitOf(hitWays[0], some)), structures[0]);
    QCOMPARE(step.response(program), QStringList(text("Not every hit stops both circles")));
}

void TestResponseLaw::contactAndAnswerAreNamedBoth_data()
{
    QTest::addColumn<QString>("reach");
    QTest::addColumn<QString>("touch");
    QTest::addColumn<QString>("said");
    const auto row = [](const char *reach, const char *touch, const char *said) {
        QTest::addRow("%s, %s", reach, touch) << text(reach) << text(touch) << text(said);
    };
    row("p.radius", "d:length() < reach", "Contact is tested at r₁, not at r₁ + r₂");
    row("p.radius + q.radius + 0.06", "d:length() < reach", "The circles answer before they touch");
    row("p.radius + q.radius", "math.max(math.abs(d.x), math.abs(d.y)) < reach",
        "Boxes are compared, not circles");
    row("p.radius + q.radius", "d.x ^ 2 + d.y ^ 2 < reach",
        "A squared distance is compared with a length");
}

void TestResponseLaw::contactAndAnswerAreNamedBoth()
{
    QFETCH(QString, reach);
    QFETCH(QString, touch);
    QFETCH(QString, said);
    const LawBench step(task(QStringLiteral("L42T16")));
    for (const HitWay &way : hitWays) {
        const HitLaw law{.reach = reach,
                         .touch = touch,
                         .mass = text("c.density * c.radius"),
                         .e = text("restitution ^ 2")};
        const QString program = written(withHit(hitOf(way, law)), structures[1]);
        QCOMPARE(step.contact(program), QStringList(said));
        QCOMPARE(step.response(program),
                 (QStringList{text("The mass grows with r to the power of 1, not 3"),
                              text("e is squared in the hit of two circles")}));
    }
}

void TestResponseLaw::aNumberIsToldFromRadii_data()
{
    QTest::addColumn<QString>("reach");
    QTest::addColumn<QString>("said");
    const QString number = text("The test of contact acts as if a number stood for r₁ + r₂");
    for (const char *reach : {"0.2", "0.375", "0.4", "0.5", "0.6", "0.8"})
        QTest::addRow("%s", reach) << text(reach) << number;
    QTest::addRow("larger") << text("math.max(p.radius, q.radius)")
                            << text("Contact is tested at the larger radius, not at r₁ + r₂");
    QTest::addRow("twice smaller")
        << text("2 * math.min(p.radius, q.radius)")
        << text("Contact is tested at twice the smaller radius, not at r₁ + r₂");
    QTest::addRow("smaller") << text("math.min(p.radius, q.radius)")
                             << text("Contact is tested at the smaller radius, not at r₁ + r₂");
}

void TestResponseLaw::aNumberIsToldFromRadii()
{
    QFETCH(QString, reach);
    QFETCH(QString, said);
    for (const char *step : {"L42T13", "L42T16"}) {
        const LawBench bench(task(text(step)));
        for (const int structure : {0, 1}) {
            const HitLaw law{.reach = reach, .e = e};
            const QString program =
                written(withHit(hitOf(hitWays[structure], law)), structures[structure]);
            QCOMPARE(bench.contact(program), QStringList(said));
        }
    }
}

void TestResponseLaw::lineOfCentresThatComesOutRightIsSaid_data()
{
    QTest::addColumn<QString>("normal");
    QTest::addColumn<bool>("said");
    const auto row = [](const char *name, const char *angle, bool said) {
        QTest::newRow(name) << QStringLiteral("(function() local f = %1 return vec(math.cos(f), "
                                              "math.sin(f)) end)()")
                                   .arg(QLatin1String(angle))
                            << said;
    };
    row("angle by its sine: only to the right", "math.asin(d.y / d:length())", true);
    row("off everywhere", "math.atan(d.y, d.x) + 0.5", false);
}

void TestResponseLaw::lineOfCentresThatComesOutRightIsSaid()
{
    QFETCH(QString, normal);
    QFETCH(bool, said);
    const LawBench bench(task(text("L42T12")));
    const HitLaw law{.normal = normal, .mass = text("1")};
    const QString program = written(withHit(hitOf(hitWays[0], law)), structures[3]);
    const MeasuredLaws own(&program, bench.ground);
    const auto found = responseDeviations(own.pair(), bench.right.pair(), bench.ground);
    QCOMPARE(found.size(), std::size_t(1));
    QCOMPARE(found.front().message.contains(text("Here the line of centres was at 118°; with 33° "
                                                 "the hits come out right.")),
             said);
}

void TestResponseLaw::circleThatLeavesAsItShouldIsNotBlamed()
{
    const LawBench bench(task(text("L42T12")));
    const auto blamed = [&](const char *answer) {
        const HitLaw law{.mass = text("1"), .answer = text(answer)};
        const QString program = written(withHit(hitOf(hitWays[0], law)), structures[3]);
        const MeasuredLaws own(&program, bench.ground);
        const auto found = responseDeviations(own.pair(), bench.right.pair(), bench.ground);
        return found.empty() ? std::vector<int>() : found.front().moment.circles;
    };
    QCOMPARE(blamed("p.velocity = p.velocity - q.velocity - closing * n "
                    "q.velocity = q.velocity + closing * n"),
             std::vector<int>{0});
    QCOMPARE(blamed("local u = q.velocity q.velocity = closing * n "
                    "p.velocity = p.velocity - closing * n"),
             std::vector<int>{1});
    QCOMPARE(blamed("p.velocity = p.velocity - 0.7 * closing * n "
                    "q.velocity = q.velocity + 0.6 * closing * n"),
             (std::vector<int>{0, 1}));
}

QTEST_GUILESS_MAIN(TestResponseLaw)
#include "test_response_law.moc"
