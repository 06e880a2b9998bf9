// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/one_step.h"

#include "tests/programs.h"

#include <QTest>

using namespace cradle;
using namespace cradle::programs;

/// A known program beside a run, one step at a time, from the run's own states.
class TestOneStep : public QObject
{
    Q_OBJECT
private slots:
    void momentOfTheNormalIsForgiven_data();
    void momentOfTheNormalIsForgiven();
    void anotherLawIsNot_data();
    void anotherLawIsNot();
    void placesTellTheIntegrator();
    void programThatStopsAgreesWithNothing();
};

namespace {

/// Equal circles that exchange their speeds along the line of centres.
const QString exchange = QStringLiteral(R"lua(
function on_update(h)
  for _, c in ipairs(circles) do c.position = c.position + c.velocity * h end
  local d = circle2.position - circle1.position
  local n = d:normalized()
  local u = (circle1.velocity - circle2.velocity):dot(n)
  if d:length() < circle1.radius + circle2.radius and u > 0 then
    circle1.velocity = circle1.velocity - u * n
    circle2.velocity = circle2.velocity + u * n
  end
end
)lua");

/// The same, but that normal and contact are those of \p moment (steps after the old places), and
/// so much of the speeds is exchanged.
Moves exchangeAt(double moment, double share = 1.0)
{
    return [=](Circles &all, double h) {
        const auto at = [&](std::size_t i) {
            return all[i].position + (moment * h) * all[i].velocity;
        };
        const Vec2 d = at(1) - at(0);
        const Vec2 n = normalized(d);
        const double u = share * dot(all[0].velocity - all[1].velocity, n);
        for (Circle &c : all)
            c.position += h * c.velocity;
        if (length(d) < all[0].radius + all[1].radius && u > 0.0) {
            all[0].velocity -= u * n;
            all[1].velocity += u * n;
        }
    };
}

Preset oblique()
{
    return scene({{.position = {-1.0, 0.1}, .velocity = {2.0, 0.0}},
                  {.position = {0.5, -0.1}, .velocity = {-0.3, 0.4}}});
}

/// The step in which the first circle is turned.
qint64 stepOfHit(const Observation &run)
{
    for (qint64 k = 0; k < run.steps(); ++k) {
        if (run.circle(0, k).velocity != run.circle(0, k + 1).velocity)
            return k;
    }
    return -1;
}

} // namespace

void TestOneStep::momentOfTheNormalIsForgiven_data()
{
    QTest::addColumn<double>("moment");
    QTest::newRow("the new places") << 1.0;
    QTest::newRow("the old places") << 0.0;
    QTest::newRow("between") << 0.37;
    QTest::newRow("rather early") << 0.81;
    QTest::newRow("ahead") << 1.43;
}

void TestOneStep::momentOfTheNormalIsForgiven()
{
    QFETCH(double, moment);
    const Observation run = observed(oblique(), 1.0, exchangeAt(moment));
    const qint64 hit = stepOfHit(run);
    QVERIFY(hit > 1);
    OneStep known(exchange, run.variant);
    QVERIFY(known.runs());
    for (qint64 k = 0; k < run.steps(); ++k) {
        // Who asks the old places is a step late, and goes straight on where the other turns.
        if (k != hit - 1 || moment >= 1.0)
            QVERIFY(known.agrees(run, k, OneStep::Places::Free));
    }
}

void TestOneStep::anotherLawIsNot_data()
{
    QTest::addColumn<double>("moment");
    QTest::addColumn<double>("share");
    QTest::newRow("hardly anything is lost") << 1.0 << 0.999;
    QTest::newRow("a tenth is lost, by the old places") << 0.0 << 0.9;
    QTest::newRow("half is lost, between") << 0.37 << 0.5;
    QTest::newRow("a tenth is gained") << 0.81 << 1.1;
}

void TestOneStep::anotherLawIsNot()
{
    QFETCH(double, moment);
    QFETCH(double, share);
    const Observation run = observed(oblique(), 1.0, exchangeAt(moment, share));
    const qint64 hit = stepOfHit(run);
    QVERIFY(hit > 1);
    OneStep known(exchange, run.variant);
    QVERIFY(known.agrees(run, hit - 2, OneStep::Places::Free));
    QVERIFY(!known.agrees(run, hit, OneStep::Places::Free));
}

/// Symplectic Euler beside Euler: the same velocities, places a Δt² apart.
void TestOneStep::placesTellTheIntegrator()
{
    const QString euler = QStringLiteral(
        "function on_update(h) for _, c in ipairs(circles) do "
        "c.position = c.position + c.velocity * h c.velocity = c.velocity + gravity * h end end");
    const Vec2 gravity{0.0, -9.81};
    const Observation run =
        observed(scene({{.velocity = {1.0, 0.5}}}, gravity), 0.5, [&](Circles &all, double h) {
            for (Circle &c : all)
                fall(c, gravity, h);
        });
    OneStep known(euler, run.variant);
    QVERIFY(known.agrees(run, 3, OneStep::Places::Free));
    QVERIFY(!known.agrees(run, 3, OneStep::Places::Exact));
    QVERIFY(known.agrees(run, 3, OneStep::Places::Only));
}

void TestOneStep::programThatStopsAgreesWithNothing()
{
    const Observation run = observed(oblique(), 0.2, exchangeAt(1.0));
    OneStep known(QStringLiteral("function on_update(h) error('no') end"), run.variant);
    for (const auto places : {OneStep::Places::Exact, OneStep::Places::Free, OneStep::Places::Only})
        QVERIFY(!known.agrees(run, 1, places));
}

QTEST_APPLESS_MAIN(TestOneStep)
#include "test_one_step.moc"
