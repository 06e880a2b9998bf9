// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_words.h"

#include "tests/told_numbers.h"

#include <functional>

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// The numbers that findings on the walls and hits of a program tell are those that its law makes.
class TestToldHits : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void answerOfAWallIsTold_data();
    void answerOfAWallIsTold();
    void shareOfAWallIsTold();
    void reachOfAWallIsTold_data();
    void reachOfAWallIsTold();
    void lengthForTheRadiusIsTold();
    void openWallsAreTold();
    void distanceOfAContactIsTold_data();
    void distanceOfAContactIsTold();
    void massesOfAHitAreTold_data();
    void massesOfAHitAreTold();
    void reboundOfAHitIsTold_data();
    void reboundOfAHitIsTold();

private:
    using Law = std::function<double(double)>; ///< of e

    [[nodiscard]] QString bodyOfWalls(const QString &walls, const QString &headline = {}) const
    {
        const LawBench bench(task(QStringLiteral("L42T17")));
        const QString program = written({.walls = walls}, structures[0]);
        const MeasuredLaws own(&program, bench.ground);
        return bodyOf(wallDeviations(own.walls(), bench.right.walls(), bench.ground), headline);
    }
    /// In step 16, where radii, densities and e are varied.
    [[nodiscard]] std::vector<LawDeviation> foundOfHit(const HitLaw &law) const
    {
        const LawBench bench(task(QStringLiteral("L42T16")));
        const QString program =
            written({.walls = wallsOf(wallWays[1], "c.radius", "1"), .hit = hitOf(hitWays[1], law)},
                    structures[1]);
        const MeasuredLaws own(&program, bench.ground);
        auto found = contactDeviations(own.pair(), bench.right.pair(), bench.ground);
        for (LawDeviation &each : responseDeviations(own.pair(), bench.right.pair(), bench.ground))
            found.push_back(std::move(each));
        return found;
    }
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

const QString e = QStringLiteral("restitution");

} // namespace

void TestToldHits::answerOfAWallIsTold_data()
{
    QTest::addColumn<QString>("back");
    QTest::addColumn<QString>("along");
    QTest::addColumn<Law>("backLaw");
    QTest::addColumn<Law>("alongLaw");
    const auto row = [](
                         const char *back, const Law &backLaw, const char *along = "1",
                         const Law &alongLaw = [](double) { return 1.0; }) {
        QTest::addRow("%s, %s", back, along) << text(back) << text(along) << backLaw << alongLaw;
    };
    const Law same = [](double r) { return r; };
    row("restitution ^ 2", [](double r) { return r * r; });
    row("math.sqrt(restitution)", [](double r) { return std::sqrt(r); });
    row("1 - restitution", [](double r) { return 1.0 - r; });
    row("1 + restitution", [](double r) { return 1.0 + r; });
    row("0.9 * restitution", [](double r) { return 0.9 * r; });
    row("0.3 + 0.5 * restitution", [](double r) { return 0.3 + 0.5 * r; });
    row("0.75", [](double) { return 0.75; });
    row("0", [](double) { return 0.0; });
    row("1", [](double) { return 1.0; });
    row("-restitution", [](double r) { return -r; });
    row("restitution", same, "restitution", same);
    row("restitution", same, "-restitution", [](double r) { return -r; });
    row("restitution", same, "0", [](double) { return 0.0; });
    row("restitution", same, "-1", [](double) { return -1.0; });
    row("restitution", same, "0.8", [](double) { return 0.8; });
}

