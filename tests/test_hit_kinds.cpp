// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/told_numbers.h"

#include "tasks/judging/condition_words.h"

using namespace cradle;
using namespace cradle::programs;

/// What is said of hits holds for those of many kinds, or tells for how many.
class TestHitKinds : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void headlineTellsForHowMany_data();
    void headlineTellsForHowMany();
    void directionIsToldOfTheContactAlone();
    void numbersShowWhatIsWrong();
    void lineOfTheFirstHitIsTold();
    void answerOfTheOwnSceneIsNotDenied_data();
    void answerOfTheOwnSceneIsNotDenied();
    void wallBesideTheOtherIsNoAnswer();
    void hitThatKeepsVelocitiesIsNotMissed_data();
    void hitThatKeepsVelocitiesIsNotMissed();
    void chanceIsNoRule_data();
    void chanceIsNoRule();
    void ruleOfUnequalCirclesIsTold_data();
    void ruleOfUnequalCirclesIsTold();
    void restOfAHitIsNoAnswer();
    void roundedPushIsNoHistory();
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

/// What is said of the contact and the response of a program with that hit, the whole of it.
QStringList bodies(const LawBench &bench, const HitLaw &law, const QString &start = {})
{
    const QString program = written({.start = start,
                                     .walls = wallsOf(wallWays[1], "c.radius", "1"),
                                     .hit = hitOf(hitWays[1], law)},
                                    structures[1]);
    const MeasuredLaws own(&program, bench.ground);
    QStringList all;
    for (const auto &[aspect, found] :
         {std::pair(Aspect::Contact,
                    contactDeviations(own.pair(), bench.right.pair(), bench.ground)),
          std::pair(Aspect::Response,
                    responseDeviations(own.pair(), bench.right.pair(), bench.ground))})
        for (const LawDeviation &one :
             conditioned(aspect, found, own, bench.right, bench.ground, {}).deviations)
            all.append(one.message);
    return all;
}

/// The headlines of that.
QStringList said(const LawBench &bench, const HitLaw &law, const QString &start = {})
{
    QStringList all = bodies(bench, law, start);
    for (QString &one : all)
        one = one.section(QLatin1Char('\n'), 0, 0);
    return all;
}

} // namespace

