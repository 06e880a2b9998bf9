// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_paths.h"
#include "tasks/judging/pair_words.h"

#include "tests/law_programs.h"
#include "tests/text.h"

using namespace cradle;
using namespace cradle::programs;

/// Where one circle alone does not go as far as its velocity, hits are judged none the less.
class TestUnevenPairs : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void hitsAreJudged_data();
    void hitsAreJudged();
    void momentShowsTheHit();
    void onlyWhoBothGoByTheirOwnAreEven();

private:
    [[nodiscard]] static QString programOf(const char *moves, const QString &hit)
    {
        LawProgram program = withHit(hit);
        program.move = QStringLiteral("c.velocity = c.velocity + gravity * h "
                                      "c.position = c.position + h * ")
                       + text(moves);
        return written(program, structures[3]);
    }
};

namespace {

/// What moves circle c in a step of h, by h: nothing is wrong with circle 1.
constexpr const char *twice = "(c.index == 2 and 2 or 1) * c.velocity";
constexpr const char *ways[] = {twice, "(c.index == 2 and 0.4 or 1) * c.velocity",
                                "(c.index == 2 and h or 1) * c.velocity",
                                "(c.index == 2 and circle1 or c).velocity"};

} // namespace

void TestUnevenPairs::hitsAreJudged_data()
{
    QTest::addColumn<QString>("hit");
    QTest::addColumn<QStringList>("said");
    const QString e = text("restitution");
    for (const HitWay &way : hitWays) {
        const auto row = [&](const char *name, const HitLaw &law, const QStringList &said) {
            QTest::addRow("%s, %s", name, way.name) << hitOf(way, law) << said;
        };
        row("right", {.e = e}, {});
        row("contact", {.reach = text("q.radius"), .e = e},
            {text("Contact is tested at r₂, not at r₁ + r₂")});
        row("early", {.reach = text("p.radius + q.radius + 0.08"), .e = e},
            {text("The circles answer before they touch")});
        row("masses", {.mass = text("c.density * c.radius ^ 2"), .e = e},
            {text("The mass grows with r to the power of 2, not 3")});
        row("never", {.touch = text("false"), .e = e},
            {text("The circles run through each other")});
    }
}

void TestUnevenPairs::hitsAreJudged()
{
    QFETCH(QString, hit);
    QFETCH(QStringList, said);
    const LawBench step(task(text("L42T16")));
    for (const char *moves : ways) {
        const QString program = programOf(moves, hit);
        QCOMPARE(step.flight(program).size(), 1);
        QCOMPARE(step.contact(program) + step.response(program), said);
    }
}

/// The run that is shown begins with the step that is told of.
void TestUnevenPairs::momentShowsTheHit()
{
    const LawBench step(task(text("L42T16")));
    const HitLaw law{.reach = text("q.radius"), .e = text("restitution")};
    for (const char *moves : ways) {
        const QString program = programOf(moves, hitOf(hitWays[0], law));
        const auto found = step.contactFound(program);
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found[0].moment.step, 1);
        Probe probe(&program, found[0].moment.stage);
        const Vec2 before = probe.circle(1).velocity;
        QVERIFY(probe.step());
        QVERIFY(length(probe.circle(1).velocity - before) > 0.01);
    }
}

/// Whichever of the two is moved by the velocity of the other.
void TestUnevenPairs::onlyWhoBothGoByTheirOwnAreEven()
{
    const LawBench step(task(text("L42T16")));
    const QString hit = hitOf(hitWays[0], {.e = text("restitution")});
    for (const auto &[moves, isEven] :
         {std::pair("c.velocity", true), std::pair("2 * c.velocity", true), std::pair(twice, false),
          std::pair("(c.index == 2 and circle1 or c).velocity", false),
          std::pair("(c.index == 1 and circle2 or c).velocity", false)}) {
        const QString program = programOf(moves, hit);
        const MeasuredFlight flight(&program, step.ground);
        QCOMPARE(PairPaths(&program, step.ground, flight).areEven(), isEven);
    }
}

QTEST_GUILESS_MAIN(TestUnevenPairs)
#include "test_uneven_pairs.moc"