/// At the e nearest to ½ of those with which it is wrong, so that laws of e are told apart.
void TestToldHits::answerOfAWallIsTold()
{
    QFETCH(QString, back);
    QFETCH(QString, along);
    QFETCH(Law, backLaw);
    QFETCH(Law, alongLaw);
    const QString body = bodyOfWalls(
        wallsOf(wallWays[1], "c.radius", back.toUtf8().constData(), along.toUtf8().constData()));
    const auto n = numbersIn(body, "With e = #: Circle # came to the * with (#, #) m/s and left it "
                                   "with (#, #) m/s; (#, #) m/s is right.");
    QVERIFY2(n.size() == 8, qPrintable(body));
    const bool isSide = body.contains(QLatin1String("t wall with"));
    const auto parts = [&](std::size_t at) { // along the normal and the wall
        return isSide ? Vec2{n[at], n[at + 1]} : Vec2{n[at + 1], n[at]};
    };
    const Vec2 came = parts(2);
    QVERIFY(came.x != 0.0 && came.y != 0.0);
    QVERIFY(isNear(parts(4).x, -backLaw(n[0]) * came.x));
    QVERIFY(isNear(parts(4).y, alongLaw(n[0]) * came.y));
    QVERIFY(isNear(parts(6).x, -n[0] * came.x));
    QVERIFY(isNear(parts(6).y, came.y));
    QVERIFY(n[1] == 1.0 || n[1] == 2.0);
    double best = 1.0; // of 0, ¼, ½, ¾ and 1
    for (const double r : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        if (!isNear(backLaw(r), r) || !isNear(alongLaw(r), 1.0))
            best = std::min(best, std::abs(r - 0.5));
    }
    QCOMPARE(std::abs(n[0] - 0.5), best);
}

/// What comes back, where no law of e is named.
void TestToldHits::shareOfAWallIsTold()
{
    const auto body = [&](const char *back, const char *headline) {
        return bodyOfWalls(wallsOf(wallWays[1], "c.radius", back), text(headline));
    };
    auto n = numbersIn(body("0.3 + 0.5 * restitution",
                            "The walls do not give both circles e times the speed back"),
                       "With e = # it is # times the speed, with e = # # times.");
    QCOMPARE(n.size(), std::size_t{4});
    QVERIFY(n[0] != n[2]);
    QVERIFY(isNear(n[1], 0.3 + 0.5 * n[0]) && isNear(n[3], 0.3 + 0.5 * n[2]));
    QVERIFY(!body("0.9 * restitution", "The walls give both circles 0.9 e of the speed back, not e")
                 .isEmpty());
    n = numbersIn(body("0.75", "At the walls a number stands for e, for both circles"),
                  "Whatever e is, # of the speed comes back.");
    QCOMPARE(n, std::vector<double>{0.75});
    n = numbersIn(body("1.7 / math.abs(v)", "The walls give both circles a speed of their own"),
                  "However fast it comes, it leaves the wall with # m/s");
    QCOMPARE(n, std::vector<double>{1.7});
}

void TestToldHits::reachOfAWallIsTold_data()
{
    QTest::addColumn<QString>("reach");
    QTest::addColumn<double>("more"); // than the radius, m
    QTest::newRow("too early") << "c.radius + 0.07" << 0.07;
    QTest::newRow("too late") << "c.radius - 0.06" << -0.06;
    QTest::newRow("past the wall") << "c.radius - 0.6" << -0.6;
}

/// Between two places as far apart as it goes in a step.
void TestToldHits::reachOfAWallIsTold()
{
    QFETCH(QString, reach);
    QFETCH(double, more);
    const QString body = bodyOfWalls(wallsOf(wallWays[1], reach.toUtf8().constData()));
    auto n = numbersIn(body, "The radius of circle # is # m, and at the * it turns when its centre "
                             "is between # and # m from the wall.");
    double sign = 1.0;
    if (n.empty()) {
        sign = -1.0;
        n = numbersIn(body, "The radius of circle # is # m, and at the * it turns when its centre "
                            "is between # and # m past the wall.");
    }
    QVERIFY2(n.size() == 4, qPrintable(body));
    QCOMPARE(sign, more < -0.5 ? -1.0 : 1.0);
    const double place = n[1] + more;
    QVERIFY(sign * n[2] <= place + 1e-3 && place - 1e-3 <= sign * n[3]);
    QVERIFY(std::abs(n[3] - n[2]) > 0.01 && std::abs(n[3] - n[2]) < 0.06); // 1.07 to 2.9 m/s
}

