// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_library.h"

#include "tests/programs.h"
#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::programs;
using scenes::dt;

/// The checks of starts and of free motion against recordings written by hand.
class TestChecks : public QObject
{
    Q_OBJECT
private slots:
    void startIsCompared_data();
    void startIsCompared();
    void countOfCirclesIsCompared();
    void integratorIsToldFromItsSteps_data();
    void integratorIsToldFromItsSteps();
    void integratorMustBeTheSameAllTheTime();
    void wrongAccelerationIsRefused_data();
    void wrongAccelerationIsRefused();
    void circleAtAWallCannotBeJudged();
    void asMuchFreeFlightIsSeenAsIsAskedFor();
    void circlesThatStandStillAreNotTogether();
    void closedFormIsCompared_data();
    void closedFormIsCompared();
    void circlesMustStayTogether();
    void integratorsOfTwoCirclesAreCompared();
    void faultSaysWhatWasAndWhatShouldBe();
};

namespace {

constexpr Vec2 down{0.0, -scenes::g};
constexpr double flightTime = 0.8; ///< s; no wall is near

/// x' = x + v h + c g h²; v' = v + g h.
Moves carriedOn(double c, Vec2 gravity = down)
{
    return [c, gravity](Circles &circles, double h) {
        for (Circle &each : circles) {
            each.position += h * each.velocity + c * h * h * gravity;
            each.velocity += h * gravity;
        }
    };
}

const Circle thrown{.position = {-1.0, 0.5}, .velocity = {1.5, 2.0}};

Observation flight(const Moves &program)
{
    return observed(scene({thrown, thrown}, down), flightTime, program);
}

QJsonObject integrators(const QStringList &names)
{
    return {{QStringLiteral("integrators"), QJsonArray::fromStringList(names)}};
}

} // namespace

void TestChecks::startIsCompared_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QJsonValue>("right");
    QTest::addColumn<QJsonValue>("wrong");
    QTest::addColumn<QString>("word");
    const auto row = [](const char *key, const QJsonValue &right, const QJsonValue &wrong) {
        QTest::newRow(key) << QString::fromLatin1(key) << right << wrong
                           << QString::fromLatin1(key) + QStringLiteral(" of circle 2");
    };
    row("position", json({-1.0, 0.5}), json({-1.0, -0.5}));
    row("velocity", json({1.5, 2.0}), json({2.0, 1.5}));
    row("radius", 0.2, 0.4);
    row("density", 7.8, 1.0);
}

void TestChecks::startIsCompared()
{
    QFETCH(QString, key);
    QFETCH(QJsonValue, right);
    QFETCH(QJsonValue, wrong);
    QFETCH(QString, word);
    const Observation o = flight(carriedOn(1.0));
    VERIFY_ACCEPTED(judge(check("start", {0, 1}, {{key, right}}), o));
    const auto fault = judge(check("start", {1}, {{key, wrong}}), o);
    VERIFY_REFUSED(fault, word);
    QCOMPARE(fault->step, qint64{0});
    QVERIFY(fault->expected && fault->observed);
    // What happens later is not the start.
    const Moves wild = [](Circles &c, double) { c[0].position = {3.0, 3.0}; };
    VERIFY_ACCEPTED(judge(check("start", {0, 1}, {{key, right}}), flight(wild)));
}

void TestChecks::countOfCirclesIsCompared()
{
    const QString count = QStringLiteral("count");
    const Observation o = flight(carriedOn(1.0));
    VERIFY_ACCEPTED(judge(check("start", {0}, {{count, 2}}), o));
    const auto fault = judge(check("start", {0}, {{count, 3}}), o);
    VERIFY_REFUSED(fault, QStringLiteral("2 circles"));
    QCOMPARE(*fault->expected, 3.0);
    QCOMPARE(*fault->observed, 2.0);
}