void TestHitKinds::headlineTellsForHowMany_data()
{
    QTest::addColumn<QByteArray>("step");
    QTest::addColumn<QString>("answer");
    QTest::addColumn<QString>("headline");
    const auto row = [](const char *name, const char *step, const char *answer,
                        const char *headline) {
        QTest::addRow("%s", name) << QByteArray(step) << text(answer) << text(headline);
    };
    row("both get the sum where they should get the other's", "L42T10",
        "local sum = p.velocity + q.velocity "
        "p.velocity, q.velocity = sum - 0.5 * p.velocity, sum - 0.5 * q.velocity",
        "The two pushes are not equal and opposite");
    row("across of circle 1 from circle 2", "L42T12",
        "local t = vec(-n.y, n.x) local a = p.velocity:dot(n) "
        "p.velocity = q.velocity:dot(n) * n + q.velocity:dot(t) * t "
        "q.velocity = a * n + q.velocity:dot(t) * t",
        "Circle 1 does not keep its part across in a hit (in most hits)");
    row("speeds change hands", "L42T10",
        "local one, two = p.velocity:length(), q.velocity:length() "
        "p.velocity, q.velocity = p.velocity:normalized() * two, q.velocity:normalized() * one",
        "Each circle keeps its direction and gets the other's speed");
    row("half the velocity", "L42T9", "p.velocity, q.velocity = 0.5 * p.velocity, 0.5 * q.velocity",
        "The circles do not stop in a hit");
    row("circle 1 alone", "L42T9", "p.velocity = vec(0, 0)",
        "A hit stops circle 1 and not circle 2");
    row("circle 2 alone", "L42T9", "q.velocity = vec(0, 0)",
        "A hit stops circle 2 and not circle 1");
    row("x alone", "L42T9", "p.velocity, q.velocity = vec(0, p.velocity.y), vec(0, q.velocity.y)",
        "A hit stops the x parts alone");
    row("normal of another length by direction", "L42T12",
        "local m = d / (math.abs(d.x) + math.abs(d.y)) "
        "local j = (p.velocity - q.velocity):dot(m) "
        "p.velocity, q.velocity = p.velocity - j * m, q.velocity + j * m",
        "The push has the wrong size (in most hits)");
    row("put apart by ten times the overlap", "L42T12",
        "p.velocity, q.velocity = p.velocity - closing * n, q.velocity + closing * n "
        "local deep = reach - d:length() "
        "p.position, q.position = p.position - 10 * deep * n, q.position + 10 * deep * n",
        "A hit puts the circles too far apart");
    row("same velocities", "L42T12", "p.velocity, q.velocity = vec(-1, 0.5), vec(2, 0)",
        "The velocities after a hit do not depend on those before");
    row("same parts along", "L42T14",
        "local a, b = p.velocity:dot(n), q.velocity:dot(n) "
        "p.velocity, q.velocity = p.velocity + (-1.5 - a) * n, q.velocity + (0.5 - b) * n",
        "The new parts along the normal do not depend on the old ones");
    row("part across of the one that moves", "L42T11",
        "local a = p.velocity:dot(n) p.velocity, q.velocity = vec(0, 0), q.velocity + a * n",
        "Circle 1 loses its part across the normal");
    row("mass of two of the other's", "L42T14",
        "m2 = 2 * m1 local j = 2 * closing / (1 / m1 + 1 / m2) "
        "p.velocity, q.velocity = p.velocity - j / m1 * n, q.velocity + j / m2 * n",
        "The two masses have the same ratio in all hits tried");
    row("normal and tangent of another length", "L42T12",
        "n = n / d:length() local t = vec(-n.y, n.x) "
        "local a, b = p.velocity:dot(n), q.velocity:dot(n) "
        "p.velocity = b * n + p.velocity:dot(t) * t q.velocity = a * n + q.velocity:dot(t) * t",
        "Normal and tangent are too long");
    row("one number of two masses", "L42T14",
        "m1, m2 = 3.14 * p.radius ^ 3, math.pi * q.radius ^ 3 "
        "local j = 2 * closing / (1 / m1 + 1 / m2) "
        "p.velocity, q.velocity = p.velocity - j / m1 * n, q.velocity + j / m2 * n",
        "Two equal circles do not count as equally heavy");
    row("circle 1 alone, too early in the lab", "L42T8", "p.velocity = p.velocity - closing * n",
        "Circle 1 answers where it meets circle 2");
    row("an angle from its cosine", "L42T12",
        "local a = math.acos(n.x) n = vec(math.cos(a), math.sin(a)) "
        "local u = (p.velocity - q.velocity):dot(n) "
        "p.velocity, q.velocity = p.velocity - u * n, q.velocity + u * n",
        "Some hits of the two circles come out wrong");
    row("radii in the mass of the other", "L42T14",
        "m1, m2 = p.density * q.radius ^ 3, q.density * p.radius ^ 3 "
        "local j = 2 * closing / (1 / m1 + 1 / m2) "
        "p.velocity, q.velocity = p.velocity - j / m1 * n, q.velocity + j / m2 * n",
        "The larger of two circles answers as the lighter one");
    row("each gets the momentum of the other", "L42T14",
        "m1, m2 = p.density * p.radius ^ 3, q.density * q.radius ^ 3 "
        "local u, w = p.velocity:dot(n), q.velocity:dot(n) "
        "p.velocity = p.velocity + (m2 * w / m1 - u) * n "
        "q.velocity = q.velocity + (m1 * u / m2 - w) * n",
        "The momenta along the line of centres change hands");
    row("e for the lighter one alone", "L42T16",
        "m1, m2 = p.density * p.radius ^ 3, q.density * q.radius ^ 3 "
        "local a, b = restitution, restitution if m1 > m2 then a = 1 else b = 1 end "
        "local u = closing / (m1 + m2) "
        "p.velocity = p.velocity - (1 + a) * m2 * u * n "
        "q.velocity = q.velocity + (1 + b) * m1 * u * n",
        "Along the normal only circle 1 feels e (equal circles)");
    row("the upper one alone", "L42T12",
        "if p.position.y > q.position.y then p.velocity = p.velocity - closing * n "
        "else q.velocity = q.velocity + closing * n end",
        "A hit leaves circle 1 as it was (in some hits)");
    row("e in the momenta that change hands", "L42T16",
        "m1, m2 = p.density * p.radius ^ 3, q.density * q.radius ^ 3 "
        "local u, w = p.velocity:dot(n), q.velocity:dot(n) "
        "p.velocity = p.velocity + (restitution * m2 * w / m1 - u) * n "
        "q.velocity = q.velocity + (restitution * m1 * u / m2 - w) * n",
        "Each circle leaves with e times the momentum of the other");
    row("the mean of the masses for what they share", "L42T16",
        "m1, m2 = p.density * p.radius ^ 3, q.density * q.radius ^ 3 "
        "local j = (1 + restitution) * closing * (m1 + m2) / 4 "
        "p.velocity, q.velocity = p.velocity - j / m1 * n, q.velocity + j / m2 * n",
        "The shares of the two circles do not add up to 1");
    row("what circle 1 has left for circle 2", "L42T11",
        "p.velocity = p.velocity - closing * n q.velocity = p.velocity",
        "Only circle 1 leaves a hit as it should");
    row("places alone, too early in the lab", "L42T8",
        "local deep = reach - d:length() "
        "p.position, q.position = p.position - deep / 2 * n, q.position + deep / 2 * n",
        "The circles act on each other");
    row("stops upward", "L42T9",
        "if p.velocity.y > 0 then p.velocity, q.velocity = vec(0, 0), vec(0, 0) else "
        "p.velocity, q.velocity = 0.5 * p.velocity, 0.5 * q.velocity end",
        "Some hits of the two circles come out wrong");
}

