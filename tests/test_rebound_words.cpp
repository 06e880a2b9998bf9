// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/rebound_reading.h"
#include "tasks/judging/response_law_words.h"
#include "tasks/judging/response_reading.h"

#include "tests/made_hits.h"

#include <QTest>

#include <functional>

using namespace cradle;
using namespace cradle::made;

/// What is said of e, of hits of two equal circles that were worked out with a law of e for each.
class TestReboundWords : public QObject
{
    Q_OBJECT
private slots:
    void lawOfEIsTold_data();
    void lawOfEIsTold();
    void whatIsAlikeIsNotTold();
    void partsAcrossAreTold_data();
    void partsAcrossAreTold();
    void wholeVelocitiesAreTold();
    void unansweredEIsTold();
    void lawThatMassesDenyIsNotTold();
    void clearLineIsTold();
};

namespace {

QString utf8(const char *text)
{
    return QString::fromUtf8(text);
}

/// e as it acts on each circle: Δv = (1 + e') u / 2; and what is left of the parts across.
struct OfE {
    std::function<double(double)> first;
    std::function<double(double)> second;
    std::function<double(double)> across1 = [](double) { return 1.0; };
    std::function<double(double)> across2 = [](double) { return 1.0; };
};

double same(double e)
{
    return e;
}
double one(double)
{
    return 1.0;
}
std::function<double(double)> number(double value)
{
    return [value](double) { return value; };
}

PairHit answered(const OfE &law, double e)
{
    return hitThatLeaves({1.2 - (1.0 + law.first(e)) * 0.75, 0.4 * law.across1(e),
                          -0.3 + (1.0 + law.second(e)) * 0.75, 0.1 * law.across2(e)},
                         e);
}

/// With e = 1, and with 0.8 and 0.5.
MeasuredPair pairOf(const OfE &law)
{
    MeasuredPair pair = noHits();
    pair.equals = {answered(law, 1.0)};
    pair.rebounds = {answered(law, 0.8), answered(law, 0.5)};
    return pair;
}

ReboundReading readingOf(const OfE &law)
{
    return reboundDeviations(pairOf(law), pairOf({same, same}));
}

} // namespace

void TestReboundWords::lawOfEIsTold_data()
{
    QTest::addColumn<OfE>("law");
    QTest::addColumn<QString>("headline");
    QTest::addColumn<QString>("body");
    QTest::addColumn<bool>("explains"); // what is wrong where e is 1
    int rows = 0;
    const auto row = [&rows](const char *headline, const OfE &law, const char *body = "",
                             bool explains = false) {
        QTest::addRow("%d. %s", ++rows, headline)
            << law << utf8(headline) << utf8(body) << explains;
    };
    const auto both = [](auto law) { return OfE{law, law}; };
    row("", {same, same});
    row("Along the normal only circle 1 feels e", {same, one}, "With e = 0.5: ");
    row("Along the normal only circle 2 feels e", {one, same}, "With e = 0.5: ");
    row("e changes nothing in the hits tried", {one, one}, "With e = 0.5: ");
    row("e is squared in the hit of two circles", both([](double e) { return e * e; }));
    row("e is squared in the hit of two circles, for circle 1 alone",
        {[](double e) { return e * e; }, same});
    row("e is squared in the hit of two circles, for circle 2 alone",
        {same, [](double e) { return e * e; }});
    row("The root of e is used in the hit of two circles",
        both([](double e) { return std::sqrt(e); }));
    row("e works the wrong way round: the factor is 2 − e, not 1 + e",
        both([](double e) { return 1.0 - e; }), "", true);
    row("The push is multiplied by 2 e instead of 1 + e",
        both([](double e) { return 2.0 * e - 1.0; }));
    row("The push is multiplied by e instead of 1 + e", both([](double e) { return e - 1.0; }), "",
        true);
    row("The rebound is divided by e", both([](double e) { return 1.0 / e; }));
    row("The sign of e is wrong in the hit of two circles", both([](double e) { return -e; }), "",
        true);
    row("The push is multiplied by 0.5 + 2 e instead of 1 + e",
        both([](double e) { return 2.0 * e - 0.5; }), "", true);
    row("The push is multiplied by 2.5 − 0.5 e instead of 1 + e",
        both([](double e) { return 1.5 - 0.5 * e; }));
    row("A number stands for e in the hit of two circles", both(number(0.7)),
        "With every e tried the rebound is that of e = 0.7.", true);
    row("Numbers stand for e in the hit of two circles", {number(0.7), number(0.4)},
        "circle 1 answers as with e = 0.7 and circle 2 as with e = 0.4.", true);
    const char *const odd = "e does not act on the rebound as it should";
    row(odd, {number(1.03), number(0.4)}, "", true);
    row(odd, {number(0.4), number(1.03)}, "", true);
    row(odd, {number(-0.03), number(0.4)}, "", true);
    row("Numbers stand for e in the hit of two circles", {number(1.01), number(0.4)}, "", true);
    row("After a hit the circles part faster than they met", both(number(1.03)), "", true);
    row("After a hit the circles still run into each other", both(number(-0.03)), "", true);
    row("After a hit the circles still run into each other", both(number(-0.998)),
        "The hit changed the velocity of circle 1 by no more than 0.0015 m/s and that of circle 2 "
        "by "
        "0.0015 m/s",
        true);
    // With e = 1 nobody changes, and with no other e they part.
    row("After a hit the circles still run into each other",
        both([](double e) { return e == 1.0 ? -1.0 : e - 1.0; }), "With e = 0.8: ", true);
    row("e acts on more than the rebound", {[](double e) { return e == 1.0 ? 1.0 : e + 0.3; },
                                            [](double e) { return e == 1.0 ? 1.0 : e - 0.3; }});
    row(odd, both([](double e) { return e == 0.5 ? 0.9 : e; }), "With e = 0.8 it comes out right.");
}

