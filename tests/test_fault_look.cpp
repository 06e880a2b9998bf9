// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/fault_look.h"

#include "tests/scenes.h"

#include <QTest>

using namespace cradle;
using namespace cradle::scenes;

/// Whether a changed program is told from the reference: in the moment, in a scene like it, and
/// from the midst of its run.
class TestFaultLook : public QObject
{
    Q_OBJECT
private slots:
    void rightProgramShowsNothing();
    void otherSceneOfAHitIsLikeTheFirst_data();
    void otherSceneOfAHitIsLikeTheFirst();
    void otherSceneOfAFlightMovesOtherwise_data();
    void otherSceneOfAFlightMovesOtherwise();
    void whatIsRightByChanceIsSeenOnce();
    void slackIsThatOfTheFault_data();
    void slackIsThatOfTheFault();
    void velocitiesAreComparedToThreePercent_data();
    void velocitiesAreComparedToThreePercent();
    void answerMayComeTwoStepsLater_data();
    void answerMayComeTwoStepsLater();
    void circlesThatAreNotWrongMayGoOn();
    void whatIsKeptIsSeenFromTheMidst();
    void stoppedProgramIsWrong();
    void programWithoutEndIsGivenUp();
};

namespace {

/// In it `c` is every circle, `i` its index, `n` the step, from 1. Those that stand at rest, alone
/// or not, are right where the reference leaves them.
QString everyCircle(const QString &text)
{
    return QStringLiteral("function on_update(h) local n = step + 1 "
                          "for i, c in ipairs(circles) do %1 end end")
        .arg(text);
}

const QString moves = QStringLiteral("c.position = c.position + c.velocity * h ");
/// The fault: velocities fade.
const QString fades = moves + QStringLiteral("c.velocity = 0.8 * c.velocity");

/// The reference where \p condition holds, else the fault.
QString rightWhere(const char *condition)
{
    return everyCircle(moves
                       + QStringLiteral("if not (%1) then c.velocity = 0.8 * c.velocity end")
                             .arg(QLatin1String(condition)));
}

Preset two(Vec2 gravity = {})
{
    Preset preset = scene({circle({-2.0, 1.0}, {2.0, 1.5}), circle({1.0, -1.0}, {-1.0, 0.7})}, {});
    preset.gravity = gravity;
    preset.timestep = 0.01;
    return preset;
}

Moment at(qint64 step, const Preset &preset = two())
{
    return {.stage = {preset, true}, .step = step, .circles = {0, 1}};
}

/// What is seen of \p program where the reference moves and the student's velocities fade.
Sight sightOf(const QString &program, const Moment &moment, bool isHit, bool isQuestion = false)
{
    const QString student = everyCircle(fades);
    const QString reference = everyCircle(moves);
    FaultLook look(student, reference, moment, isHit, isQuestion);
    return look.showsFault() ? look.of(program) : Sight::Wrong;
}

} // namespace

void TestFaultLook::rightProgramShowsNothing()
{
    const QString right = everyCircle(moves);
    const QString wrong = everyCircle(fades);
    const Moment moment = at(1);
    QVERIFY(!FaultLook(right, right, moment, true, false).showsFault());
    FaultLook look(wrong, right, moment, true, false);
    QVERIFY(look.showsFault());
    QCOMPARE(look.of(right), Sight::Twice);
    QCOMPARE(look.of(wrong), Sight::Wrong);
}

void TestFaultLook::otherSceneOfAHitIsLikeTheFirst_data()
{
    QTest::addColumn<QByteArray>("condition");
    QTest::addColumn<Sight>("seen");
    const auto row = [](const char *condition, Sight seen) {
        QTest::newRow(condition) << QByteArray(condition) << seen;
    };
    // Velocities are up to a twentieth off, and not the same.
    row("math.abs(c.velocity.x) > (i == 1 and 2.05 or 1.02) or i == 1 and c.velocity.x == 2 or "
        "i == 2 and c.velocity.x == -1",
        Sight::Twice);
    row("math.abs(c.velocity.x) < (i == 1 and 2.15 or 1.08)", Sight::Twice);
    row("math.abs(c.velocity.y) > (i == 1 and 1.4 or 0.65)", Sight::Twice);
    row("math.abs(c.velocity.x) <= (i == 1 and 2 or 1)", Sight::Once);
    row("math.abs(c.velocity.y) >= (i == 1 and 1.5 or 0.7)", Sight::Once);
    // One mass is a third larger, but not those of both.
    row("c.density < 7.9 or i == 2", Sight::Twice);
    row("c.density < 7.9 or i == 2 and c.density > 10 and c.density < 10.3", Sight::Twice);
    row("c.density < 7.9", Sight::Once);
}