void TestHitKinds::headlineTellsForHowMany()
{
    QFETCH(QByteArray, step);
    QFETCH(QString, answer);
    QFETCH(QString, headline);
    const LawBench bench(task(QLatin1String(step)));
    QCOMPARE(said(bench, {.mass = text("1"), .answer = answer}), QStringList(headline));
}

/// The same normal tells whether they come nearer: of one cause one finding.
void TestHitKinds::directionIsToldOfTheContactAlone()
{
    const LawBench bench(task(QStringLiteral("L42T11")));
    const HitLaw law{.normal = text("vec(d.x, math.abs(d.y)):normalized()")};
    QCOMPARE(said(bench, law), QStringList(text("Some hits do not act along the line of centres")));
}

/// What is all but right in the own scene is not called right there; what shows is told.
void TestHitKinds::numbersShowWhatIsWrong()
{
    const LawBench bench(task(QStringLiteral("L42T15")));
    const QString rounded = text("local function w(c) return math.floor(c.density * c.radius ^ 3 * "
                                 "1000) end m1, m2 = w(p), w(q) "
                                 "local j = 2 * closing / (1 / m1 + 1 / m2) "
                                 "p.velocity = p.velocity - j / m1 * n "
                                 "q.velocity = q.velocity + j / m2 * n");
    const QString body = bodies(bench, {.answer = rounded}).value(0);
    const auto n = told::numbersIn(body, "they left with # and #; # and # are right.");
    QVERIFY2(n.size() == 4, qPrintable(body));
    QVERIFY2(n[0] != n[2] || n[1] != n[3], qPrintable(body));
}

/// Where circle 2 rests at first, nothing else tells that the line was kept.
void TestHitKinds::lineOfTheFirstHitIsTold()
{
    const LawBench bench(task(QStringLiteral("L42T11")));
    const HitLaw law{.answer =
                         text("line = line or n local u = (p.velocity - q.velocity):dot(line) "
                              "p.velocity = p.velocity - u * line "
                              "q.velocity = q.velocity + u * line")};
    QCOMPARE(said(bench, law, text("line = false")),
             QStringList(text("A later hit is answered along the line of an earlier one")));
}

void TestHitKinds::answerOfTheOwnSceneIsNotDenied_data()
{
    QTest::addColumn<QString>("touch");
    QTest::addColumn<QString>("headline");
    QTest::newRow("an area for a length")
        << text("d:length() < p.radius * q.radius")
        << text("The circles are answered much too late, or not at all");
    QTest::newRow("the circles of its own scene")
        << text("d:length() < reach and p.velocity.y == circle1.velocity.y and "
                "p.velocity.y == 0 and q.velocity.y == 0")
        << text("No hit tried is answered but that of your own scene");
}

