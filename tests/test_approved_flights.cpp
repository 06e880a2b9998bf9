// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/draws.h"
#include "tests/lab_test.h"
#include "tests/told_deviations.h"

#include "tasks/judging/flight_words.h"
#include "tasks/judging/measured_laws.h"

using namespace cradle;
using namespace cradle::approved;

/// What is said of programs that move their circles by other laws, with numbers in them that are
/// wrong by a little or much. Hashes of what is said of some forty each, and how often each
/// headline is, are in tests/approved/flights.txt.
class TestApprovedFlights : public QObject
{
    Q_OBJECT
private slots:
    void whatIsSaidOfFlightsIsAsApproved();
};

namespace {

/// What a step adds to the place, and to the velocity; A is drawn, and F is 1 + A.
constexpr const char *ways[] = {
    "v * h",
    "v * h * F",
    "v * h + vec(A, 0)",
    "v * h + vec(0, A)",
    "vec(v.x * F, v.y) * h",
    "vec(v.x, v.y * F) * h",
    "vec(v.x, v.y + A * v.x) * h",
    "vec(v.x + A * v.y, v.y) * h",
    "vec(v.y, v.x) * h * F",
    "vec(v.x, 0) * h",
    "vec(0, v.y) * h * F",
    "v * F",
    "v * h * h",
    "v / h * F",
    "v * F / 60",
    "v * h ^ F",
    "v * h + gravity * h * h * A",
    "v * h + gravity * h * h * F / 2",
    "v * h + gravity * h * A",
    "v * h + gravity * h * h / 2",
    "v * h + A * x",
    "v * h - x * F",
    "v * (h + A)",
    "-v * h * F",
    "vec(math.abs(v.x), math.abs(v.y)) * h",
    "v * h * v:length() * F",
    "v:normalized() * h * F",
    "w * h * F",
    "vec(0, 0)",
};
constexpr const char *turns[] = {
    "gravity * h",
    "gravity * h * F",
    "gravity * h + vec(A, 0)",
    "gravity * h + vec(0, A)",
    "gravity * h + vec(A, 0) * h",
    "vec(gravity.x, gravity.y + A) * h",
    "vec(gravity.y, gravity.x) * h * F",
    "gravity * h + A * v",
    "gravity * h + A * v * h",
    "gravity * h + vec(A * v.x, 0)",
    "gravity * h + vec(0, A * v.y) * h",
    "gravity * h + vec(A * v.y, 0) * h",
    "gravity * h + A * x",
    "gravity * h + A * x * h",
    "gravity * F",
    "gravity * h * h",
    "gravity / h",
    "gravity * F / 60",
    "gravity * (h + A)",
    "vec(0, -9.81) * h",
    "vec(0, -9.81 * F) * h",
    "-gravity * h * F",
    "gravity * h * c.radius * 5 * F",
    "gravity * h * c.density * F",
    "gravity * h - v",
    "gravity * h + A * v * v:length() * h",
    "vec(0, 0)",
    "gravity * h + A * w",
    "gravity * h * (1 + A * kept.steps)",
};
/// Of which circles and when, else the circle falls as it should.
constexpr const char *whens[] = {
    "true",           "i == 1",         "i == 2",           "kept.steps > 1", "kept.steps == 1",
    "kept.steps > 5", "v:length() > 1", "v:length() < 0.5", "v.x > 0",        "x.x > 0",
    "h > 0.01",       "h < 0.01",       "gravity.y ~= 0",   "gravity.y == 0", "restitution < 1",
    "c.radius > 0.2"};
/// What is done first, and what is kept from one step to the next.
constexpr const char *orders[] = {
    "c.position = x + WAY c.velocity = v + TURN",
    "v = v + TURN c.velocity = v c.position = x + WAY",
    "c.position, c.velocity = x + WAY, v + TURN",
    "kept[i] = kept[i] or {x, v} x, v = kept[i][1], kept[i][2] "
    "kept[i] = {x + WAY, v + TURN} c.position, c.velocity = kept[i][1], kept[i][2]",
    "kept[i] = kept[i] or {x, v} x, v = kept[i][1], kept[i][2] "
    "c.position, c.velocity = x + WAY, v + TURN",
    "kept[i] = kept[i] or v v = kept[i] c.position = x + WAY c.velocity = v + TURN",
    "kept[i] = kept[i] or x x = kept[i] c.position = x + WAY c.velocity = v + TURN",
    "x = circles[1].position c.position = x + WAY c.velocity = v + TURN",
    "x = vec(x.y, x.x) c.position = x + WAY c.velocity = v + TURN",
    "h = h / 2 for k = 1, 2 do x, v = c.position, c.velocity "
    "c.position = x + WAY c.velocity = v + TURN end",
    "local half = v + TURN / 2 c.velocity = v + TURN v = half c.position = x + WAY",
    "c.position = x + WAY c.velocity = v + TURN if v.y < A then c.velocity = v end"};

QString program(Draws &draws)
{
    const auto oneOf = [&](const auto &all) {
        // Half of them right, so that a fault is often alone.
        return QString::fromLatin1(all[draws.oneOf(3) ? 0 : draws.below(std::size(all))]);
    };
    QString move = oneOf(orders);
    move.replace(QLatin1String("WAY"), oneOf(ways)).replace(QLatin1String("TURN"), oneOf(turns));
    const double by = draws.amount();
    move.replace(QLatin1Char('A'), QStringLiteral("(%1)").arg(by))
        .replace(QLatin1Char('F'), QStringLiteral("(1 + (%1))").arg(by));
    return QStringLiteral("local kept = {steps = 0}\n"
                          "function on_update(h)\n"
                          "  kept.steps = kept.steps + 1\n"
                          "  for i, c in ipairs(circles) do\n"
                          "    local x, v, w = c.position, c.velocity, circles[1].velocity\n"
                          "    if %1 then\n"
                          "      %2\n"
                          "    else\n"
                          "      c.position, c.velocity = x + v * h, v + gravity * h\n"
                          "    end\n"
                          "  end\n"
                          "end\n")
        .arg(oneOf(whens), move);
}

} // namespace

void TestApprovedFlights::whatIsSaidOfFlightsIsAsApproved()
{
    const Lab lab = *readLab(QLatin1String(shippedLab));
    ToldDeviations told(QStringLiteral("flights.txt"));
    unsigned seed = 0;
    for (const char *step : {"L42T12", "L42T4", "L42T2"}) {
        const Task &task = lab.tasks[std::size_t(lab.indexOf(QLatin1String(step)))];
        const Ground ground(task, task.preset);
        const MeasuredLaws right(&task.solution, ground);
        for (int part = 1; part <= 30; ++part) {
            Draws draws(++seed);
            for (int i = 0; i < 40; ++i) {
                const QString source = program(draws);
                const MeasuredLaws own(&source, ground);
                told.add(flightDeviations(own.flight(), right.flight(), ground));
                told.add(own.flight().isLike(right.flight()));
            }
            const QString odd = told.endPart(task.id + QStringLiteral(" %1").arg(part));
            QVERIFY2(odd.isEmpty(), qPrintable(odd));
        }
    }
    const QString difference = told.end();
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

QTEST_GUILESS_MAIN(TestApprovedFlights)
#include "test_approved_flights.moc"