void TestToldHits::lengthForTheRadiusIsTold()
{
    const QString body = bodyOfWalls(wallsOf(wallWays[1], "2 * c.radius"));
    const auto n = numbersIn(
        body, "The radius of circle # is # m, and it turns when its centre is # m from the wall");
    QVERIFY2(n.size() == 3, qPrintable(body));
    QVERIFY(isNear(n[2], 2.0 * n[1]));
}

void TestToldHits::openWallsAreTold()
{
    const auto n =
        numbersIn(bodyOfWalls({}, text("None of the four walls turns both circles round")),
                  "Thrown at each of the four walls, # m/s fast, it goes on through them.");
    QCOMPARE(n.size(), std::size_t{1});
    QVERIFY(isNear(n[0], 2.9 * std::hypot(1.0, 0.37))); // beside the wall, too
    const QString left = QStringLiteral("if c.position.x > -3 then ") + wallsOf(wallWays[1])
                         + QStringLiteral(" end");
    QVERIFY(!bodyOfWalls(left, text("Not every wall holds both circles: left wall")).isEmpty());
}

void TestToldHits::distanceOfAContactIsTold_data()
{
    QTest::addColumn<QString>("reach");
    QTest::addColumn<Vec2>("shares"); // of r₁ and r₂
    QTest::addColumn<double>("more"); // m
    QTest::newRow("r1") << "p.radius" << Vec2{1, 0} << 0.0;
    QTest::newRow("r2") << "q.radius" << Vec2{0, 1} << 0.0;
    QTest::newRow("half") << "(p.radius + q.radius) / 2" << Vec2{0.5, 0.5} << 0.0;
    QTest::newRow("farther") << "p.radius + q.radius + 0.06" << Vec2{1, 1} << 0.06;
    QTest::newRow("nearer") << "p.radius + q.radius - 0.06" << Vec2{1, 1} << -0.06;
    QTest::newRow("a number") << "0.55" << Vec2{0, 0} << 0.55;
}

void TestToldHits::distanceOfAContactIsTold()
{
    QFETCH(QString, reach);
    QFETCH(Vec2, shares);
    QFETCH(double, more);
    const QString body = bodyOf(foundOfHit({.reach = reach, .e = e}), {});
    const auto n = numbersIn(body, "With r₁ = # m and r₂ = # m, met at #°, they answered when "
                                   "their centres were between # and # m apart.");
    QVERIFY2(n.size() == 5, qPrintable(body));
    QVERIFY(n[0] != n[1] || more == 0.55); // it shows whose radius counts
    const double place = shares.x * n[0] + shares.y * n[1] + more;
    QVERIFY(n[3] <= place + 1e-3 && place - 1e-3 <= n[4]);
    QVERIFY(n[4] - n[3] > 0.005 && n[4] - n[3] < 0.04);
    const auto touching =
        numbersIn(body, "Rims touch where the centres are r₁ + r₂ apart, here # m.");
    if (more != 0.55) {
        QCOMPARE(touching.size(), std::size_t{1});
        QVERIFY(isNear(touching[0], n[0] + n[1]));
    } else {
        const auto same = numbersIn(body, "between # and # m.");
        QCOMPARE(same.size(), std::size_t{2});
        QVERIFY(same[0] <= 0.5501 && 0.5499 <= same[1] && same[1] - same[0] < 0.04);
    }
}

