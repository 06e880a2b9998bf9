// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_library.h"

#include "tests/check_spec.h"
#include "tests/contact_programs.h"
#include "tests/scenes.h"

#include <QJsonArray>

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::programs::contacts;
using scenes::dt;

/// The checks of a moment, of bounce heights, of the moment and the speed of a hit, and the scene
/// of circles that part.
class TestChecksMoments : public QObject
{
    Q_OBJECT
private slots:
    void endIsCompared_data();
    void endIsCompared();
    void heightsFollowTheLaw_data();
    void heightsFollowTheLaw();
    void ballThatDoesNotBounceIsTold();
    void hitInTimeIsAccepted_data();
    void hitInTimeIsAccepted();
    void wrongTimeIsRefused_data();
    void wrongTimeIsRefused();
    void reboundIsCompared_data();
    void reboundIsCompared();
    void toleranceWidensWhatIsRight();
};

namespace {

/// A value, for an array of one array is that array itself to some compilers (CWG 2137).
QJsonValue pair(double x, double y)
{
    return QJsonArray{x, y};
}

/// Two circles on the x axis that meet after about 0.5 s with a closing speed of 2 m/s.
Observation headOn(const Moves &program, double e = 1.0)
{
    const Circle one{.position = {-1.5, 0}, .velocity = {2, 0}};
    const Circle two{.position = {0, 0}, .radius = 0.3};
    return observed(scene({one, two}, {}, e), 1.0, program);
}

/// Falls by symplectic Euler from 2 m above the floor; at the floor it is put back onto it and
/// leaves with \p share of its speed.
Moves ball(double share)
{
    return [share](Circles &c, double h) {
        c[0].velocity += h * Vec2{0, -9.81};
        c[0].position += h * c[0].velocity;
        const double floor = -4.0 + c[0].radius;
        if (c[0].position.y < floor && c[0].velocity.y < 0.0) {
            c[0].position.y = floor;
            c[0].velocity.y *= -share;
        }
    };
}

Observation dropped(double share, double e)
{
    const Circle c{.position = {0, -2.0 + 0.2}, .radius = 0.2};
    return observed(scene({c}, {0, -9.81}, e), 4.0, ball(share));
}

} // namespace

void TestChecksMoments::endIsCompared_data()
{
    QTest::addColumn<QJsonObject>("parameters");
    QTest::addColumn<QString>("fault"); ///< its beginning; empty if it is right
    const auto row = [](const char *name, const QJsonObject &parameters, const char *fault) {
        QTest::newRow(name) << parameters << QString::fromUtf8(fault);
    };
    const QString positions = QStringLiteral("positions");
    const QString velocities = QStringLiteral("velocities");
    const QString time = QStringLiteral("time");
    // Drifts from (−1, 0) with (2, 1) m/s for 1 s.
    row("place at the end", {{positions, QJsonArray{pair(1, 1)}}}, "");
    row("place at a moment", {{positions, QJsonArray{pair(0, 0.5)}}, {time, 0.5}}, "");
    row("between two steps", {{positions, QJsonArray{pair(-0.99, 0.005)}}, {time, 0.005}}, "");
    row("velocity", {{velocities, QJsonArray{pair(2, 1)}}}, "");
    row("nothing asked", {}, "");
    row("another place", {{positions, QJsonArray{pair(1, 1.5)}}},
        "At 1 s circle 1 is at (1, 1) m; (1, 1.5) m is right");
    row("another moment", {{positions, QJsonArray{pair(1, 1)}}, {time, 0.5}},
        "At 0.5 s circle 1 is at (0, 0.5) m; (1, 1) m is right");
    row("another velocity", {{velocities, QJsonArray{pair(2, -1)}}},
        "At 1 s circle 1 moves with (2, 1) m/s; (2, -1) m/s is right");
    row("outside the tolerance",
        {{positions, QJsonArray{pair(1.002, 1)}}, {QStringLiteral("tolerance"), 1e-3}},
        "At 1 s circle 1 is at (1, 1) m; (1.002, 1) m is right");
    row("inside the tolerance",
        {{positions, QJsonArray{pair(1.002, 1)}}, {QStringLiteral("tolerance"), 3e-3}}, "");
}

void TestChecksMoments::endIsCompared()
{
    QFETCH(QJsonObject, parameters);
    QFETCH(QString, fault);
    const Observation run =
        observed(scene({{.position = {-1, 0}, .velocity = {2, 1}}}), 1.0,
                 [](Circles &c, double h) { c[0].position += h * c[0].velocity; });
    const auto found = judge(checkOf("ends_at", parameters), run);
    QCOMPARE(found.has_value(), !fault.isEmpty());
    if (found)
        QCOMPARE(found->message, fault);
}

void TestChecksMoments::heightsFollowTheLaw_data()
{
    QTest::addColumn<double>("share");
    QTest::addColumn<double>("e");
    QTest::addColumn<bool>("right");
    for (const double e : {0.0, 0.3, 0.5, 0.7, 0.9, 1.0}) {
        QTest::addRow("e = %g", e) << e << e << true;
        if (e > 0.4 && e < 0.95)
            QTest::addRow("e = %g counted twice", e) << e * e << e << false;
        if (e < 0.95)
            QTest::addRow("elastic for e = %g", e) << 1.0 << e << false;
    }
}

