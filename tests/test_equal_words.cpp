// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_law_words.h"

#include "tests/made_hits.h"

#include <QTest>

#include <functional>

using namespace cradle;
using namespace cradle::made;

/// What circles that come so leave with.
using EqualAnswer = std::function<PairVelocities(const PairVelocities &)>;

/// What is said of hits of equal circles that were made up: along the line of centres they should
/// exchange their parts, or stop.
class TestEqualWords : public QObject
{
    Q_OBJECT
private slots:
    void wrongAnswerIsTold_data();
    void wrongAnswerIsTold();
    void whatIsBlurredIsRight();
    void circlesOfOtherSizesAndEFollowALaw();
    void otherLineThatComesOutRightIsTold();
    void whoDoesNotStopIsTold_data();
    void whoDoesNotStopIsTold();
};

namespace {

QString utf8(const char *text)
{
    return QString::fromUtf8(text);
}

constexpr PairVelocities second{0.2, -0.3, -1.1, 0.5};

PairVelocities exchange(const PairVelocities &in)
{
    return {in.along2, in.across1, in.along1, in.across2};
}

/// The exchange, with these times the parts that it makes.
EqualAnswer times(double along1, double across1, double along2, double across2)
{
    return [=](const PairVelocities &in) {
        return PairVelocities{along1 * in.along2, across1 * in.across1, along2 * in.along1,
                              across2 * in.across2};
    };
}

PairVelocities whole(const PairVelocities &in)
{
    return {in.along2, in.across2, in.along1, in.across1};
}

MeasuredPair pairThat(const EqualAnswer &answer)
{
    MeasuredPair pair = noHits();
    pair.equals = {hitAlong(33.0, arrival, answer(arrival)),
                   hitAlong(33.0, second, answer(second))};
    return pair;
}

QString headlineOf(const EqualReading &reading)
{
    return reading.said ? headlinesOf({*reading.said}).front() : QString();
}

QString headlineOf(const MeasuredPair &own, const MeasuredPair &right)
{
    return headlineOf(equalReading(own, right, false));
}

} // namespace

void TestEqualWords::wrongAnswerIsTold_data()
{
    QTest::addColumn<EqualAnswer>("answer");
    QTest::addColumn<QString>("headline");
    QTest::addColumn<Topic>("topic");
    QTest::addColumn<std::vector<int>>("circles");
    const auto row = [](const char *headline, const EqualAnswer &answer, std::vector<int> circles,
                        Topic topic = Topic::Other) {
        QTest::newRow(headline) << answer << utf8(headline) << topic << std::move(circles);
    };
    row("Circle 1 does not keep its part across in a hit", times(1, 0.5, 1, 1), {0});
    row("Circle 2 does not keep its part across in a hit", times(1, 1, 1, 0.5), {1});
    row("The parts across the line of centres are changed", times(1, 0.5, 1, 0.5), {0, 1},
        Topic::Across);
    row("Only circle 1 leaves a hit as it should", times(1, 1, 0.5, 1), {1});
    row("Only circle 2 leaves a hit as it should", times(0.7, 0.8, 1, 1), {0});
    row("The two pushes are not equal and opposite", times(0.3, 1, 0.6, 1), {0, 1},
        Topic::Momentum);
    row(
        "The push is not along the line of centres",
        [](const PairVelocities &in) {
            const double push = in.along1 - in.along2;
            return PairVelocities{in.along1 - 0.8 * push, in.across1 - 0.5 * push,
                                  in.along2 + 0.8 * push, in.across2 + 0.5 * push};
        },
        {0, 1}, Topic::Direction);
    row("Equal circles get 0.7 times the right push",
        [](const PairVelocities &in) {
            const double push = 0.7 * (in.along1 - in.along2);
            return PairVelocities{in.along1 - push, in.across1, in.along2 + push, in.across2};
        },
        {0, 1});
}