void TestFaultLook::otherSceneOfAHitIsLikeTheFirst()
{
    QFETCH(QByteArray, condition);
    QFETCH(Sight, seen);
    QCOMPARE(sightOf(rightWhere(condition.constData()), at(1), true), seen);
}

void TestFaultLook::otherSceneOfAFlightMovesOtherwise_data()
{
    QTest::addColumn<QByteArray>("condition");
    QTest::addColumn<Sight>("seen");
    const auto row = [](const char *condition, Sight seen) {
        QTest::newRow(condition) << QByteArray(condition) << seen;
    };
    // 0.37 m/s more to the right and about as much less, a quarter more upwards; no other mass.
    row("c.velocity.x < (i == 1 and 2.44 or -0.9)", Sight::Once);
    row("c.velocity.x > (i == 1 and 1.9 or -1.38)", Sight::Once);
    row("c.velocity.x < (i == 1 and 2.5 or -0.9)", Sight::Twice);
    row("c.velocity.x > (i == 1 and 1.9 or -1.45)", Sight::Twice);
    row("c.velocity.y < (i == 1 and 1.7 or 0.95)", Sight::Twice);
    row("c.velocity.y < (i == 1 and 1.6 or 0.8)", Sight::Once);
    row("c.density == 7.8", Sight::Twice);
}

void TestFaultLook::otherSceneOfAFlightMovesOtherwise()
{
    QFETCH(QByteArray, condition);
    QFETCH(Sight, seen);
    QCOMPARE(sightOf(rightWhere(condition.constData()), at(1), false), seen);
}

/// Numbers in place of velocities.
void TestFaultLook::whatIsRightByChanceIsSeenOnce()
{
    const QString numbers =
        everyCircle(moves + QStringLiteral("c.velocity = i == 1 and vec(2, 1.5) or vec(-1, 0.7)"));
    QCOMPARE(sightOf(numbers, at(1), true), Sight::Once);
    QCOMPARE(sightOf(numbers, at(1), false), Sight::Once);
}

void TestFaultLook::slackIsThatOfTheFault_data()
{
    QTest::addColumn<bool>("isPosition");
    QTest::addColumn<bool>("isHit");
    QTest::addColumn<bool>("isQuestion");
    QTest::addColumn<double>("slack"); // m
    // g = 10 m/s², h = 0.01 s: of a fall of 1 mm less than a half.
    QTest::newRow("place in a flight") << true << false << false << 0.4e-3;
    QTest::newRow("place at a hit") << true << true << false << 0.2;
    QTest::newRow("answer") << false << true << false << 0.2;
    // Three steps' way of the fastest: 2.5 m/s, 2.55 in the other scene.
    QTest::newRow("question") << false << true << true << 0.075;
}

void TestFaultLook::slackIsThatOfTheFault()
{
    QFETCH(bool, isPosition);
    QFETCH(bool, isHit);
    QFETCH(bool, isQuestion);
    QFETCH(double, slack);
    Moment moment = at(1, two({0.0, -10.0}));
    moment.isPosition = isPosition;
    const QString student = everyCircle(QStringLiteral("c.position = vec(3, 3)"));
    const QString reference = everyCircle(moves);
    FaultLook look(student, reference, moment, isHit, isQuestion);
    const auto seen = [&](double share) {
        return look.of(
            everyCircle(moves
                        + QStringLiteral("if n == 1 then c.position = c.position + vec(0, %1) end")
                              .arg(share * slack, 0, 'g', 17)));
    };
    QCOMPARE(seen(0.9), Sight::Twice);
    QCOMPARE(seen(1.1), Sight::Wrong);
}

