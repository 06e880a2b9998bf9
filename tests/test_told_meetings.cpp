// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_words.h"
#include "tasks/judging/response_law_words.h"

#include "tests/told_meeting.h"

#include <algorithm>
#include <cmath>

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// The numbers that findings on meetings tell that are not answered, or in a way of their own.
class TestToldMeetings : public ToldMeeting
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void partingIsTold();
    void distancesOfTwoStepsAreToldAsSuch();
    void meetingCentresAreTold();
    void circlesPutTogetherAreTold();
    void reboundByTheOverlapIsTold();
    void noAnswerAtAllIsTold();
    void answerWithLossesAloneIsOne();
    void answerThatNobodyAskedForIsTold();
    void placeOfALeapIsTold();
    void laterHitIsTold_data();
    void laterHitIsTold();
    void smallPushIsOne();
    void partsOfOtherRadiiAreTold();
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

const QString equal = QStringLiteral("1"); // masses

} // namespace

/// In the step in which the centres pass each other, and never after it.
void TestToldMeetings::meetingCentresAreTold()
{
    const QString said = body("L42T10",
                              {.touch = text("d:dot(oldq - oldp) < 0"),
                               .normal = text("(oldq - oldp):normalized()"),
                               .mass = equal},
                              text("The circles answer where their centres meet"));
    const auto n = numbersIn(said, "They ran into each other until their centres were # m apart");
    QVERIFY2(n.size() == 1 && n[0] < 0.03, qPrintable(said));
}

void TestToldMeetings::circlesPutTogetherAreTold()
{
    const QString said =
        body("L42T9",
             {.answer = text("p.velocity, q.velocity = vec(0, 0), vec(0, 0) "
                             "p.position = (p.position + q.position) / 2 q.position = p.position")},
             text("A hit puts the circles into each other"));
    const auto n = numbersIn(said, "They came until their centres were # m apart, and the step "
                                   "with the answer put them # m apart; rims touch at # m.");
    QVERIFY2(n.size() == 3 && n[1] == 0.0 && n[0] < n[2], qPrintable(said));
}

/// The way from one to the other, by the sum of the radii: of length 1 where rims just touch.
void TestToldMeetings::reboundByTheOverlapIsTold()
{
    const LawBench bench(task(QStringLiteral("L42T12")));
    const auto told = [&](const QString &normal) {
        const QString program =
            written({.walls = wallsOf(wallWays[1], "c.radius", "1"),
                     .hit = hitOf(hitWays[0], {.normal = normal, .mass = equal})},
                    structures[0]);
        const MeasuredLaws own(&program, bench.ground);
        return overlapDeviation(own.pair(), bench.right.pair());
    };
    const auto said = told(text("d / reach"));
    QVERIFY(said);
    const auto n = numbersIn(said->message, "the circles parted with # times the speed along the "
                                            "push that they met with; # is right.");
    QVERIFY2(n.size() == 2 && n[0] > 0.5 && n[0] < 0.99 && n[1] == 1.0, qPrintable(said->message));
    QVERIFY(!told(text("d:normalized()")));
    QVERIFY(!told(text("0.9 * d:normalized()"))); // whose length is another
}

void TestToldMeetings::partingIsTold()
{
    const QString said = body("L42T12", {.approach = text("closing < 0"), .mass = equal},
                              text("The circles answer when they part, not when they meet"));
    const auto n = numbersIn(said, "They ran into each other until their centres were # m apart");
    QVERIFY2(n.size() == 1, qPrintable(said));
    QVERIFY(n[0] >= 0.0 && n[0] < 0.4); // of two radii of 0.2 m
}

/// Whether they come nearer shows in the distance of the step before, of which the first step of a
/// run knows none: what that answers, or not, is no law.
void TestToldMeetings::distancesOfTwoStepsAreToldAsSuch()
{
    const auto shrinks = [&](const char *sign) {
        return LawProgram{.start = text("last = math.huge"),
                          .walls = text(""),
                          .hit = text("local d = (q.position - p.position):length() "
                                      "if d < p.radius + q.radius and d %1 last then "
                                      "p.velocity, q.velocity = q.velocity, p.velocity end "
                                      "last = d")
                                     .arg(text(sign))};
    };
    const LawBench bench(task(text("L42T10")));
    const auto found = [&](const char *sign) {
        const QString program = written(shrinks(sign), structures[0]);
        const MeasuredLaws own(&program, bench.ground);
        return contactDeviations(own.pair(), bench.right.pair(), bench.ground);
    };
    QCOMPARE(LawBench::headlines(found("<")), QStringList());
    const QString said =
        bodyOf(found(">"), text("The circles answer when they part, not when they meet"));
    QVERIFY2(said.contains(text("less than in the step before")), qPrintable(said));
}

void TestToldMeetings::noAnswerAtAllIsTold()
{
    const QString never =
        body("L42T14", {.touch = text("false")}, text("The circles run through each other"));
    // Six ways for two of unlike radii, two for them exchanged, one for two large ones.
    QCOMPARE(numbersIn(never, "From all # directions"), std::vector<double>{9.0});
    const QString held = text("The circles are held and keep their velocities");
    QVERIFY(
        body("L42T14", {.answer = text("p.position, q.position = oldp, oldq")}, held)
            .startsWith(QLatin1String("When they touched neither moved on as its velocity says")));
    QVERIFY(body("L42T14", {.answer = text("p.position = oldp + p.velocity * h")}, held)
                .startsWith(QLatin1String("When they touched circle 2 did not move on")));
}