void TestEqualWords::wrongAnswerIsTold()
{
    QFETCH(EqualAnswer, answer);
    MeasuredPair own = pairThat(answer);
    MeasuredPair right = pairThat(exchange);
    const EqualReading reading = equalReading(own, right, false);
    QVERIFY(!reading.isRight);
    QTEST(headlineOf(reading), "headline");
    QTEST(reading.said->topic, "topic");
    QTEST(reading.said->moment.circles, "circles");
    // What e does explains it.
    QVERIFY(!equalReading(own, right, true).said);
    QVERIFY(!equalReading(own, right, true).isRight);
    // Of others than equal ones it is told of which circles it is.
    own.densities = {hitOfUnlike({0.2, 0.2}, {2.0, 7.0}, 3.0, 1.0)};
    right.densities = own.densities;
    const QString told = headlineOf(own, right);
    if (told.contains(utf8("only circle")))
        QVERIFY(told.startsWith(utf8("Of two equal circles only circle")));
}

/// By 5e-3 (1 + v) of a velocity v, m/s: here of −0.3 m/s.
void TestEqualWords::whatIsBlurredIsRight()
{
    const MeasuredPair right = pairThat(exchange);
    for (const auto &[off, isRight] : {std::pair(6.4e-3, true), std::pair(6.6e-3, false)}) {
        for (const double sign : {-1.0, 1.0}) {
            MeasuredPair own = right;
            own.equals[0].left1 += sign * off * own.equals[0].normal;
            QCOMPARE(equalReading(own, right, false).isRight, isRight);
        }
    }
    MeasuredPair own = right;
    own.equals[0].left1 += own.equals[0].normal;
    for (bool PairHit::*unmet : {&PairHit::late, &PairHit::parting}) {
        MeasuredPair other = own;
        other.equals[0].*unmet = true;
        QVERIFY(equalReading(other, right, false).isRight);
    }
    // Masses that stand for numbers are told elsewhere.
    MeasuredPair numbers = right;
    for (PairHit &hit : numbers.equals) {
        const double push = (hit.meeting.velocities.along1 - hit.meeting.velocities.along2);
        hit.left1 = hit.came1 - 4.0 / 3.0 * push * hit.normal;
        hit.left2 = hit.came2 + 2.0 / 3.0 * push * hit.normal;
    }
    const EqualReading reading = equalReading(numbers, right, false);
    QVERIFY(!reading.isRight && !reading.said);
}

void TestEqualWords::circlesOfOtherSizesAndEFollowALaw()
{
    const QString every = utf8("The circles exchange their whole velocities");
    const QString equal = utf8("Two equal circles exchange their whole velocities");
    MeasuredPair own = pairThat(whole);
    MeasuredPair right = pairThat(exchange);
    QCOMPARE(headlineOf(own, right), every);
    const PairHit exchanged = hitAlong(33.0, arrival, whole(arrival), 0.5);
    const PairHit other = hitAlong(33.0, arrival, exchange(arrival), 0.5);
    for (auto hits : {&MeasuredPair::radii, &MeasuredPair::densities, &MeasuredPair::rebounds}) {
        MeasuredPair more = own;
        MeasuredPair good = right;
        good.*hits = {other, other};
        more.*hits = {exchanged, exchanged};
        // Two of one size more are asked of every law.
        const QString neither = hits == &MeasuredPair::radii
                                    ? utf8("The parts across the line of centres are changed")
                                : hits == &MeasuredPair::rebounds ? equal + utf8(" (with e = 1)")
                                                                  : equal;
        QCOMPARE(headlineOf(more, good), every);
        (more.*hits)[1] = other;
        QCOMPARE(headlineOf(more, good), neither);
        const EqualReading reading = equalReading(more, good, false);
        QCOMPARE(reading.said->isOfSome, hits == &MeasuredPair::rebounds);
    }
    right.larger = other;
    own.larger = exchanged;
    QCOMPARE(headlineOf(own, right), every);
    own.larger = other;
    QCOMPARE(headlineOf(own, right), utf8("The parts across the line of centres are changed"));
    own.larger->answered = false;
    QCOMPARE(headlineOf(own, right), every);
}

