// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_laws.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace cradle;

/// The wrong answers to a hit that students write, each by hand for one hit of equal circles: they
/// come with 1.2 m/s and −0.3 m/s along the line of centres, which lies along (0.6, 0.8), and with
/// 0.4 m/s and 0.1 m/s across it. Right would be −0.1 m/s and 1 m/s.
class TestKnownResponses : public QObject
{
    Q_OBJECT
private slots:
    void answerIsAsTold_data();
    void answerIsAsTold();
    void allAreTried();
    void someAreSaidOfTheTriedEAlone();
    void directionsAreAsTold_data();
    void directionsAreAsTold();
    void whoFollowsDoesSoInEveryHit();
};

namespace {

const Vec2 n{0.6, 0.8};
const Vec2 t{-0.8, 0.6};

PairHit comingHit()
{
    PairHit hit;
    hit.normal = n;
    hit.before = 0.44;
    hit.reached = 0.36;
    hit.came1 = 1.2 * n + 0.4 * t;
    hit.came2 = -0.3 * n + 0.1 * t;
    return hit;
}

EqualHit equalHit(const PairHit &hit)
{
    return {hit, {1.2, 0.4, -0.3, 0.1}, {-0.1, 0.4, 1.0, 0.1}};
}

const ResponseLaw *lawNamed(const std::vector<ResponseLaw> &all, const QString &headline,
                            int number = 0)
{
    const auto found = std::find_if(all.begin(), all.end(), [&](const ResponseLaw &law) {
        return law.headline == headline && number-- == 0;
    });
    return found == all.end() ? nullptr : &*found;
}

bool isNear(const PairVelocities &a, const PairVelocities &b)
{
    return std::abs(a.along1 - b.along1) + std::abs(a.across1 - b.across1)
               + std::abs(a.along2 - b.along2) + std::abs(a.across2 - b.across2)
           < 1e-12;
}

struct Answer {
    const char *headline;
    PairVelocities left;
    int number = 0; ///< of those with that headline, from 0
};

// Of pushes of 1.3 m/s each.
const Answer answers[] = {
    {"A hit leaves circle 2 as it was", {-0.1, 0.4, -0.3, 0.1}},
    {"A hit leaves circle 1 as it was", {1.2, 0.4, 1.0, 0.1}},
    {"A hit stops both circles", {0, 0, 0, 0}},
    {"A hit stops circle 1 and leaves circle 2 as it was", {0, 0, -0.3, 0.1}},
    {"A hit stops circle 2 and leaves circle 1 as it was", {1.2, 0.4, 0, 0}},
    {"Each circle is turned back on its own way", {-1.2, -0.4, 0.3, -0.1}},
    {"Each circle bounces as off a wall", {-1.2, 0.4, 0.3, 0.1}},
    {"Circle 1 bounces as off a wall", {-1.2, 0.4, 1.0, 0.1}},
    {"Circle 2 bounces as off a wall", {-0.1, 0.4, 0.3, 0.1}},
    {"Circle 1 bounces as off a wall, and circle 2 stays as it was", {-1.2, 0.4, -0.3, 0.1}},
    {"Circle 2 bounces as off a wall, and circle 1 stays as it was", {1.2, 0.4, 0.3, 0.1}},
    {"The parts across the line of centres turn round, not those along it",
     {1.2, -0.4, -0.3, -0.1}},
    {"The circles exchange their whole velocities", {-0.3, 0.1, 1.2, 0.4}},
    {"The whole relative velocity is turned round", {-0.1, 0.1, 1.0, 0.4}},
    {"Two equal circles exchange their whole velocities", {-0.3, 0.1, 1.2, 0.4}},
    {"The parts across change hands, and those along the normal stay", {1.2, 0.1, -0.3, 0.4}},
    {"Circle 1 loses its part across the normal", {-0.3, 0, 1.2, 0.1}},
    {"Circle 2 loses its part across the normal", {-0.3, 0.4, 1.2, 0}},
    {"The parts across the normal are lost", {-0.3, 0, 1.2, 0}},
    // Their speeds are as 4 to 1.
    {"Each circle keeps its direction and gets the other's speed", {0.3, 0.1, -1.2, 0.4}},
    {"Both circles leave with the velocity of circle 2", {-0.3, 0.1, -0.3, 0.1}},
    {"Both circles leave with the velocity of circle 1", {1.2, 0.4, 1.2, 0.4}},
    // 13/15 of the closing speed of 1.5 m/s, and then of what it has become: −0.1 + 0.3 m/s.
    {"The velocity of circle 2 is worked out from what circle 1 has become",
     {-0.1, 0.4, -0.3 + 13.0 / 15.0 * 0.2, 0.1}},
    {"The velocity of circle 1 is worked out from what circle 2 has become",
     {1.2 - 13.0 / 15.0 * 0.2, 0.4, 1.0, 0.1}},
    {"Of two equal circles circle 2 leaves a hit as it came", {-0.1, 0.4, -0.3, 0.1}},
    {"Of two equal circles circle 1 leaves a hit as it came", {1.2, 0.4, 1.0, 0.1}},
    {"After an elastic hit the circles do not part", {0.45, 0.4, 0.45, 0.1}},
    {"After a hit both circles have the same velocity", {0.45, 0.25, 0.45, 0.25}},
    {"The part of circle 2 along the normal is forgotten", {0, 0.4, 0.9, 0.1}},
    {"The part of circle 1 along the normal is forgotten", {0.9, 0.4, 0, 0.1}},
    {"Circle 1 keeps the part that it hands over", {1.2, 0.4, 0.9, 0.1}},
    {"The parts along the normal change hands and are turned round as well", {0.3, 0.4, -1.2, 0.1}},
    {"The whole velocities change hands and are turned round as well", {0.3, -0.1, -1.2, -0.4}},
    {"Both circles get their new part along the normal besides the old", {1.1, 0.4, 0.7, 0.1}},
    {"Circle 1 gets its new part along the normal besides the old", {1.1, 0.4, 1.0, 0.1}},
    {"Circle 2 gets its new part along the normal besides the old", {-0.1, 0.4, 0.7, 0.1}},
    {"The push on circle 1 has the wrong sign", {2.5, 0.4, 1.0, 0.1}},
    {"The push on circle 2 has the wrong sign", {-0.1, 0.4, -1.6, 0.1}},
    {"Both pushes have the wrong sign", {2.5, 0.4, -1.6, 0.1}},
    // Of 0.4 m between the centres in the middle of the step.
    {"The normal does not have length 1", {1.2 - 0.16 * 1.3, 0.4, -0.3 + 0.16 * 1.3, 0.1}},
    {"Normal and tangent are too short", {-0.016, 0.064, 0.16, 0.016}},
    {"Normal and tangent are too long", {-0.625, 2.5, 6.25, 0.625}},
    {"The normal does not have length 1", {1.2 - 1.3 / 0.16, 0.4, -0.3 + 1.3 / 0.16, 0.1}, 1},
    {"The distance of the centres comes into the push",
     {1.2 - 0.4 * 1.3, 0.4, -0.3 + 0.4 * 1.3, 0.1}},
    {"The push is divided by the distance of the centres",
     {1.2 - 1.3 / 0.4, 0.4, -0.3 + 1.3 / 0.4, 0.1}}};

/// Along which line the parts change hands instead.
struct Direction {
    const char *headline;
    Vec2 line;
};

const Direction directions[] = {
    {"The perpendicular of the line of centres is taken for the normal", t},
    {"The parts x and y of the normal are exchanged", {0.8, 0.6}},
    {"The normal is mirrored: the sign of its y is wrong", {0.6, -0.8}},
    {"The push acts along the velocity of circle 1", (1.2 * n + 0.4 * t) / std::sqrt(1.6)},
    {"The push acts along the velocity of circle 2", (-0.3 * n + 0.1 * t) / std::sqrt(0.1)},
    {"The x parts change hands, not those along the line of centres", {1, 0}},
    {"The y parts change hands, not those along the line of centres", {0, 1}}};

/// How far what comes out is turned from the line of centres, and how far it should be, in angles
/// of that line to the x axis.
struct Turn {
    const char *headline;
    double angles;
};

const Turn turns[] = {{"The new velocities are turned back by the wrong angle", -2.0},
                      {"The new velocities are not turned back", -1.0}};

} // namespace

