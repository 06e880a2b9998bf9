// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/evidence.h"
#include "tasks/judging/measured_wall.h"

#include "tests/programs.h"
#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::programs;

/// Which steps of a run speak for a known mistake, and which against it.
class TestEvidence : public QObject
{
    Q_OBJECT
private slots:
    void stepsAreParted();
    void aShortRunIsKeptWhole();
    void aLongRunIsThinnedEvenly();
    void whatExplainsTheOddStepsFits();
    void aMistakeMayDoMoreThanTheStudent_data();
    void aMistakeMayDoMoreThanTheStudent();
    void boundsOfAnExplanation_data();
    void boundsOfAnExplanation();
    void aWallHitFitsFromReachedToBefore();
};

namespace {

constexpr Vec2 down{0.0, -scenes::g};
constexpr double kick = 8.0; ///< m/s, upwards, below the middle

/// Falls by symplectic Euler, is kicked up below the middle; \p factor is that of gravity.
QString program(const QString &factor)
{
    return QStringLiteral(R"lua(function on_update(h)
  local c = circle1
  c.velocity = c.velocity + %1 * gravity * h
  if c.position.y < 0 and c.velocity.y < 0 then c.velocity = c.velocity + vec(0, 8) end
  c.position = c.position + c.velocity * h
end)lua")
        .arg(factor);
}

/// The same, but for \p odd steps in the middle without gravity.
Observation run(int steps, int odd)
{
    Preset preset = scene({{.position = {0, 1}, .velocity = {0.5, 2}}}, down);
    preset.circles[0].name = QStringLiteral("circle1");
    int step = 0;
    return observed(preset, (steps - 0.5) * preset.timestep, [&](Circles &c, double h) {
        const bool wrong = step >= 10 && step < 10 + odd;
        ++step;
        c[0].velocity += (wrong ? 0.0 : 1.0) * h * down;
        if (c[0].position.y < 0.0 && c[0].velocity.y < 0.0)
            c[0].velocity += Vec2{0, kick};
        c[0].position += h * c[0].velocity;
    });
}

/// Steps in which that run was kicked.
std::size_t kicksOf(const Observation &o)
{
    std::size_t kicks = 0;
    for (qint64 k = 0; k < o.steps(); ++k)
        kicks += o.circle(0, k + 1).velocity.y - o.circle(0, k).velocity.y > 1.0 ? 1 : 0;
    return kicks;
}

} // namespace

void TestEvidence::stepsAreParted()
{
    const Observation o = run(300, 8);
    const Evidence e =
        compareWithReference(program(QStringLiteral("1")), o.variant, o, OneStep::Places::Exact);
    QCOMPARE(e.oddInAll, std::size_t{8});
    QCOMPARE(e.odd.size(), std::size_t{8});
    QCOMPARE(e.odd.front(), qint64{10});
    QCOMPARE(e.evenInAll.size(), std::size_t{292});
    QVERIFY(kicksOf(o) >= 2);
    QCOMPARE(e.events.size(), kicksOf(o));
    // Of the others 24, evenly spread.
    QCOMPARE(e.quiet.size(), std::size_t{24});
    QCOMPARE(e.quiet.front(), qint64{0});
    QVERIFY(e.quiet.back() > 280);
}

void TestEvidence::aShortRunIsKeptWhole()
{
    const Observation o = run(24, 4);
    const Evidence e =
        compareWithReference(program(QStringLiteral("1")), o.variant, o, OneStep::Places::Exact);
    QCOMPARE(e.quiet.size() + e.events.size() + e.odd.size(), std::size_t{24});
}

void TestEvidence::aLongRunIsThinnedEvenly()
{
    const Observation o = run(300, 60);
    const Evidence e =
        compareWithReference(program(QStringLiteral("1")), o.variant, o, OneStep::Places::Exact);
    QCOMPARE(e.oddInAll, std::size_t{60});
    QCOMPARE(e.odd.size(), std::size_t{24});
    for (std::size_t i = 0; i < 24; ++i) // two or three apart
        QCOMPARE(e.odd[i], qint64(10 + std::floor(2.5 * static_cast<double>(i))));
    const Fit without = fitOf(program(QStringLiteral("0")), {e}, OneStep::Places::Exact);
    QCOMPARE(without.odd, std::size_t{24});
    QCOMPARE(without.shared, 60.0); // as if all of them had been looked at
}