void TestReboundWords::lawOfEIsTold()
{
    QFETCH(OfE, law);
    QFETCH(QString, headline);
    QFETCH(QString, body);
    const ReboundReading reading = readingOf(law);
    QCOMPARE(headlinesOf(reading.deviations),
             headline.isEmpty() ? QStringList() : QStringList(headline));
    QTEST(reading.explainsElastic, "explains");
    for (const LawDeviation &each : reading.deviations) {
        QVERIFY2(each.message.contains(body), qPrintable(each.message));
        QCOMPARE(each.topic, Topic::Restitution);
        QCOMPARE(each.suspect, Suspect::Formula);
    }
}

/// Two e are told apart from 0.02 on.
void TestReboundWords::whatIsAlikeIsNotTold()
{
    const auto off = [](double by) { return [by](double e) { return e == 1.0 ? 1.0 : e + by; }; };
    for (const double by : {-0.019, 0.019}) {
        QVERIFY(readingOf({off(by), off(by)}).deviations.empty());
        QVERIFY(readingOf({off(by), same}).deviations.empty());
    }
    for (const double by : {-0.021, 0.021}) {
        QVERIFY(!readingOf({off(by), off(by)}).deviations.empty());
        QVERIFY(!readingOf({off(by), same}).deviations.empty());
        QVERIFY(!readingOf({same, off(by)}).deviations.empty());
    }
    // One number for both up to there, and none that is 0: this is a law of its own.
    QCOMPARE(headlinesOf(readingOf({number(0.7), number(0.682)}).deviations),
             QStringList(utf8("A number stands for e in the hit of two circles")));
    QCOMPARE(headlinesOf(readingOf({number(0.7), number(0.678)}).deviations),
             QStringList(utf8("Numbers stand for e in the hit of two circles")));
    QVERIFY(readingOf({number(0.018), number(0.018)}).deviations.empty());
    QVERIFY(!readingOf({number(0.022), number(0.022)}).deviations.empty());
    // The own scene is answered with another e: so no number stands for it.
    MeasuredPair own = pairOf({number(0.7), number(0.7)});
    for (const auto &[e, isNumber] : {std::pair(0.755, true), std::pair(0.765, false)}) {
        own.own = answered({same, same}, e);
        QCOMPARE(headlinesOf(reboundDeviations(own, pairOf({same, same})).deviations)
                     .contains(utf8("A number stands for e in the hit of two circles")),
                 isNumber);
    }
}

void TestReboundWords::partsAcrossAreTold_data()
{
    QTest::addColumn<OfE>("law");
    QTest::addColumn<QStringList>("said");
    QTest::newRow("both") << OfE{same, same, same, same}
                          << QStringList(
                                 utf8("e also shortens the parts across the line of centres"));
    QTest::newRow("circle 1") << OfE{same, same, same, one}
                              << QStringList(utf8("e also shortens the part of circle 1 across "
                                                  "the line of centres"));
    QTest::newRow("circle 2") << OfE{same, same, one, same}
                              << QStringList(utf8("e also shortens the part of circle 2 across "
                                                  "the line of centres"));
    QTest::newRow("one, and the other is lost")
        << OfE{same, same, same, [](double e) { return e == 1.0 ? 1.0 : 0.0; }} << QStringList();
    QTest::newRow("and along the line, too")
        << OfE{one, one, same, same}
        << QStringList{utf8("e also shortens the parts across the line of centres"),
                       utf8("e changes nothing in the hits tried")};
    QTest::newRow("with every e") << OfE{[](double) { return 1.5; }, [](double) { return 1.5; },
                                         same, same}
                                  << QStringList();
}

void TestReboundWords::partsAcrossAreTold()
{
    QFETCH(OfE, law);
    QTEST(headlinesOf(readingOf(law).deviations), "said");
}