void TestChecks::integratorIsToldFromItsSteps_data()
{
    QTest::addColumn<double>("curvature");
    QTest::addColumn<QStringList>("names");
    QTest::newRow("Euler") << 0.0 << QStringList{QStringLiteral("euler")};
    QTest::newRow("symplectic") << 1.0 << QStringList{QStringLiteral("symplectic_euler")};
    QTest::newRow("midpoint") << 0.5
                              << QStringList{QStringLiteral("verlet"), QStringLiteral("rk4")};
}

void TestChecks::integratorIsToldFromItsSteps()
{
    QFETCH(double, curvature);
    QFETCH(QStringList, names);
    const Observation o = flight(carriedOn(curvature));
    VERIFY_ACCEPTED(judge(check("integrates", {0, 1}), o));
    for (const char *name : {"euler", "symplectic_euler", "verlet", "rk4"}) {
        const auto fault =
            judge(check("integrates", {0}, integrators({QString::fromLatin1(name)})), o);
        QCOMPARE(!fault, names.contains(QLatin1String(name)));
        if (fault)
            QCOMPARE(fault->step, qint64{1});
    }
    VERIFY_REFUSED(judge(check("integrates"), flight(carriedOn(0.3))), QStringLiteral("moved by"));
    // Two or four equal steps of an Euler, where no method is asked for.
    for (const double substeps : {0.25, 0.75, 0.375, 0.625})
        VERIFY_ACCEPTED(judge(check("integrates"), flight(carriedOn(substeps))));
    VERIFY_REFUSED(judge(check("integrates", {0}, integrators({QStringLiteral("euler")})),
                         flight(carriedOn(0.25))),
                   QStringLiteral("moved by"));
}

void TestChecks::integratorMustBeTheSameAllTheTime()
{
    int step = 0;
    const auto fault =
        judge(check("integrates"),
              flight([&](Circles &c, double h) { carriedOn(++step % 2 == 0 ? 0.0 : 1.0)(c, h); }));
    VERIFY_REFUSED(fault, QStringLiteral("Euler"));
    QCOMPARE(fault->step, qint64{2});
}

void TestChecks::wrongAccelerationIsRefused_data()
{
    QTest::addColumn<Vec2>("gravity");
    QTest::newRow("upward") << -down;
    QTest::newRow("twice") << 2.0 * down;
    QTest::newRow("sideways") << Vec2{-scenes::g, 0.0};
    QTest::newRow("none") << Vec2{};
    QTest::newRow("a little less") << (1.0 - 1e-6) * down;
}

void TestChecks::wrongAccelerationIsRefused()
{
    QFETCH(Vec2, gravity);
    const auto fault = judge(check("integrates"), flight(carriedOn(1.0, gravity)));
    VERIFY_REFUSED(fault, QStringLiteral("acceleration"));
    QCOMPARE(fault->unit, QStringLiteral("m/s²"));
    // The check's own gravity goes before that of the scene.
    const QJsonObject own{{QStringLiteral("gravity"), json(gravity)}};
    VERIFY_ACCEPTED(judge(check("integrates", {0}, own), flight(carriedOn(1.0, gravity))));
}

void TestChecks::circleAtAWallCannotBeJudged()
{
    const Circle onFloor{.position = {0.0, -3.8}};
    const Observation o = observed(scene({onFloor}, down), 0.5, [](Circles &, double) {});
    VERIFY_REFUSED(judge(check("integrates"), o), QStringLiteral("free of walls"));
}

void TestChecks::asMuchFreeFlightIsSeenAsIsAskedFor()
{
    // 0.8 s of fall, then it lies on the floor.
    const Observation o =
        observed(scene({Circle{.position = {0.0, -0.7}}}, down), 4.0, [](Circles &c, double h) {
            fall(c[0], down, h);
            if (c[0].position.y < -3.8)
                c[0] = {.position = {0.0, -3.8}};
        });
    VERIFY_ACCEPTED(judge(check("integrates"), o));
    const QJsonObject one{{QStringLiteral("free"), 1.0}};
    for (const char *kind : {"integrates", "closed_form"})
        VERIFY_REFUSED(
            judge(check(kind, {0},
                        {{QStringLiteral("free"), 1.0}, {QStringLiteral("tolerance"), 0.2}}),
                  o),
            QStringLiteral("at least 1 s must be seen"));
    VERIFY_REFUSED(judge(check("same_integrator", {0, 0}, one), o),
                   QStringLiteral("at least 1 s must be seen"));
}