void TestKnownResponses::answerIsAsTold_data()
{
    QTest::addColumn<int>("index");
    for (int i = 0; i < static_cast<int>(std::size(answers)); ++i)
        QTest::addRow("%s %d", answers[i].headline, answers[i].number) << i;
}

void TestKnownResponses::answerIsAsTold()
{
    QFETCH(int, index);
    const Answer &wanted = answers[index];
    const std::vector<ResponseLaw> all = knownResponses();
    const ResponseLaw *law = lawNamed(all, QString::fromUtf8(wanted.headline), wanted.number);
    QVERIFY(law);
    const PairHit hit = comingHit();
    QVERIFY(isNear(law->answer(equalHit(hit)), wanted.left));
}

void TestKnownResponses::allAreTried()
{
    QCOMPARE(knownResponses().size(),
             std::size(answers) + std::size(directions) + std::size(turns));
}

void TestKnownResponses::someAreSaidOfTheTriedEAlone()
{
    QStringList ofTried;
    QStringList ofEvery;
    for (const ResponseLaw &law : knownResponses()) {
        if (law.isOfE)
            ofTried.append(law.headline);
        if (law.isForEvery)
            ofEvery.append(law.headline);
    }
    QCOMPARE(
        ofTried,
        QStringList(
            {QStringLiteral("Two equal circles exchange their whole velocities"),
             QStringLiteral("The push on circle 1 has the wrong sign"),
             QStringLiteral("The push on circle 2 has the wrong sign"),
             QStringLiteral("Both circles get their new part along the normal besides the old"),
             QStringLiteral("Circle 1 gets its new part along the normal besides the old"),
             QStringLiteral("Circle 2 gets its new part along the normal besides the old")}));
    QCOMPARE(
        ofEvery,
        QStringList(
            {QStringLiteral("A hit leaves circle 2 as it was"),
             QStringLiteral("A hit leaves circle 1 as it was"),
             QStringLiteral("The circles exchange their whole velocities"),
             QStringLiteral("The whole relative velocity is turned round"),
             QStringLiteral("The velocity of circle 2 is worked out from what circle 1 has become"),
             QStringLiteral(
                 "The velocity of circle 1 is worked out from what circle 2 has become")}));
}