void TestChecksMoments::heightsFollowTheLaw()
{
    QFETCH(double, share);
    QFETCH(double, e);
    QFETCH(bool, right);
    const auto fault =
        judge(checkOf("bounce_heights", {{QStringLiteral("tolerance"), 0.1}}), dropped(share, e));
    QVERIFY2(fault.has_value() != right, fault ? qPrintable(fault->message) : "accepted");
    if (fault) {
        // From 2 m the first bounce reaches e² · 2 m.
        QVERIFY2(qAbs(*fault->expected - 2.0 * e * e) < 1e-9, qPrintable(fault->message));
        QVERIFY(fault->observed);
        QCOMPARE(fault->unit, QStringLiteral("m"));
    }
}

void TestChecksMoments::ballThatDoesNotBounceIsTold()
{
    const auto stays = judge(checkOf("bounce_heights", {}), dropped(0.0, 0.8));
    QVERIFY(stays);
    QVERIFY2(stays->observed && *stays->observed < 0.1, qPrintable(stays->message));
    const Observation hanging =
        observed(scene({{.position = {0, 0}}}, {0, -9.81}), 2.0, [](Circles &, double) {});
    const auto hangs = judge(checkOf("bounce_heights", {}), hanging);
    QVERIFY(hangs);
    QCOMPARE(hangs->expected, 3.0);
    QCOMPARE(hangs->observed, 0.0);
}

void TestChecksMoments::hitInTimeIsAccepted_data()
{
    QTest::addColumn<int>("way");
    for (int way = 0; way < static_cast<int>(std::size(rightWays)); ++way)
        QTest::newRow(rightWays[way].name) << way;
}

void TestChecksMoments::hitInTimeIsAccepted()
{
    QFETCH(int, way);
    for (const double e : {1.0, 0.5, 0.0}) {
        const Observation run =
            headOn([&](Circles &c, double h) { rightWays[way].step(c, e, h); }, e);
        for (const char *kind : {"touches", "rebounds"}) {
            const auto fault = judge(checkOf(kind, {}, {0, 1}), run);
            QVERIFY2(!fault, fault ? qPrintable(fault->message) : "");
        }
    }
}

void TestChecksMoments::wrongTimeIsRefused_data()
{
    QTest::addColumn<double>("distance"); ///< at which the program answers, in r₁ + r₂
    QTest::addColumn<QString>("word");
    QTest::newRow("early") << 1.5 << QStringLiteral("from whose rim it was still");
    QTest::newRow("late") << 0.5 << QStringLiteral("answered only in step");
    QTest::newRow("never") << 0.0 << QStringLiteral("as if nothing had happened");
}

void TestChecksMoments::wrongTimeIsRefused()
{
    QFETCH(double, distance);
    QFETCH(QString, word);
    const Observation run = headOn([&](Circles &c, double h) {
        move(c, h);
        if (length(between(c)) < distance * reach(c))
            push(c, normalized(between(c)), 1.0);
    });
    const auto fault = judge(checkOf("touches", {}, {0, 1}), run);
    QVERIFY(fault);
    QVERIFY2(fault->message.contains(word), qPrintable(fault->message));
}

void TestChecksMoments::reboundIsCompared_data()
{
    QTest::addColumn<double>("used");
    QTest::addColumn<double>("asked");
    QTest::newRow("as asked") << 0.5 << 0.5;
    QTest::newRow("elastic") << 1.0 << 0.5;
    QTest::newRow("too little") << 0.25 << 0.5;
    QTest::newRow("none") << 0.0 << 0.5;
    QTest::newRow("for a plastic hit") << 0.5 << 0.0;
}

void TestChecksMoments::reboundIsCompared()
{
    QFETCH(double, used);
    QFETCH(double, asked);
    const Observation run = headOn([&](Circles &c, double h) { rightWays[0].step(c, used, h); });
    const QJsonObject wanted{{QStringLiteral("restitution"), asked}};
    const auto fault = judge(checkOf("rebounds", wanted, {0, 1}), run);
    QCOMPARE(fault.has_value(), used != asked);
    if (fault) {
        // They meet with 2 m/s.
        QCOMPARE(fault->expected, 2.0 * asked);
        QVERIFY(qAbs(*fault->observed - 2.0 * used) < 1e-9);
    }
    // When they answer is right in any case.
    QVERIFY(!judge(checkOf("touches", wanted, {0, 1}), run));
}

void TestChecksMoments::toleranceWidensWhatIsRight()
{
    // Moves by 0.1 % too much in every step.
    const Observation run =
        observed(scene({{.position = {-1, 0}, .velocity = {2, 0}}}), 1.0,
                 [](Circles &c, double h) { c[0].position += 1.001 * h * c[0].velocity; });
    QVERIFY(judge(checkOf("integrates", {}), run));
    QVERIFY(judge(checkOf("integrates", {{QStringLiteral("tolerance"), 1e-6}}), run));
    QVERIFY(!judge(checkOf("integrates", {{QStringLiteral("tolerance"), 1e-3}}), run));
    QVERIFY(judge(checkOf("closed_form", {{QStringLiteral("tolerance"), 1e-3}}), run));
    QVERIFY(!judge(checkOf("closed_form", {{QStringLiteral("tolerance"), 3e-3}}), run));
}

QTEST_GUILESS_MAIN(TestChecksMoments)
#include "test_checks_moments.moc"
