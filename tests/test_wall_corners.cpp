// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_words.h"

#include "tests/told_numbers.h"

using namespace cradle;
using namespace cradle::programs;

/// A corner is told only of a program whose walls hold by themselves, and a wall that lets a circle
/// through is told also where gravity brings the circle back.
class TestWallCorners : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void finding_data();
    void finding();
    void latePartIsToldWithItsDepth_data();
    void latePartIsToldWithItsDepth();
};

namespace {

/// Circle 1 with these lines for its walls, which see its place p, velocity v and radius r, and the
/// old place.
QString program(const char *gravity, const char *walls)
{
    return QStringLiteral("function on_update(h) local c, old = circle1, circle1.position "
                          "c.velocity = c.velocity + %1 * h "
                          "c.position = c.position + c.velocity * h "
                          "local p, v, r = c.position, c.velocity, c.radius %2 end")
        .arg(QLatin1String(gravity), QLatin1String(walls));
}

} // namespace

void TestWallCorners::finding_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("headline"); ///< empty: none
    const char *none = "gravity";
    const QString turns = program(none, "local turned = v "
                                        "if p.x - r < square.left and v.x < 0 or "
                                        "p.x + r > square.right and v.x > 0 then "
                                        "turned = vec(-turned.x, turned.y) end "
                                        "if p.y - r < square.bottom and v.y < 0 or "
                                        "p.y + r > square.top and v.y > 0 then "
                                        "turned = vec(turned.x, -turned.y) end "
                                        "IN BOTH "
                                        "if turned ~= v then "
                                        "c.position, c.velocity = old, turned end");
    const auto withBoth = [&](const QString &inBoth) {
        return QString(turns).replace(QLatin1String("IN BOTH"), inBoth);
    };
    QTest::newRow("right") << "L42T2" << withBoth({}) << "";
    // Each wall turns its own part alone; who is turned by one of both is by the other a step
    // later.
    const QString lost = QStringLiteral("In a corner the velocity of circle 1 is lost");
    for (const auto &[both, headline] :
         {std::pair("-v.x, -v.y", QString()), std::pair("-v.x, v.y", QString()),
          std::pair("v.x, -v.y", QString()), std::pair("-v.x, 0 * v.y", QString()),
          std::pair("0 * v.x, -v.y", QString()), std::pair("0, v.y", QString()),
          std::pair("0, 0", lost), std::pair("-0.009 * v.x, -0.009 * v.y", lost),
          std::pair("-0.011 * v.x, -0.011 * v.y", QString())})
        QTest::addRow("turned into %s", both)
            << "L42T2"
            << withBoth(QStringLiteral("if turned.x ~= v.x and turned.y ~= v.y then "
                                       "turned = vec(%1) end")
                            .arg(QLatin1String(both)))
            << headline;
    // Who asks whether the rim has crossed the wall in this step does not ask again.
    QTest::newRow("the second from the velocity before")
        << "L42T2"
        << program(none, "if old.x - r >= square.left and p.x - r < square.left or "
                         "old.x + r <= square.right and p.x + r > square.right then "
                         "c.velocity = vec(-v.x, v.y) end "
                         "if old.y - r >= square.bottom and p.y - r < square.bottom or "
                         "old.y + r <= square.top and p.y + r > square.top then "
                         "c.velocity = vec(v.x, -v.y) end")
        << "In a corner only one part of the velocity of circle 1 turns round";
    // Half of the floor and of the ceiling lets it through.
    QTest::newRow("a wall that asks for the other place")
        << "L42T2"
        << program(none, "local turned = v "
                         "if p.x - r < square.left and v.x < 0 or "
                         "p.x + r > square.right and v.x > 0 then "
                         "turned = vec(-turned.x, turned.y) end "
                         "if (p.y - r < square.bottom or p.y + r > square.top) and "
                         "p.x * v.y > 0 then turned = vec(turned.x, -turned.y) end "
                         "if turned ~= v then c.position, c.velocity = old, turned end")
        << "Some hits of circle 1 at the floor and ceiling are not answered";
    QTest::newRow("no ceiling under twice the gravity")
        << "L42T3"
        << program("2 * gravity", "local turned = v "
                                  "if p.x - r < square.left and v.x < 0 or "
                                  "p.x + r > square.right and v.x > 0 then "
                                  "turned = vec(-turned.x, turned.y) end "
                                  "if p.y - r < square.bottom and v.y < 0 then "
                                  "turned = vec(turned.x, -turned.y) end "
                                  "if turned ~= v then c.position, c.velocity = old, turned end")
        << "At the ceiling circle 1 went out";
}

void TestWallCorners::finding()
{
    QFETCH(QString, step);
    QFETCH(QString, source);
    QFETCH(QString, headline);
    const LawBench bench(task(step));
    const MeasuredLaws own(&source, bench.ground);
    const auto found = wallDeviations(own.walls(), bench.right.walls(), bench.ground);
    QStringList headlines;
    for (const LawDeviation &deviation : found)
        headlines.append(deviation.message.section(QLatin1Char('\n'), 0, 0));
    QCOMPARE(headlines, headline.isEmpty() ? QStringList() : QStringList(headline));
}

void TestWallCorners::latePartIsToldWithItsDepth_data()
{
    QTest::addColumn<QString>("walls");
    QTest::addColumn<bool>("isLate");
    const QString both = QStringLiteral("if math.abs(p.x) + r > 4 and p.x * v.x > 0 then "
                                        "c.velocity = vec(-v.x, v.y) %1 end "
                                        "if math.abs(p.y) + r > 4 and p.y * v.y > 0 then "
                                        "c.velocity = vec(%2.x, -v.y) %1 end");
    QTest::newRow("of the velocity before") << both.arg(QString(), QStringLiteral("v")) << true;
    QTest::newRow("and put back") << both.arg(QStringLiteral("c.position = old"),
                                              QStringLiteral("v"))
                                  << false;
    QTest::newRow("right") << both.arg(QString(), QStringLiteral("c.velocity")) << false;
}

/// Who is put back may be turned by the other wall a step later.
void TestWallCorners::latePartIsToldWithItsDepth()
{
    QFETCH(QString, walls);
    QFETCH(bool, isLate);
    const QString source = program("gravity", qPrintable(walls));
    const LawBench bench(task(QStringLiteral("L42T2")));
    const MeasuredLaws own(&source, bench.ground);
    QVERIFY(wallDeviations(own.walls(), bench.right.walls(), bench.ground).empty());
    const auto late = lateInCorner(own.walls(), bench.right.walls(), bench.ground);
    QCOMPARE(late.has_value(), isLate);
    if (!late)
        return;
    const auto n = told::numbersIn(
        told::bodyOf({*late}, QStringLiteral("In a corner one part of the velocity of circle 1")),
        "Circle # came with (#, #) m/s and has (#, #) m/s after the step that brought it into "
        "the corner, with its rim # m beyond the");
    QCOMPARE(n.size(), std::size_t{6});
    QVERIFY(told::isNear(n[3], n[1]) && told::isNear(n[4], -n[2]));
    QVERIFY(n[5] > 0.0 && n[5] < std::abs(n[1]) / 20.0);
}

QTEST_GUILESS_MAIN(TestWallCorners)
#include "test_wall_corners.moc"