void TestEqualWords::otherLineThatComesOutRightIsTold()
{
    const EqualAnswer half = times(1, 0.5, 1, 0.5);
    MeasuredPair own = pairThat(half);
    MeasuredPair right = pairThat(exchange);
    const QString line =
        utf8("Here the line of centres was at 33°; with 118° the hits come out right.");
    const auto said = [&] { return equalReading(own, right, false).said->message; };
    QVERIFY(!said().contains(utf8("Here the line")));
    right.equals.push_back(hitAlong(118.0, second, exchange(second)));
    own.equals.push_back(right.equals.back());
    QVERIFY2(said().contains(line), qPrintable(said()));
    // Not where some there come out wrong, too, or some here right.
    right.equals.push_back(hitAlong(118.0, arrival, exchange(arrival)));
    own.equals.push_back(hitAlong(118.0, arrival, half(arrival)));
    QVERIFY(!said().contains(utf8("Here the line")));
    own.equals.back() = right.equals.back();
    QVERIFY(said().contains(line));
    own.equals[1] = right.equals[1];
    QVERIFY(!said().contains(utf8("Here the line")));
}

void TestEqualWords::whoDoesNotStopIsTold_data()
{
    QTest::addColumn<Vec2>("left1"); // of the first hit; the second is right but for the last row
    QTest::addColumn<Vec2>("left2");
    QTest::addColumn<bool>("both"); // hits are like that
    QTest::addColumn<QString>("headline");
    const QString some = utf8("Not every hit stops both circles");
    const QString first = utf8("A hit stops circle 1 and not circle 2");
    const QString other = utf8("A hit stops circle 2 and not circle 1");
    const Vec2 came1{1.0, 2.0};
    const Vec2 came2{-1.0, 0.5};
    QTest::newRow("x alone") << Vec2{0, 2} << Vec2{0, 0.5} << true
                             << utf8("A hit stops the x parts alone");
    QTest::newRow("x alone, blurred")
        << Vec2{4e-3, 2} << Vec2{0, 0.504} << true << utf8("A hit stops the x parts alone");
    QTest::newRow("y alone") << Vec2{1, 0} << Vec2{-1, 0} << true
                             << utf8("A hit stops the y parts alone");
    QTest::newRow("y alone, blurred")
        << Vec2{1, 4e-3} << Vec2{-0.996, 0} << true << utf8("A hit stops the y parts alone");
    QTest::newRow("neither") << 0.9 * came1 << 0.9 * came2 << true
                             << utf8("The circles do not stop in a hit");
    QTest::newRow("x alone, but for 6 mm/s")
        << Vec2{0, 2} << Vec2{0, 0.506} << true << utf8("The circles do not stop in a hit");
    QTest::newRow("circle 1") << Vec2{4e-3, 0} << came2 << true << first;
    QTest::newRow("circle 1, and the other hardly goes on")
        << Vec2{} << 0.06 * came2 << true << first;
    QTest::newRow("a rest of circle 2") << Vec2{} << 0.04 * came2 << true << some;
    QTest::newRow("circle 2") << came1 << Vec2{} << true << other;
    QTest::newRow("circle 2, and the other hardly goes on")
        << 0.06 * came1 << Vec2{} << true << other;
    QTest::newRow("a rest of circle 1") << 0.04 * came1 << Vec2{} << true << some;
    QTest::newRow("none in one of two") << came1 << came2 << false << some;
    QTest::newRow("circle 1 in one of two") << Vec2{} << came2 << false << some;
}

void TestEqualWords::whoDoesNotStopIsTold()
{
    QFETCH(Vec2, left1);
    QFETCH(Vec2, left2);
    QFETCH(bool, both);
    MeasuredPair right = pairThat([](const PairVelocities &) { return PairVelocities{}; });
    for (PairHit &hit : right.equals) {
        hit.came1 = {1.0, 2.0};
        hit.came2 = {-1.0, 0.5};
    }
    MeasuredPair own = right;
    for (std::size_t i = 0; i < (both ? 2U : 1U); ++i) {
        own.equals[i].left1 = left1;
        own.equals[i].left2 = left2;
    }
    const EqualReading reading = equalReading(own, right, false);
    QTEST(headlineOf(reading), "headline");
    QCOMPARE(reading.said->isOfSome, headlineOf(reading).contains(utf8("stops circle"))
                                         || headlineOf(reading).startsWith(utf8("Not every")));
}

QTEST_GUILESS_MAIN(TestEqualWords)
#include "test_equal_words.moc"