/// Who answers no hit that is thrown may answer the one that its student sees.
void TestHitKinds::answerOfTheOwnSceneIsNotDenied()
{
    QFETCH(QString, touch);
    QFETCH(QString, headline);
    const LawBench bench(task(text("L42T9")));
    QCOMPARE(said(bench, {.touch = touch,
                          .mass = text("1"),
                          .answer = text("p.velocity, q.velocity = vec(0, 0), vec(0, 0)")}),
             QStringList(headline));
}

/// In its own scene circle 1 turns at the right wall while it overlaps circle 2.
void TestHitKinds::wallBesideTheOtherIsNoAnswer()
{
    const LawBench bench(task(text("L42T9")));
    QCOMPARE(said(bench, {.touch = text("false")},
                  text("circle1.position, circle1.velocity = vec(3.3, 0.5), vec(2, 0) "
                       "circle2.position, circle2.velocity = vec(3.5, 0.7), vec(0, 0.1)")),
             QStringList(text("The circles run through each other")));
}

void TestHitKinds::hitThatKeepsVelocitiesIsNotMissed_data()
{
    QTest::addColumn<QString>("after");
    QTest::addColumn<QString>("headline");
    QTest::newRow("sign of the rebound")
        << text("-e * closing") << text("The sign of e is wrong in the hit of two circles");
    QTest::newRow("small, and of that sign")
        << text("-e ^ 4 * closing") << text("After a hit the circles still run into each other");
}

/// With e = 1 equal circles keep their velocities: nothing of that is a contact.
void TestHitKinds::hitThatKeepsVelocitiesIsNotMissed()
{
    QFETCH(QString, after);
    QFETCH(QString, headline);
    const HitLaw law{.e = text("restitution"),
                     .answer = text("local j = (closing + %1) / (1 / m1 + 1 / m2) "
                                    "p.velocity = p.velocity - j / m1 * n "
                                    "q.velocity = q.velocity + j / m2 * n")
                                   .arg(after)};
    const LawBench bench(task(text("L42T16")));
    QCOMPARE(said(bench, law), QStringList(headline));
}

void TestHitKinds::chanceIsNoRule_data()
{
    QTest::addColumn<QByteArray>("step");
    QTest::addColumn<QString>("answer");
    const auto row = [](const char *name, const char *step, const char *answer) {
        QTest::addRow("%s", name) << QByteArray(step) << text(answer);
    };
    row("the right one's velocity goes to the left one", "L42T10",
        "if p.position.x < q.position.x then p.velocity, q.velocity = q.velocity, vec(0, 0) "
        "else q.velocity, p.velocity = p.velocity, vec(0, 0) end");
    row("the lower one's velocity goes to the upper one", "L42T10",
        "if p.position.y > q.position.y then p.velocity, q.velocity = q.velocity, vec(0, 0) "
        "else q.velocity, p.velocity = p.velocity, vec(0, 0) end");
    row("sum of the vertical velocities", "L42T12",
        "local s = vec(p.velocity.x - q.velocity.x, p.velocity.y + q.velocity.y):dot(n) "
        "if s <= 0 then return end "
        "p.velocity, q.velocity = p.velocity - s * n, q.velocity + s * n");
    row("sum of the horizontal velocities", "L42T12",
        "local s = (p.velocity.x + q.velocity.x) * n.x + (p.velocity.y - q.velocity.y) * n.y "
        "if s <= 0 then return end "
        "p.velocity, q.velocity = p.velocity - s * n, q.velocity + s * n");
    row("densities of equal radii, else radii alone", "L42T15",
        "local a, b = p.density, q.density "
        "if p.radius ~= q.radius then a, b = p.radius ^ 3, q.radius ^ 3 end "
        "local j = 2 * closing / (a + b) "
        "p.velocity, q.velocity = p.velocity - j * b * n, q.velocity + j * a * n");
    row("e of the head-on ones alone", "L42T16",
        "local a, b = p.density * p.radius ^ 3, q.density * q.radius ^ 3 "
        "local e = restitution "
        "if (p.velocity - q.velocity):length() > 1.1 * closing then e = 1 end "
        "local j = (1 + e) * closing / (a + b) "
        "p.velocity, q.velocity = p.velocity - j * b * n, q.velocity + j * a * n");
}

