// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_law_words.h"

#include "tests/told_hit.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// One law that fits all hits of a program is told as the cause, in whichever way it is written.
class TestToldAnswers : public ToldHit
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void lengthOfTheNormalIsToldWithItsE();
    void lawOfAllHitsIsTold_data();
    void lawOfAllHitsIsTold();
    void exchangedResultsAreNoMissedHits();
    void zeroPushIsNoMissedHit();
};

namespace {

const QString givenE = QStringLiteral("restitution");

/// The new part along the normal is ONE for circle 1 and TWO for circle 2; c is that of the centre
/// of mass.
QString newParts(const char *one, const char *two)
{
    return QStringLiteral("local a, b = p.velocity:dot(n), q.velocity:dot(n) "
                          "local c = (m1 * a + m2 * b) / (m1 + m2) "
                          "local one, two = %1, %2 "
                          "p.velocity = p.velocity + (one - a) * n "
                          "q.velocity = q.velocity + (two - b) * n")
        .arg(QLatin1String(one), QLatin1String(two));
}

QString headlineOf(const LawDeviation &found)
{
    return found.message.section(QLatin1Char('\n'), 0, 0);
}

} // namespace

void TestToldAnswers::lengthOfTheNormalIsToldWithItsE()
{
    const QString program =
        written({.walls = wallsOf(wallWays[1]),
                 .hit = hitOf(hitWays[1], {.normal = QStringLiteral("d / reach"), .e = givenE})},
                structures[1]);
    const LawBench bench(task(QStringLiteral("L42T16")));
    const MeasuredLaws own(&program, bench.ground);
    const auto found = overlapDeviation(own.pair(), bench.right.pair());
    QVERIFY(found);
    const auto n = numbersIn(found->message,
                             "With e = # and a timestep of 1/60 s the circles parted with # times "
                             "the speed along the push that they met with; # is right.");
    QVERIFY2(n.size() == 3, qPrintable(found->message));
    QCOMPARE(n[2], n[0]);
    // The normal is at most one step's way shorter than 1, and its length comes in twice.
    QVERIFY(n[1] < n[2] && 1.0 + n[1] > 0.9 * (1.0 + n[2]));
}

void TestToldAnswers::lawOfAllHitsIsTold_data()
{
    QTest::addColumn<QString>("normal");
    QTest::addColumn<QString>("answer");
    QTest::addColumn<QString>("headline");
    const QString unit = QStringLiteral("d:normalized()");
    const auto parts = [&](const char *headline, const char *one, const char *two) {
        QTest::newRow(headline) << unit << newParts(one, two) << QString::fromUtf8(headline);
    };
    const auto normal = [](const char *name, const char *text, const char *headline) {
        QTest::newRow(name) << QString::fromUtf8(text) << HitLaw().answer
                            << QString::fromUtf8(headline);
    };
    parts("e multiplies the whole new part of circle 1", "e * (c + (c - a))", "c + e * (c - b)");
    parts("e multiplies the whole new part of circle 2", "c + e * (c - a)",
          "e * (c + e * (c - b))");
    parts("e multiplies both whole new parts", "e * (2 * c - a)", "e * (2 * c - b)");
    parts("Each circle gets the new part of the other", "c + e * (c - b)", "c + e * (c - a)");
    parts("The momenta along the line of centres change hands", "m2 * b / m1", "m1 * a / m2");
    parts("The new parts along the line of centres have a wrong size",
          "(m1 + m2) / (m1 - m2) * (c + e * (c - a))", "(m1 + m2) / (m1 - m2) * (c + e * (c - b))");
    parts("Both pushes have a wrong size", "a - (1 + e) * m2 / (m1 - m2) * closing",
          "b + (1 + e) * m1 / (m1 - m2) * closing");
    parts("Each circle leaves with e times the momentum of the other", "e * m2 * b / m1",
          "e * m1 * a / m2");
    parts("What the two have in common does not depend on the masses", "(a + b) / 2 + e * (c - a)",
          "(a + b) / 2 + e * (c - b)");
    parts("The rebound is shared half and half, whatever the masses are", "c + e / 2 * (b - a)",
          "c + e / 2 * (a - b)");
    normal("divided twice", "d / d:length() ^ 2", "The normal does not have length 1");
    normal("never divided", "d", "The normal does not have length 1");
    QTest::newRow("push divided by the distance")
        << unit
        << QStringLiteral("local j = (1 + e) * closing / (1 / m1 + 1 / m2) / d:length() "
                          "p.velocity = p.velocity - j / m1 * n "
                          "q.velocity = q.velocity + j / m2 * n")
        << QStringLiteral("The push is divided by the distance of the centres");
}

