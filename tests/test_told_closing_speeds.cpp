// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_words.h"

#include "tests/told_meeting.h"

#include <cmath>

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// The numbers that findings on hits tell that are answered or not by how fast circles close.
class TestToldClosingSpeeds : public ToldMeeting
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void slowMeetingIsTold();
    void slowMeetingThatIsPutApartIsTold();
    void fastMeetingIsTold();
    void speedOfOneInTheQuestionIsTold();
    void wrongPartOfTheApproachIsTold_data();
    void wrongPartOfTheApproachIsTold();
    void meetingThatIsNotFastEnoughIsTold();
    void placeIsNoPause();
    void slowReboundIsTold();
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

const QString equal = QStringLiteral("1"); // masses

} // namespace

/// From a tenth of a metre in a second on they are answered.
void TestToldClosingSpeeds::slowMeetingIsTold()
{
    const QString said = body("L42T12", {.approach = text("closing > 0.1"), .mass = equal},
                              text("Circles that come nearer slowly are not answered"));
    const auto n = numbersIn(
        said, "They came nearer with # m/s and ran into each other; with # m/s they are answered.");
    QVERIFY2(n.size() == 2, qPrintable(said));
    QVERIFY(n[0] > 0.0 && n[0] < 0.1);
    QVERIFY(isNear(n[1], 1.2));
}

/// Put back, and with the old velocities.
void TestToldClosingSpeeds::slowMeetingThatIsPutApartIsTold()
{
    const QString said = body("L42T12",
                              {.mass = equal,
                               .answer = text("if closing > 0.3 then p.velocity = p.velocity - "
                                              "closing * n q.velocity = q.velocity + closing * n "
                                              "end")},
                              text("Circles that come nearer slowly are not answered"));
    const auto n = numbersIn(said, "They came nearer with # m/s, touched and kept their velocities;"
                                   " with # m/s they are answered.");
    QVERIFY2(n.size() == 2 && n[0] < 0.3, qPrintable(said));
}

/// More than two centimetres deep they are not answered.
void TestToldClosingSpeeds::fastMeetingIsTold()
{
    const QString said =
        body("L42T12",
             {.touch = text("d:length() < reach and reach - d:length() < 0.025"), .mass = equal},
             text("Circles that come nearer fast are not answered"));
    const auto n = numbersIn(
        said, "They came nearer with # m/s and ran into each other; with # m/s they are answered.");
    QVERIFY2(n.size() == 2, qPrintable(said));
    QVERIFY(n[0] > 3.0 && n[1] < 1.5);
}

/// Circles that stop each other, unless the first is fast.
void TestToldClosingSpeeds::speedOfOneInTheQuestionIsTold()
{
    for (const char *one : {"p", "q"}) {
        const QString said =
            body("L42T9",
                 {.touch = text("d:length() < reach and %1.velocity:length() < 3").arg(text(one)),
                  .answer = text("p.velocity, q.velocity = vec(0, 0), vec(0, 0)")},
                 text("Circles that come nearer fast are not answered"));
        const auto n = numbersIn(said, "They came nearer with # m/s");
        QVERIFY2(n.size() == 1 && n[0] > 3.0, qPrintable(said));
    }
}

void TestToldClosingSpeeds::wrongPartOfTheApproachIsTold_data()
{
    QTest::addColumn<QString>("x");
    QTest::addColumn<QString>("y");
    QTest::newRow("sum in y") << "p.velocity.x - q.velocity.x"
                              << "p.velocity.y + q.velocity.y";
    QTest::newRow("x alone") << "p.velocity.x - q.velocity.x"
                             << "0";
    QTest::newRow("y alone") << "0"
                             << "p.velocity.y - q.velocity.y";
    QTest::newRow("minus") << "p.velocity.x - q.velocity.x"
                           << "q.velocity.y - p.velocity.y";
}

/// Level or upright, where the other part is nothing, at the latest.
void TestToldClosingSpeeds::wrongPartOfTheApproachIsTold()
{
    QFETCH(QString, x);
    QFETCH(QString, y);
    const QString said = body("L42T10",
                              {.approach = text("(%1) * d.x + (%2) * d.y > 0").arg(x, y),
                               .answer = text("p.velocity, q.velocity = q.velocity, p.velocity")},
                              text("Some hits of the two circles are "));
    const auto n = numbersIn(said, "Of 36 meetings tried, # were answered in time");
    QVERIFY2(n.size() == 1 && n[0] < 36.0, qPrintable(said));
}

/// Only those that are faster than any in the checks are answered.
void TestToldClosingSpeeds::meetingThatIsNotFastEnoughIsTold()
{
    const QString said = body("L42T12", {.approach = text("closing > 1.8"), .mass = equal},
                              text("Circles that come nearer slowly are not answered"));
    const auto n = numbersIn(
        said, "They came nearer with # m/s and ran into each other; with # m/s they are answered.");
    QVERIFY2(n.size() == 2, qPrintable(said));
    QVERIFY(n[0] < 1.8 && n[1] > 1.8);
}

/// Near a wall nothing is answered, the first hit as little as a second one.
void TestToldClosingSpeeds::placeIsNoPause()
{
    const QString said =
        body("L42T12",
             {.approach = text("closing > 0 and math.max(p.position.x, q.position.x) < 3.3"),
              .mass = equal},
             text("Not every meeting is answered"));
    const auto n = numbersIn(said, "Near (#, #) m circle 1 came with");
    QVERIFY2(n.size() == 2, qPrintable(said));
    QVERIFY(n[0] > 3.0);
}

void TestToldClosingSpeeds::slowReboundIsTold()
{
    const QString said =
        body("L42T16", {.e = text("(p.velocity - q.velocity):length() < 0.3 and 1 or restitution")},
             text("Circles that meet slowly are answered in another way"));
    const auto n = numbersIn(said, "With e = #: Along");
    QCOMPARE(n, std::vector<double>{0.5});
    const auto fast = numbersIn(said, "Where they meet with # m/s, it comes out right.");
    QVERIFY2(fast.size() == 1 && fast[0] > 1.0, qPrintable(said));
    const auto parts =
        numbersIn(said, "circle 1 came with # m/s and circle 2 with # m/s; they left "
                        "with # and #; # and # are right.");
    QVERIFY2(parts.size() == 6, qPrintable(said));
    const double closing = parts[0] - parts[1];
    QVERIFY(closing > 0.0 && closing < 0.1);
    QVERIFY(std::abs(parts[3] - parts[2] - closing) < 1e-3);       // e = 1
    QVERIFY(std::abs(parts[5] - parts[4] - 0.5 * closing) < 1e-3); // e = 0.5
}

QTEST_GUILESS_MAIN(TestToldClosingSpeeds)
#include "test_told_closing_speeds.moc"
