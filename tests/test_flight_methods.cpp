// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_words.h"

#include "tests/check_spec.h"
#include "tests/law_programs.h"

#include <QJsonArray>

using namespace cradle;
using namespace cradle::programs;

/// Which method a circle moves by is told beside those that are asked for, be they one, two or all.
class TestFlightMethods : public QObject
{
    Q_OBJECT
private slots:
    void methodIsToldBesideThoseThatAreAsked_data();
    void methodIsToldBesideThoseThatAreAsked();
};

namespace {

QString utf8(const char *text)
{
    return QString::fromUtf8(text);
}

/// That moves circle 1 by v h and so many g h² in a step, and circle 2 by Euler.
QString programOf(double share)
{
    return written({.move = QStringLiteral("c.position = c.position + c.velocity * h + "
                                           "(c.index == 1 and %1 or 0) * gravity * h * h "
                                           "c.velocity = c.velocity + gravity * h")
                                .arg(share)},
                   structures[0]);
}

/// Of g h², by the first of the methods that are asked for.
double firstOf(const QJsonArray &asked)
{
    const QString name = asked.isEmpty() ? QString() : asked.first().toString();
    return name == QLatin1String("symplectic_euler") ? 1.0
           : name == QLatin1String("verlet")         ? 0.5
                                                     : 0.0;
}

} // namespace

void TestFlightMethods::methodIsToldBesideThoseThatAreAsked_data()
{
    QTest::addColumn<QJsonArray>("asked");
    QTest::addColumn<double>("share");
    QTest::addColumn<QString>("headline"); // empty: it is right
    QTest::addColumn<QString>("body");
    const auto row = [](std::initializer_list<const char *> names, double share,
                        const char *headline, const char *body) {
        QJsonArray asked;
        QByteArray all;
        for (const char *name : names) {
            asked.append(QLatin1String(name));
            all += name + QByteArray(", ");
        }
        QTest::addRow("%s%g", all.constData(), share)
            << asked << share << utf8(headline) << utf8(body);
    };
    const char *const oldVelocity = "Euler moves by the velocity from before the step alone.";
    const char *const newVelocity = "Symplectic Euler changes the velocity first";
    const char *const any = "the exact methods (Verlet, Runge-Kutta 4) ½ g Δt²; one of these";
    const char *const parabola = "before it. v Δt + ½ g Δt² is asked for.";
    const char *const sign = "The sign of ½ g Δt² is wrong in the motion of circle 1";
    const char *const unknown = "The motion of circle 1 is no known method";
    row({"euler"}, 0.0, "", "");
    row({"euler"}, 1.0, "The motion of circle 1 is symplectic Euler, not Euler", oldVelocity);
    row({"euler"}, -0.5, "The motion of circle 1 is no known method; Euler is asked for",
        oldVelocity);
    row({"symplectic_euler"}, 0.5,
        "The motion of circle 1 is the exact parabola, not symplectic Euler", newVelocity);
    row({"verlet", "rk4"}, 0.0, "The motion of circle 1 is Euler, not the exact parabola",
        parabola);
    row({"verlet", "rk4"}, 0.3,
        "The motion of circle 1 is no known method; the exact parabola is asked for", parabola);
    row({"verlet", "rk4"}, -0.5, sign, parabola);
    row({"euler", "verlet"}, 0.5, "", "");
    row({"euler", "verlet"}, 1.0,
        "The motion of circle 1 is symplectic Euler, not Euler or the exact parabola",
        "v Δt or v Δt + ½ g Δt² is asked for.");
    row({"euler", "verlet"}, 0.3, unknown, "v Δt or v Δt + ½ g Δt² is asked for.");
    row({"euler", "verlet"}, -0.5, sign, "v Δt or v Δt + ½ g Δt² is asked for.");
    row({"euler", "symplectic_euler"}, -0.5, unknown, "v Δt or v Δt + g Δt² is asked for.");
    row({"euler", "symplectic_euler", "verlet"}, 0.3, unknown, any);
    row({}, 0.3, unknown, any);
    row({}, 1.0, "", "");
}

void TestFlightMethods::methodIsToldBesideThoseThatAreAsked()
{
    QFETCH(QJsonArray, asked);
    QFETCH(double, share);
    QFETCH(QString, headline);
    QFETCH(QString, body);
    Task task;
    task.preset.gravity = {0.0, -9.81};
    task.preset.circles.resize(2);
    task.checks = {checkOf("integrates", {}, {1})};
    CheckSpec check = checkOf("integrates", {}, {0});
    if (!asked.isEmpty())
        check.parameters = {{QStringLiteral("integrators"), asked}};
    task.checks.push_back(check);
    task.solution = programOf(firstOf(asked));
    const LawBench bench(task);
    const QString program = programOf(share);
    const MeasuredLaws own(&program, bench.ground);
    const auto found = flightDeviations(own.flight(), bench.right.flight(), bench.ground);
    QCOMPARE(LawBench::headlines(found),
             headline.isEmpty() ? QStringList() : QStringList(headline));
    for (const LawDeviation &each : found)
        QVERIFY2(each.message.contains(body), qPrintable(each.message));
}

QTEST_GUILESS_MAIN(TestFlightMethods)
#include "test_flight_methods.moc"