void TestToldAnswers::lawOfAllHitsIsTold()
{
    QFETCH(QString, normal);
    QFETCH(QString, answer);
    QFETCH(QString, headline);
    for (const int way : {0, 1, 2}) {
        const auto all = found(
            written({.walls = wallsOf(wallWays[1], "c.radius", "1"),
                     .hit = hitOf(hitWays[way], {.normal = normal, .e = givenE, .answer = answer})},
                    structures[way + 1]));
        QStringList said;
        for (const LawDeviation &each : all) {
            if (each.aspect == Aspect::Response)
                said.append(headlineOf(each));
        }
        QVERIFY2(said.contains(headline),
                 qPrintable(QString::number(way) + said.join(QStringLiteral("; "))));
    }
}

/// In step 14 two equal circles without losses then keep their velocities.
void TestToldAnswers::exchangedResultsAreNoMissedHits()
{
    const QString program =
        written({.walls = wallsOf(wallWays[1]),
                 .hit = hitOf(hitWays[0], {.answer = newParts("2 * c - b", "2 * c - a")})},
                structures[1]);
    const LawBench bench(task(QStringLiteral("L42T14")));
    const MeasuredLaws own(&program, bench.ground);
    const auto contact = contactDeviations(own.pair(), bench.right.pair(), bench.ground);
    QVERIFY2(contact.empty(), contact.empty() ? "" : qPrintable(contact.front().message));
    const auto all = responseDeviations(own.pair(), bench.right.pair(), bench.ground);
    QCOMPARE(all.size(), std::size_t{1});
    QCOMPARE(headlineOf(all.front()), QStringLiteral("Each circle gets the new part of the other"));
}

/// In step 11 circle 2 rests, and a push made of its velocity is none; in the own scene it moves.
void TestToldAnswers::zeroPushIsNoMissedHit()
{
    const QString program = written(
        {.start = QStringLiteral("circle1.position, circle1.velocity = vec(-2, 2.3), vec(2, 0) "
                                 "circle2.position, circle2.velocity = vec(2, 2), vec(0.1, 0)"),
         .walls = wallsOf(wallWays[1]),
         .hit = hitOf(hitWays[0], {.answer = QStringLiteral("local j = q.velocity:dot(n) "
                                                            "p.velocity = p.velocity - j * n "
                                                            "q.velocity = q.velocity + j * n")})},
        structures[0]);
    const LawBench bench(task(QStringLiteral("L42T11")));
    Ground ground = bench.ground;
    const MeasuredLaws own(&program, ground);
    const auto contact = contactDeviations(own.pair(), bench.right.pair(), ground);
    QVERIFY(!contact.empty());
    QCOMPARE(headlineOf(contact.front()),
             QStringLiteral("The circles are held and keep their velocities"));
    QVERIFY2(contact.front().message.contains(QStringLiteral(
                 "In all 6 meetings tried circle 2 was at rest; in your own scene it came with "
                 "(0.1, 0) m/s")),
             qPrintable(contact.front().message));
}

QTEST_GUILESS_MAIN(TestToldAnswers)
#include "test_told_answers.moc"