void TestEvidence::whatExplainsTheOddStepsFits()
{
    // Without gravity all that is odd is explained, and nothing of the rest is right.
    const Observation o = run(300, 8);
    const std::vector<Evidence> all{
        compareWithReference(program(QStringLiteral("1")), o.variant, o, OneStep::Places::Exact)};
    const Fit without = fitOf(program(QStringLiteral("0")), all, OneStep::Places::Exact);
    QCOMPARE(without.odd, std::size_t{8});
    QCOMPARE(without.oddMissed, std::size_t{0});
    QCOMPARE(without.shared, 8.0);
    QCOMPARE(without.even, 24 + kicksOf(o));
    QCOMPARE(without.evenMissed, without.even);
    QCOMPARE(without.events, kicksOf(o));
    QVERIFY(!without.explains());
    // The reference explains none of it.
    const Fit right = fitOf(program(QStringLiteral("1")), all, OneStep::Places::Exact);
    QVERIFY(right.odd > 0);
    QCOMPARE(right.oddMissed, right.odd);
    QVERIFY(!right.explains());
}

void TestEvidence::aMistakeMayDoMoreThanTheStudent_data()
{
    QTest::addColumn<int>("more"); // steps without gravity
    QTest::addColumn<bool>("explains");
    QTest::newRow("none") << 0 << true;
    QTest::newRow("three times as many") << 24 << true;
    QTest::newRow("one more") << 25 << false;
}

/// Eight steps of the run are without gravity; in the mistake so many more.
void TestEvidence::aMistakeMayDoMoreThanTheStudent()
{
    QFETCH(int, more);
    QFETCH(bool, explains);
    const Observation o = run(300, 8);
    // It flies half a metre in a second to the side: so its place tells the step.
    const QString gravity = QStringLiteral("((2 * c.position.x > 9.5 * h and "
                                           "2 * c.position.x < %1 * h) and 0 or 1)")
                                .arg(17.5 + more);
    const std::vector<Evidence> all{
        compareWithReference(program(QStringLiteral("1")), o.variant, o, OneStep::Places::Exact)};
    const Fit fit = fitOf(program(gravity), all, OneStep::Places::Exact);
    QCOMPARE(fit.odd, std::size_t{8});
    QCOMPARE(fit.oddMissed, std::size_t{0});
    QCOMPARE(fit.eventsMissed, std::size_t{0});
    QCOMPARE(fit.shared, 8.0);
    QCOMPARE(fit.claimed, static_cast<double>(more));
    QCOMPARE(fit.explains(), explains);
}

void TestEvidence::boundsOfAnExplanation_data()
{
    QTest::addColumn<Fit>("fit");
    QTest::addColumn<bool>("explains");
    const Fit best{.odd = 100, .even = 100, .events = 10, .shared = 10.0};
    const auto row = [&](const char *name, bool explains, auto change) {
        Fit fit = best;
        change(fit);
        QTest::newRow(name) << fit << explains;
    };
    row("all", true, [](Fit &) {});
    row("nothing to explain", false, [](Fit &fit) { fit.odd = 0; });
    row("a twentieth left", true, [](Fit &fit) { fit.oddMissed = 5; });
    row("more left", false, [](Fit &fit) { fit.oddMissed = 6; });
    row("a tenth spoilt", true, [](Fit &fit) { fit.evenMissed = 10; });
    row("more spoilt", false, [](Fit &fit) { fit.evenMissed = 11; });
    row("a tenth of the hits", true, [](Fit &fit) { fit.eventsMissed = 1; });
    row("more of the hits", false, [](Fit &fit) { fit.eventsMissed = 2; });
    row("overdone three times", true, [](Fit &fit) { fit.claimed = 30.0; });
    row("overdone more", false, [](Fit &fit) { fit.claimed = 31.0; });
}

void TestEvidence::boundsOfAnExplanation()
{
    QFETCH(Fit, fit);
    QFETCH(bool, explains);
    QCOMPARE(fit.explains(), explains);
}

void TestEvidence::aWallHitFitsFromReachedToBefore()
{
    WallHit hit;
    hit.reached = 0.15;
    hit.before = 0.25;
    hit.travel = 0.1;
    QVERIFY(hit.fits(0.15));
    QVERIFY(hit.fits(0.2));
    QVERIFY(hit.fits(0.35)); // a step late
    QVERIFY(hit.fits(0.15 - 0.8e-9));
    QVERIFY(hit.fits(0.35 + 0.8e-9));
    QVERIFY(!hit.fits(0.15 - 1.2e-9));
    QVERIFY(!hit.fits(0.35 + 1.2e-9));
}

QTEST_GUILESS_MAIN(TestEvidence)
#include "test_evidence.moc"