void TestToldHits::massesOfAHitAreTold_data()
{
    QTest::addColumn<QString>("mass");
    QTest::addColumn<double>("radius"); // exponents
    QTest::addColumn<double>("density");
    QTest::newRow("discs") << "c.density * c.radius ^ 2" << 2.0 << 1.0;
    QTest::newRow("no density") << "c.radius ^ 3" << 3.0 << 0.0;
    QTest::newRow("no radius") << "c.density" << 0.0 << 1.0;
    QTest::newRow("root of the density") << "c.density ^ 0.5 * c.radius ^ 3" << 3.0 << 0.5;
    QTest::newRow("exchanged") << "1 / (c.density * c.radius ^ 3)" << -3.0 << -1.0;
    QTest::newRow("none") << "1" << 0.0 << 0.0;
}

void TestToldHits::massesOfAHitAreTold()
{
    QFETCH(QString, mass);
    QFETCH(double, radius);
    QFETCH(double, density);
    const QString body = bodyOf(foundOfHit({.mass = mass, .e = e}), {});
    const auto n = numbersIn(body, "With r₁ = # and r₂ = # m, ρ₁ = # and ρ₂ = # (e = #), the "
                                   "change of v₁ was # times that of v₂; m₂/m₁ = # is right.");
    QVERIFY2(n.size() == 7, qPrintable(body));
    const double radii = n[1] / n[0];
    const double densities = n[3] / n[2];
    QVERIFY(isNear(n[5], std::pow(radii, radius) * std::pow(densities, density)));
    QVERIFY(isNear(n[6], std::pow(radii, 3.0) * densities));
    QVERIFY(!isNear(n[5], n[6]));
}

void TestToldHits::reboundOfAHitIsTold_data()
{
    QTest::addColumn<QString>("given"); // in place of e
    QTest::addColumn<QString>("headline");
    QTest::addColumn<Law>("law");
    const auto row = [](const char *name, const char *headline, const Law &law) {
        QTest::newRow(name) << text(name) << text(headline) << law;
    };
    row("restitution ^ 2", "", [](double r) { return r * r; });
    row("1 - restitution", "", [](double r) { return 1.0 - r; });
    row("0.6", "A number stands for e in the hit of two circles", [](double) { return 0.6; });
    row("1", "", [](double) { return 1.0; });
    row("-restitution", "The sign of e is wrong in the hit of two circles",
        [](double r) { return -r; });
}

/// Of two equal circles, at an e with which it comes out wrong.
void TestToldHits::reboundOfAHitIsTold()
{
    QFETCH(QString, given);
    QFETCH(QString, headline);
    QFETCH(Law, law);
    const auto found = foundOfHit({.e = given});
    QString body;
    for (const LawDeviation &each : found) {
        if (each.topic == Topic::Restitution)
            body = each.message;
    }
    QVERIFY2(body.startsWith(headline), qPrintable(body));
    const auto n = numbersIn(
        body, "With e = #: Velocities in m/s along the line of centres (from 1 to 2) and across "
              "it: circle 1 came with # along, # across, circle 2 with # along, # across; they "
              "left with # along, # across and with # along, # across; right is # along, # across "
              "and # along, # across.");
    QVERIFY2(n.size() == 13, qPrintable(body));
    const double closing = n[1] - n[3];
    QVERIFY(closing > 0.5);
    const auto left = [&](double r) {
        const double push = 0.5 * (1.0 + r) * closing;
        return Vec2{n[1] - push, n[3] + push};
    };
    const auto isTold = [&](std::size_t at, Vec2 expected) {
        return std::abs(n[at] - expected.x) < 0.02 && std::abs(n[at + 2] - expected.y) < 0.02
               && std::abs(n[at + 1] - n[2]) < 0.02 && std::abs(n[at + 3] - n[4]) < 0.02;
    };
    QVERIFY2(isTold(5, left(law(n[0]))), qPrintable(body));
    QVERIFY2(isTold(9, left(n[0])), qPrintable(body));
    QVERIFY(std::abs(law(n[0]) - n[0]) > 0.1);
}

QTEST_GUILESS_MAIN(TestToldHits)
#include "test_told_hits.moc"