/// Where e is 1 it comes to nothing.
void TestToldMeetings::answerWithLossesAloneIsOne()
{
    const QString answer = text("local j = (1 - restitution) * closing / (1 / m1 + 1 / m2) "
                                "p.velocity = p.velocity - j / m1 * n "
                                "q.velocity = q.velocity + j / m2 * n");
    const QString headline = text("The circles are held and keep their velocities");
    QVERIFY(body("L42T16", {.answer = answer}, headline).isEmpty());
    QVERIFY(!body("L42T14", {.answer = answer}, headline).isEmpty()); // which has no other e
}

void TestToldMeetings::answerThatNobodyAskedForIsTold()
{
    int told = 0;
    for (const Task &each : m_lab.tasks) {
        const LawBench bench(each);
        const auto &contacts = bench.right.pair().contacts;
        if (contacts.empty()
            || std::any_of(contacts.begin(), contacts.end(),
                           [](const PairHit &hit) { return hit.answered; }))
            continue;
        const QByteArray id = each.id.toUtf8();
        QVERIFY2(
            !body(id.constData(), {.mass = equal}, text("The circles act on each other")).isEmpty(),
            id.constData());
        QVERIFY(body(id.constData(), {.touch = text("false")}, {}).isEmpty());
        ++told;
    }
    QVERIFY(told > 0);
}

void TestToldMeetings::placeOfALeapIsTold()
{
    const LawBench bench(task(QStringLiteral("L42T14")));
    for (const int circle : {1, 2}) {
        const QString hit = hitOf(
            {"leap", "", circle == 1 ? "p.position = vec(0.5, 3)" : "q.position = vec(0.5, 3)"});
        const QString program =
            written({.walls = wallsOf(wallWays[1], "c.radius", "1"), .hit = hit}, structures[1]);
        const MeasuredLaws own(&program, bench.ground);
        const QString said =
            bodyOf(contactDeviations(own.pair(), bench.right.pair(), bench.ground),
                   QStringLiteral("A hit puts circle %1 somewhere else").arg(circle));
        QCOMPARE(numbersIn(said, "When they touched it was put to (#, #) m"),
                 (std::vector<double>{0.5, 3.0}));
    }
}

void TestToldMeetings::laterHitIsTold_data()
{
    QTest::addColumn<QString>("given"); // e of a hit; `used` is so from the first on
    QTest::addColumn<QString>("headline");
    QTest::addColumn<double>("first");
    QTest::addColumn<double>("second");
    QTest::newRow("late") << "(used and restitution or 1)"
                          << "e acts only after the first hit" << 1.0 << 0.5;
    QTest::newRow("another") << "(used and 0.9 or restitution)"
                             << "A later hit is answered with another e" << 0.5 << 0.9;
}

void TestToldMeetings::laterHitIsTold()
{
    QFETCH(QString, given);
    QFETCH(QString, headline);
    QFETCH(double, first);
    QFETCH(double, second);
    HitLaw law{.e = given};
    law.answer += QStringLiteral(" used = true");
    const QString said = body("L42T16", law, headline, QStringLiteral("used = false"));
    const auto n = numbersIn(said, "With e = # two circles parted with # times the speed that they "
                                   "met with; in their second hit, back from a wall, it was # "
                                   "times.");
    QVERIFY2(n.size() == 3, qPrintable(said));
    QCOMPARE(n[0], 0.5);
    QVERIFY(isNear(n[1], first));
    QVERIFY(isNear(n[2], second));
}

/// Divided by the sum of the masses, in kg, in place of the sum of what they divide.
void TestToldMeetings::smallPushIsOne()
{
    const HitLaw law{.mass = text("4189 * c.density * c.radius ^ 3"),
                     .answer = text("local j = 2 * closing / (m1 + m2) "
                                    "p.velocity = p.velocity - j / m1 * n "
                                    "q.velocity = q.velocity + j / m2 * n")};
    QVERIFY(body("L42T14", law, text("Some hits of the two circles are not answered")).isEmpty());
    QVERIFY(!body("L42T14", law, text("The push has a wrong size that depends on")).isEmpty());
}

/// Where nobody asks for masses yet: what changes hands is weighted with the radii.
void TestToldMeetings::partsOfOtherRadiiAreTold()
{
    const auto weighted = [](const char *share) {
        return text("local u, w = p.velocity:dot(n), q.velocity:dot(n) "
                    "local k = %1 "
                    "p.velocity = p.velocity + (w * k - u) * n "
                    "q.velocity = q.velocity + (u / k - w) * n")
            .arg(text(share));
    };
    const QString headline = text("Circles of different radii come out of a hit wrong");
    const QString said = body("L42T13", {.answer = weighted("q.radius / p.radius")}, headline);
    const auto n = numbersIn(said, "With r₁ = # and r₂ = # m: Along the line of centres, from 1 to "
                                   "2, circle 1 came with # m/s and circle 2 with # m/s; they left "
                                   "with # and #; # and # are right.");
    QVERIFY2(n.size() == 8, qPrintable(said));
    QVERIFY(std::abs(n[4] - n[3] * n[1] / n[0]) < 0.01);
    QVERIFY(isNear(n[6], n[3]) && isNear(n[7], n[2]));
    QVERIFY(body("L42T13", {.answer = weighted("1")}, headline).isEmpty());
    QVERIFY(body("L42T13", {}, headline).isEmpty()); // as balls, which is allowed, too
}

QTEST_GUILESS_MAIN(TestToldMeetings)
#include "test_told_meetings.moc"
