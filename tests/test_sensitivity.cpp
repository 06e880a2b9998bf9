// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/proof/hit_answer.h"
#include "tasks/proof/sensitivity.h"
#include "tasks/reading/lab_reader.h"

#include <QJsonArray>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace cradle;

/// How wrong a run must just be for a check: tolerances from their other side.
class TestSensitivity : public QObject
{
    Q_OBJECT
private slots:
    void endIsJustMissed_data();
    void endIsJustMissed();
    void whatIsNotNoticedIsNotTold();
    void keptQuantitiesAreHeldToABillionth();
    void restitutionAndMassesOfAHitAreShifted();
    void wrongMassesAndRestitutionAreNoticed_data();
    void wrongMassesAndRestitutionAreNoticed();
    void nothingIsMeasuredOfAWrongSolution();
};

namespace {

bool never()
{
    return false;
}

/// A circle drifts from (−2, 0) by 1 m in 1 s, and must end at (−1, 0).
Task drifting(double tolerance)
{
    Task task;
    task.preset.circles.resize(1);
    task.preset.circles[0].body = {.position = {-2, 0}, .velocity = {1, 0}};
    task.solution =
        QStringLiteral("function on_update(dt)\n  circle1.position = circle1.position + "
                       "circle1.velocity * dt\nend\n");
    CheckSpec check;
    check.id = QStringLiteral("end");
    check.kind = QStringLiteral("ends_at");
    check.circles = {0};
    check.parameters = {
        {QStringLiteral("positions"), QJsonArray{QJsonValue(QJsonArray{-1.0, 0.0})}},
        {QStringLiteral("tolerance"), tolerance}};
    check.scene = {{QStringLiteral("kind"), QStringLiteral("own")},
                   {QStringLiteral("duration"), 1.0}};
    task.checks = {check};
    return task;
}

bool isWithinATenth(const std::optional<double> &value, double right)
{
    return value && *value >= 0.999 * right && *value <= 1.101 * right;
}

} // namespace

void TestSensitivity::endIsJustMissed_data()
{
    QTest::addColumn<double>("tolerance"); ///< m
    QTest::newRow("a millimetre") << 1e-3;
    QTest::newRow("ten times looser") << 1e-2;
    QTest::newRow("a thousand times tighter") << 1e-6;
}

/// The way is 1 m long: turned by α it ends 2 sin(α/2) m beside, by a share of s too fast s m
/// beyond, and with a drift of d m/s along both axes √2 d m beside.
void TestSensitivity::endIsJustMissed()
{
    QFETCH(const double, tolerance);
    const Task task = drifting(tolerance);
    const auto found = sensitivityOf(task, task.checks[0], never);
    QVERIFY(found);
    const double degrees = 2.0 * std::asin(0.5 * tolerance) * 180.0 / std::numbers::pi;
    QVERIFY2(isWithinATenth(found->turn, degrees), qPrintable(describe(*found)));
    QVERIFY2(isWithinATenth(found->speed, tolerance), qPrintable(describe(*found)));
    QVERIFY2(isWithinATenth(found->drift, tolerance / std::numbers::sqrt2),
             qPrintable(describe(*found)));
}

void TestSensitivity::whatIsNotNoticedIsNotTold()
{
    Task task = drifting(1e-3);
    task.checks[0].kind = QStringLiteral("start");
    task.checks[0].parameters = {{QStringLiteral("velocity"), QJsonArray{1.0, 0.0}}};
    const auto found = sensitivityOf(task, task.checks[0], never);
    QVERIFY(found);
    QVERIFY(!found->turn && !found->speed && !found->drift);
    QCOMPARE(describe(*found), QStringLiteral("– · – · –"));
    QCOMPARE(describe({.turn = 0.0624, .speed = 0.005, .drift = 0.0012}),
             QStringLiteral("0.062° · 0.5 % · 1.2 mm/s"));
    QCOMPARE(describe({.turn = 0.0624, .restitution = 0.01, .massExponent = 1e-7}),
             QStringLiteral("0.062° · – · – · e ± 0.01 · r^(3 ± 1e-7)"));
}

