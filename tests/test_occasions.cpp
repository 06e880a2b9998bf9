// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/occasions.h"

#include <QTest>

#include <functional>

using namespace cradle;
using Kind = Condition::Kind;

using Rule = std::function<bool(const Occasion &)>;
/// What some of several alike things have in common is told from what they were like.
class TestOccasions : public QObject
{
    Q_OBJECT
private slots:
    void conditionIsFound_data();
    void conditionIsFound();
    void nothingIsFoundWhereAllComeOutAlike();
    void oneAloneHasNoPlace();
    void ofTwoNoneIsTheOne();
};

namespace {

/// Eight in turn: each a second later, but the fourth and the seventh at once; in other places. Two
/// more are the first of runs of their own, of which one has lasted long.
std::vector<Occasion> ten(const Rule &rule)
{
    constexpr Vec2 places[] = {{1, 2},   {-2, -1}, {2, -2}, {1.1, 1},
                               {1.5, 1}, {-2, 2},  {2, 0},  {-1, -2}};
    std::vector<Occasion> all;
    double time = 0.0;
    for (int k = 1; k <= 8; ++k) {
        const double pause = k == 4 || k == 7 ? 0.1 : 1.0;
        time += pause;
        all.push_back({.time = time,
                       .number = k,
                       .ownNumber = (k + 1) / 2,
                       .pause = k == 1 ? std::numeric_limits<double>::infinity() : pause,
                       .place = places[k - 1],
                       .setting = k > 2 && k < 7 ? 1 : 0,
                       .hasMet = k > 5});
    }
    all.push_back({.time = 0.5, .place = {-1.5, 1.5}, .setting = 1});
    all.push_back({.time = 9.0, .place = {1.7, -1.5}, .setting = 0});
    for (Occasion &one : all)
        one.isRight = rule(one);
    return all;
}

} // namespace

void TestOccasions::conditionIsFound_data()
{
    QTest::addColumn<Rule>("rule");
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("bound");
    const auto row = [](const char *name, Kind kind, double bound, const Rule &rule) {
        QTest::newRow(name) << rule << static_cast<int>(kind) << bound;
    };
    using O = const Occasion &;
    row("first", Kind::First, 0.0, [](O one) { return one.number == 1; });
    row("first of each", Kind::First, 0.0, [](O one) { return one.ownNumber == 1; });
    row("not the first", Kind::NotFirst, 0.0, [](O one) { return one.number > 1; });
    row("the first three", Kind::FirstFew, 3.0, [](O one) { return one.number <= 3; });
    row("after three", Kind::AfterFew, 4.0, [](O one) { return one.number > 3; });
    row("the last two, by chance", Kind::Sometimes, 0.0, [](O one) { return one.number > 6; });
    row("odd", Kind::OddOnes, 0.0, [](O one) { return one.number % 2 == 1; });
    row("even", Kind::EvenOnes, 0.0, [](O one) { return one.number % 2 == 0; });
    row("pause", Kind::Pause, 1.0, [](O one) { return one.pause > 0.5; });
    row("not met", Kind::BeforeMet, 0.0, [](O one) { return !one.hasMet; });
    row("until", Kind::Until, 3.1, [](O one) { return one.time < 3.5; });
    row("from", Kind::From, 3.1, [](O one) { return one.time > 3.0; });
    row("above", Kind::Above, 1.0, [](O one) { return one.place.y > 0.5; });
    row("below", Kind::Below, -1.0, [](O one) { return one.place.y < -0.5; });
    row("left", Kind::LeftOf, -1.0, [](O one) { return one.place.x < 0.0; });
    row("right", Kind::RightOf, 1.5, [](O one) { return one.place.x > 1.2; });
    row("the others", Kind::Setting, 0.0, [](O one) { return one.setting == 1; });
    row("none of these", Kind::Sometimes, 0.0,
        [](O one) { return one.number == 2 || one.number == 3 || one.number == 7; });
}

void TestOccasions::conditionIsFound()
{
    QFETCH(Rule, rule);
    QFETCH(int, kind);
    QFETCH(double, bound);
    const auto found = conditionOf(ten(rule));
    QVERIFY(found);
    QCOMPARE(static_cast<int>(found->kind), kind);
    QCOMPARE(found->inside, bound);
}

void TestOccasions::nothingIsFoundWhereAllComeOutAlike()
{
    QVERIFY(!conditionOf({}));
    QVERIFY(!conditionOf(ten([](const Occasion &) { return true; })));
    QVERIFY(!conditionOf(ten([](const Occasion &) { return false; })));
}

/// The highest, or the last, is so by chance.
void TestOccasions::oneAloneHasNoPlace()
{
    const auto last = conditionOf(ten([](const Occasion &one) { return one.number == 8; }));
    QVERIFY(last);
    QVERIFY(last->kind == Kind::Sometimes);
}

/// In one run the first ones are also the early ones.
void TestOccasions::ofTwoNoneIsTheOne()
{
    std::vector<Occasion> all = ten([](const Occasion &one) { return one.number <= 3; });
    all.resize(8);
    const auto several = conditionsOf(all);
    QCOMPARE(several.size(), std::size_t{2});
    QVERIFY(several[0].kind == Kind::FirstFew);
    QVERIFY(several[1].kind == Kind::Until);
    QVERIFY(conditionOf(all)->kind == Kind::Sometimes);
}

QTEST_GUILESS_MAIN(TestOccasions)
#include "test_occasions.moc"