/// What divides the hits that were tried in no other way than by chance is not told, nor that an
/// earlier hit counts where a first one of the same kind comes out alike.
void TestHitKinds::chanceIsNoRule()
{
    QFETCH(QByteArray, step);
    QFETCH(QString, answer);
    const LawBench bench(task(QString::fromLatin1(step)));
    const QString all = bodies(bench, {.mass = text("1"), .answer = answer}).join(QLatin1Char(' '));
    QVERIFY(!all.isEmpty());
    for (const char *rule : {": all ", ": those ", "A later hit"})
        QVERIFY2(!all.contains(text(rule)), qPrintable(all));
}

void TestHitKinds::ruleOfUnequalCirclesIsTold_data()
{
    QTest::addColumn<QString>("answer");
    QTest::addColumn<QString>("rule");
    const auto row = [](const char *name, const char *question, const char *rule) {
        QTest::addRow("%s", name) << text("if %1 then m1, m2 = 1, 1 end "
                                          "local j = 2 * closing / (1 / m1 + 1 / m2) "
                                          "p.velocity, q.velocity = p.velocity - j / m1 * n, "
                                          "q.velocity + j / m2 * n")
                                         .arg(text(question))
                                  << text(rule);
    };
    row("below the middle", "p.position.y < 0",
        "all at y = # m and above, none at y = # m and below");
    row("right of the middle", "p.position.x > 0",
        "all at x = # m and left of it, none at x = # m and right of it");
    row("fast", "closing > 2", "all with up to # m/s, none with # m/s or more");
}

/// Where only some circles count as equally heavy, no power of the radius is told: of equal ones
/// all come out right.
void TestHitKinds::ruleOfUnequalCirclesIsTold()
{
    QFETCH(QString, answer);
    QFETCH(QString, rule);
    const LawBench bench(task(QStringLiteral("L42T14")));
    const QStringList all = bodies(bench, {.answer = answer});
    QCOMPARE(all.size(), qsizetype{1});
    QVERIFY2(all[0].startsWith(text("Some hits of the two circles come out wrong")),
             qPrintable(all[0]));
    const auto n = told::numbersIn(
        all[0], qPrintable(text("Of # hits of unequal circles tried, # came out right: ") + rule));
    QVERIFY2(n.size() == 4, qPrintable(all[0]));
    QVERIFY(n[1] > 2.0 && n[1] < n[0]);
    QVERIFY2(all[0].contains(text("r₁ = ")), qPrintable(all[0]));
}

/// Circles that are moved apart for some steps more meet the next time before that is over.
void TestHitKinds::restOfAHitIsNoAnswer()
{
    const LawBench bench(task(QStringLiteral("L42T12")));
    const QString start = text("left = 0");
    const QString rest =
        text("if left > 0 then left = left - 1 "
             "p.position, q.position = p.position - 0.05 * n, q.position + 0.05 * n end");
    const QString program =
        written({.start = start,
                 .walls = wallsOf(wallWays[1], "c.radius", "1"),
                 .hit = text("local d = q.position - p.position local n = d:normalized() "
                             "local closing = (p.velocity - q.velocity):dot(n) "
                             "if closing > 0 and d:length() < p.radius + q.radius then "
                             "p.velocity, q.velocity = p.velocity - closing * n, "
                             "q.velocity + closing * n left = 5 end ")
                        + rest},
                structures[3]);
    const MeasuredLaws own(&program, bench.ground);
    const ConditionedAspect found = conditioned(
        Aspect::Contact, contactDeviations(own.pair(), bench.right.pair(), bench.ground), own,
        bench.right, bench.ground, {});
    QCOMPARE(LawBench::headlines(found.deviations),
             QStringList(text("A hit puts circle 1 too far away")));
}

/// What comes out wrong with other speeds is no matter of the first hit.
void TestHitKinds::roundedPushIsNoHistory()
{
    const LawBench bench(task(QStringLiteral("L42T12")));
    const QString all =
        bodies(bench, {.mass = text("1"),
                       .answer = text("local j = math.floor(10 * closing + 0.5) / 10 "
                                      "p.velocity, q.velocity = p.velocity - j * n, "
                                      "q.velocity + j * n")})
            .join(QLatin1Char(' '));
    QVERIFY(!all.isEmpty());
    QVERIFY2(!all.contains(text("the first in a run")), qPrintable(all));
}

QTEST_GUILESS_MAIN(TestHitKinds)
#include "test_hit_kinds.moc"