/// In the shipped lab, from both sides: its solution passes, and what is wrong by so little fails.
void TestSensitivity::keptQuantitiesAreHeldToABillionth()
{
    const Result<Lab> lab = readLab(QLatin1String(shippedLab));
    QVERIFY(lab.ok());
    int checks = 0;
    for (const Task &task : lab->tasks) {
        for (const CheckSpec &check : task.checks) {
            const bool kept = check.kind == QLatin1String("conserves");
            if (!kept && check.kind != QLatin1String("collides"))
                continue;
            if (task.id == QLatin1String("L42T9"))
                continue; // hits end there at rest, which has no direction
            const auto found = sensitivityOf(task, check, never);
            QVERIFY2(found && found->turn && found->speed, qPrintable(task.id + check.id));
            QVERIFY2(*found->turn < 1e-6, qPrintable(task.id + check.id + describe(*found)));
            QVERIFY2(*found->speed < 1e-8, qPrintable(task.id + check.id + describe(*found)));
            ++checks;
        }
    }
    QVERIFY(checks >= 15);
}

/// By hand: 1 kg meets 8 kg (r twice as large) at rest with 9 m/s, e = 0.5. Right: the first goes
/// on with 9 - 1.5·9·8/9 = -3 m/s, the second with 1.5·9/9 = 1.5 m/s. With m ∝ r^4 it is 16 kg, and
/// the two get -1.5·9·16/17 and 1.5·9/17; with e = 1 they get -2·9·8/9 = -16 and 2.
void TestSensitivity::restitutionAndMassesOfAHitAreShifted()
{
    const HitAnswer hit{.after = 1,
                        .a = 0,
                        .b = 1,
                        .normal = {-1, 0},
                        .approach = 9.0,
                        .restitution = 0.5,
                        .massRatio = 8.0,
                        .radiusRatio = 2.0};
    const auto none = hit.shifts(2, 0.0, 0.0);
    QCOMPARE(none[0], (Vec2{}));
    QCOMPARE(none[1], (Vec2{}));
    const auto heavier = hit.shifts(2, 0.0, 1.0);
    QCOMPARE(heavier[0].x, -1.5 * 9.0 * 16.0 / 17.0 + 12.0);
    QCOMPARE(heavier[1].x, 1.5 * 9.0 / 17.0 - 1.5);
    const auto elastic = hit.shifts(2, 0.5, 0.0);
    QCOMPARE(elastic[0].x, -16.0 + 12.0);
    QCOMPARE(elastic[1].x, 2.0 - 1.5);
    // Momentum stays whatever e is.
    QCOMPARE(elastic[0].x + 8.0 * elastic[1].x, 0.0);
    const HitAnswer wall{.after = 1, .normal = {0, 1}, .approach = 4.0};
    QCOMPARE(wall.shifts(1, 0.25, 0.0)[0], (Vec2{0, 1}));
}

void TestSensitivity::wrongMassesAndRestitutionAreNoticed_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("check");
    QTest::addColumn<bool>("masses");
    QTest::addColumn<bool>("restitution");
    const auto row = [](const char *step, const char *check, bool masses, bool restitution) {
        QTest::addRow("%s %s", step, check)
            << QString::fromLatin1(step) << QString::fromLatin1(check) << masses << restitution;
    };
    row("L42T14", "masses", true, true);
    row("L42T14", "known-values", true, true);
    row("L42T16", "restitution", true, true);
    row("L42T17", "wall-restitution", false, true);
    row("L42T11", "glancing-anywhere", false, true); // of equal circles r says nothing
    row("L42T2", "start-velocity", false, false);
}

void TestSensitivity::wrongMassesAndRestitutionAreNoticed()
{
    QFETCH(const QString, step);
    QFETCH(const QString, check);
    const Result<Lab> lab = readLab(QLatin1String(shippedLab));
    for (const Task &task : lab->tasks) {
        for (const CheckSpec &each : task.checks) {
            if (task.id != step || each.id != check)
                continue;
            const auto found = sensitivityOf(task, each, never);
            QVERIFY(found);
            QTEST(found->massExponent.has_value(), "masses");
            QTEST(found->restitution.has_value(), "restitution");
            QVERIFY2(found->massExponent.value_or(0.0) < 1e-4, qPrintable(describe(*found)));
            QVERIFY2(found->restitution.value_or(0.0) < 1e-4, qPrintable(describe(*found)));
            return;
        }
    }
    QFAIL("no such check");
}

void TestSensitivity::nothingIsMeasuredOfAWrongSolution()
{
    Task task = drifting(1e-3);
    task.solution = QStringLiteral("function on_update(dt)\nend\n");
    QVERIFY(!sensitivityOf(task, task.checks[0], never));
    task.solution.clear();
    QVERIFY(!sensitivityOf(task, task.checks[0], never));
}

QTEST_MAIN(TestSensitivity)
#include "test_sensitivity.moc"