/// Along the line of centres equal circles leave an elastic hit with −0.3 and 1.2 m/s.
void TestReboundWords::wholeVelocitiesAreTold()
{
    const MeasuredPair right = pairOf({same, same});
    MeasuredPair own = right;
    MeasuredPair first = right;
    MeasuredPair second = right;
    for (std::size_t i = 0; i < 2; ++i) {
        const double e = own.rebounds[i].meeting.restitution;
        own.rebounds[i] = hitThatLeaves({-0.3 * e, 0.4 * e, 1.2 * e, 0.1 * e}, e);
        first.rebounds[i].left1 = own.rebounds[i].left1;
        second.rebounds[i].left2 = own.rebounds[i].left2;
    }
    const auto said = [&](const MeasuredPair &pair) {
        return headlinesOf(reboundDeviations(pair, right).deviations);
    };
    QCOMPARE(said(own), QStringList(utf8("e multiplies the whole velocities after the hit")));
    QCOMPARE(said(first), QStringList(utf8("e multiplies the whole velocity of circle 1 after the "
                                           "hit")));
    QCOMPARE(said(second), QStringList(utf8("e multiplies the whole velocity of circle 2 after "
                                            "the hit")));
    MeasuredPair twice = right;
    for (PairHit &hit : twice.rebounds)
        hit.left1 = hit.meeting.restitution * hit.left1;
    QCOMPARE(said(twice).front(), utf8("e multiplies the whole velocity of circle 1 after the "
                                       "hit"));
}

void TestReboundWords::unansweredEIsTold()
{
    const MeasuredPair right = pairOf({same, same});
    MeasuredPair own = right;
    own.rebounds[1].answered = false;
    own.rebounds[1].left1 = own.rebounds[1].came1;
    own.rebounds[1].left2 = own.rebounds[1].came2;
    const auto found = reboundDeviations(own, right).deviations;
    QCOMPARE(headlinesOf(found), QStringList(utf8("With e = 0.5 a hit changes no velocity")));
    QVERIFY(found.front().message.contains(utf8("They came nearer with 1.5 m/s")));
    QVERIFY(found.front().message.contains(utf8("with e = 0.8 it comes out right")));
    QCOMPARE(found.front().suspect, Suspect::Question);
    own.rebounds[0] = answered({number(0.821), number(0.8)}, 0.8);
    QVERIFY(!unansweredRebound(own, right));
    own.rebounds[0] = answered({number(0.8), number(0.779)}, 0.8);
    QVERIFY(!unansweredRebound(own, right));
    own.rebounds[0] = answered({number(0.819), number(0.781)}, 0.8);
    QVERIFY(unansweredRebound(own, right));
}

/// Of equal circles one has the root of e; of unequal ones it has not.
void TestReboundWords::lawThatMassesDenyIsNotTold()
{
    MeasuredPair right = pairOf({same, same});
    MeasuredPair own = pairOf({[](double e) { return std::sqrt(e); }, same});
    right.densities = own.densities = {hitOfUnlike({0.2, 0.2}, {2.0, 6.0}, 3.0, 1.0, 0.25)};
    QCOMPARE(headlinesOf(reboundDeviations(own, right).deviations),
             QStringList(utf8("Of two equal circles only circle 2 leaves as it should")));
    // Of 1.5 m/s circle 1 gets 6/8 (1 + e): with e = 0.5, the root, 1.6875 m/s.
    own.densities.front().left1 = (1.2 - 1.6875) * normal + 0.4 * tangent;
    QCOMPARE(headlinesOf(reboundDeviations(own, right).deviations),
             QStringList(utf8("The root of e is used in the hit of two circles, for circle 1 "
                              "alone")));
}

/// 1 + e times a number is no other line, nor is a push that does not depend on e.
void TestReboundWords::clearLineIsTold()
{
    const auto line = [](double without, double perE) {
        const auto law = [=](double e) { return without + perE * e - 1.0; };
        const MeasuredPair own = pairOf({law, law});
        std::vector<Rebound> all;
        for (const PairHit &hit : own.rebounds)
            all.push_back(reboundOf(hit));
        return lineOfPush(own, all, {reboundOf(own.equals.front())});
    };
    const auto push = line(0.5, 1.25);
    QVERIFY(push);
    QVERIFY(std::abs(push->without - 0.5) < 1e-9 && std::abs(push->perE - 1.25) < 1e-9);
    QVERIFY(line(0.5, 0.545) && line(0.5, 0.455));
    QVERIFY(!line(0.5, 0.535) && !line(0.5, 0.465));
    QVERIFY(line(0.5, 0.045) && line(0.5, -0.045));
    QVERIFY(!line(0.5, 0.035) && !line(0.5, -0.035));
    QVERIFY(line(0.045, 1.0) && !line(0.035, 1.0));
}

QTEST_GUILESS_MAIN(TestReboundWords)
#include "test_rebound_words.moc"