void TestFaultLook::velocitiesAreComparedToThreePercent_data()
{
    QTest::addColumn<double>("factor");
    QTest::addColumn<Sight>("seen");
    // Of 1 m/s and the velocity: 2 m/s and 1.94, say, are 0.06 apart where 0.09 are borne.
    QTest::newRow("four percent") << 0.96 << Sight::Twice;
    QTest::newRow("six percent") << 0.94 << Sight::Wrong;
}

void TestFaultLook::velocitiesAreComparedToThreePercent()
{
    QFETCH(double, factor);
    QFETCH(Sight, seen);
    QCOMPARE(sightOf(everyCircle(moves
                                 + QStringLiteral("if n == 1 then c.velocity = %1 * c.velocity end")
                                       .arg(factor)),
                     at(1), true),
             seen);
}

void TestFaultLook::answerMayComeTwoStepsLater_data()
{
    QTest::addColumn<int>("late");
    QTest::addColumn<Sight>("seen");
    QTest::newRow("at once") << 0 << Sight::Twice;
    QTest::newRow("one step") << 1 << Sight::Twice;
    QTest::newRow("two steps") << 2 << Sight::Twice;
    QTest::newRow("three steps") << 3 << Sight::Wrong;
}

/// In step 3 velocities turn round.
void TestFaultLook::answerMayComeTwoStepsLater()
{
    QFETCH(int, late);
    QFETCH(Sight, seen);
    const auto turns = [](int step) {
        return everyCircle(
            moves + QStringLiteral("if n == %1 then c.velocity = -1 * c.velocity end").arg(step));
    };
    const QString never = everyCircle(moves);
    const QString reference = turns(3);
    const Moment moment = at(3);
    FaultLook look(never, reference, moment, true, false);
    QVERIFY(look.showsFault());
    QCOMPARE(look.of(turns(3 + late)), seen);
}

/// Circle 2 may do what the reference does or what it did; circle 1 is wrong, and may not.
void TestFaultLook::circlesThatAreNotWrongMayGoOn()
{
    const QString student = everyCircle(fades);
    const QString reference = everyCircle(moves);
    Moment moment = at(1);
    moment.circles = {0};
    FaultLook look(student, reference, moment, true, false);
    QCOMPARE(look.of(rightWhere("i == 1")), Sight::Twice);
    QCOMPARE(look.of(rightWhere("true")), Sight::Twice);
    QCOMPARE(look.of(rightWhere("i == 2")), Sight::Wrong);
    QCOMPARE(look.of(everyCircle(moves
                                 + QStringLiteral("if i == 2 then c.velocity = vec(0, 9) "
                                                  "end"))),
             Sight::Wrong);
}

/// Velocities fade from step 12 on; who counts his own steps does not notice when he begins later.
void TestFaultLook::whatIsKeptIsSeenFromTheMidst()
{
    const QString student =
        everyCircle(moves + QStringLiteral("if n > 9 then c.velocity = 0.8 * c.velocity end"));
    const QString reference = everyCircle(moves);
    const Moment moment = at(12);
    FaultLook look(student, reference, moment, true, false);
    QVERIFY(look.showsFault());
    QCOMPARE(look.of(reference), Sight::Twice);
    const QString counts =
        QStringLiteral("local made = 0 function on_update(h) made = made + 1 "
                       "for i, c in ipairs(circles) do c.position = c.position + c.velocity * h "
                       "if made < 7 and step > 7 then c.velocity = 0.8 * c.velocity end end end");
    QCOMPARE(look.of(counts), Sight::Wrong);
}

void TestFaultLook::stoppedProgramIsWrong()
{
    QCOMPARE(sightOf(QStringLiteral("function on_update(h) error('no') end"), at(1), true),
             Sight::Wrong);
    QCOMPARE(sightOf(QStringLiteral("function"), at(1), true), Sight::Wrong);
}

void TestFaultLook::programWithoutEndIsGivenUp()
{
    const QString program = QStringLiteral("function on_update() while true do end end");
    const auto workOf = [&](bool once) {
        Probe probe(&program, {two()}, once);
        return probe.step() ? qint64(0) : probe.instructions();
    };
    QVERIFY(workOf(true) > 50'000 && workOf(true) < 200'000);
    QVERIFY(workOf(false) > 4'000'000);
}

QTEST_APPLESS_MAIN(TestFaultLook)
#include "test_fault_look.moc"