void TestKnownResponses::directionsAreAsTold_data()
{
    QTest::addColumn<QString>("headline");
    QTest::addColumn<PairVelocities>("left");
    const Vec2 v1 = 1.2 * n + 0.4 * t;
    const Vec2 v2 = -0.3 * n + 0.1 * t;
    for (const Direction &d : directions) {
        // 13/15 of the closing speed, as along the line of centres.
        const Vec2 moved = 13.0 / 15.0 * dot(v1 - v2, d.line) * d.line;
        QTest::newRow(d.headline) << QString::fromUtf8(d.headline)
                                  << PairVelocities{1.2 - dot(moved, n), 0.4 - dot(moved, t),
                                                    -0.3 + dot(moved, n), 0.1 + dot(moved, t)};
    }
    // Turned by an angle φ, parts (u, w) are (u cos φ − w sin φ, u sin φ + w cos φ).
    const double line = std::acos(0.6);
    for (const Turn &turn : turns) {
        const double c = std::cos(turn.angles * line);
        const double s = std::sin(turn.angles * line);
        QTest::newRow(turn.headline) << QString::fromUtf8(turn.headline)
                                     << PairVelocities{-0.1 * c - 0.4 * s, -0.1 * s + 0.4 * c,
                                                       1.0 * c - 0.1 * s, 1.0 * s + 0.1 * c};
    }
}

void TestKnownResponses::directionsAreAsTold()
{
    QFETCH(QString, headline);
    QFETCH(PairVelocities, left);
    const std::vector<ResponseLaw> all = knownResponses();
    const ResponseLaw *law = lawNamed(all, headline);
    QVERIFY(law);
    const PairHit hit = comingHit();
    QVERIFY(isNear(law->answer(equalHit(hit)), left));
}

/// To half a percent, in all of them.
void TestKnownResponses::whoFollowsDoesSoInEveryHit()
{
    const std::vector<ResponseLaw> all = knownResponses();
    const ResponseLaw *law = lawNamed(all, QStringLiteral("Each circle bounces as off a wall"));
    QVERIFY(law);
    PairHit first = comingHit();
    first.left1 = -1.2 * n + 0.4 * t;
    first.left2 = 0.3 * n + 0.1 * t;
    PairHit second = first;
    QVERIFY(follows(*law, {equalHit(first), equalHit(second)}));
    second.left1 = -1.203 * n + 0.4 * t;
    QVERIFY(follows(*law, {equalHit(first), equalHit(second)}));
    second.left1 = -1.22 * n + 0.4 * t;
    QVERIFY(!follows(*law, {equalHit(first), equalHit(second)}));
    QVERIFY(!follows(*law, {equalHit(second), equalHit(first)}));
    QVERIFY(!follows(*law, {}));
}

QTEST_APPLESS_MAIN(TestKnownResponses)
#include "test_known_responses.moc"