void TestChecks::circlesThatStandStillAreNotTogether()
{
    const Observation o = observed(scene({{}, {}}), 4.0, [](Circles &, double) {});
    VERIFY_REFUSED(judge(check("together", {0, 1}), o), QStringLiteral("stay together"));
}

void TestChecks::closedFormIsCompared_data()
{
    QTest::addColumn<double>("curvature");
    QTest::addColumn<bool>("exact");
    QTest::newRow("Euler") << 0.0 << false;
    QTest::newRow("symplectic") << 1.0 << false;
    QTest::newRow("Verlet") << 0.5 << true;
}

void TestChecks::closedFormIsCompared()
{
    QFETCH(double, curvature);
    QFETCH(bool, exact);
    const auto fault = judge(check("closed_form", {0, 1}), flight(carriedOn(curvature)));
    QCOMPARE(!fault, exact);
    if (fault) {
        // Off by g h²/2 after one step.
        QCOMPARE(fault->step, qint64{1});
        COMPARE_NEAR(std::abs(*fault->observed - *fault->expected), scenes::g * dt * dt / 2, 1e-12);
    }
}

void TestChecks::circlesMustStayTogether()
{
    VERIFY_ACCEPTED(judge(check("together", {0, 1}), flight(carriedOn(0.0))));
    int step = 0;
    const auto fault = judge(check("together", {0, 1}), flight([&](Circles &c, double h) {
                                 carriedOn(0.0)(c, h);
                                 c[1].position.x += ++step == 7 ? 1e-6 : 0.0;
                             }));
    VERIFY_REFUSED(fault, QStringLiteral("same place"));
    QCOMPARE(fault->step, qint64{7});
}

void TestChecks::integratorsOfTwoCirclesAreCompared()
{
    const CheckSpec same = check("same_integrator", {0, 1});
    for (const double c : {0.0, 0.5, 1.0})
        VERIFY_ACCEPTED(judge(same, flight(carriedOn(c))));
    const auto each = [](double first, double second) {
        return [=](Circles &c, double h) {
            Circles one{c[0]};
            Circles two{c[1]};
            carriedOn(first)(one, h);
            carriedOn(second)(two, h);
            c = {one[0], two[0]};
        };
    };
    VERIFY_REFUSED(judge(same, flight(each(0.0, 1.0))), QStringLiteral("the same for both"));
    VERIFY_REFUSED(judge(same, flight(each(1.0, 0.5))), QStringLiteral("the same for both"));
    VERIFY_REFUSED(judge(same, flight(each(0.3, 0.3))), QStringLiteral("None of the four"));
}

void TestChecks::faultSaysWhatWasAndWhatShouldBe()
{
    // One step of 1/60 s: Euler stays at its height, symplectic Euler falls by g/3600 = 0.002725 m.
    const Observation o = observed(scene({{}}, down), 0.1, carriedOn(0.0));
    const auto fault =
        judge(check("integrates", {0}, integrators({QStringLiteral("symplectic_euler")})), o);
    VERIFY_REFUSED(fault, QStringLiteral("In this step Euler does so"));
    COMPARE_NEAR(*fault->expected, -0.002725, 1e-9);
    QCOMPARE(*fault->observed, 0.0);
    QCOMPARE(fault->unit, QStringLiteral("m"));
    QVERIFY(fault->message.contains(QStringLiteral("-0.002725")));
}

QTEST_APPLESS_MAIN(TestChecks)
#include "test_checks.moc"
