// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/preset.h"

#include "tests/scenes.h"

#include <QCryptographicHash>

#include <algorithm>
#include <cstring>

using namespace cradle;
using namespace cradle::scenes;

namespace {

/// The closest pair, m between centres.
double smallestDistance(const std::vector<PresetCircle> &circles)
{
    double smallest = infinity;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        for (std::size_t j = i + 1; j < circles.size(); ++j) {
            const Vec2 d = circles[j].body.position - circles[i].body.position;
            smallest = std::min(smallest, std::hypot(d.x, d.y));
        }
    }
    return smallest;
}

QByteArray hashOfPlaces(const std::vector<PresetCircle> &circles)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (const PresetCircle &c : circles) {
        for (const double value : {c.body.position.x, c.body.position.y}) {
            char bytes[sizeof value];
            std::memcpy(bytes, &value, sizeof value);
            hash.addData(QByteArrayView(bytes, sizeof bytes));
        }
    }
    return hash.result().toHex();
}

} // namespace

class TestCircleFill : public QObject
{
    Q_OBJECT
private slots:
    void fillsAsAsked_data();
    void fillsAsAsked();
    void aCrowdTakesTheWholeSquare();
    void theSameSeedGivesTheSameCrowd();
    void anotherSeedGivesAnotherCrowd();
    void placesAreTheSameEverywhere_data();
    void placesAreTheSameEverywhere();
    void whatDoesNotFitIsRefused_data();
    void whatDoesNotFitIsRefused();
    void circlesAreNumberedFromOne();
};

void TestCircleFill::fillsAsAsked_data()
{
    QTest::addColumn<CircleFill>("fill");
    QTest::addColumn<double>("halfSize"); // of the square, m
    QTest::newRow("one") << CircleFill{1, 0.2, 3.0, 7.8, 1} << 4.0;
    QTest::newRow("two") << CircleFill{2, 0.2, 3.0, 7.8, 1} << 4.0;
    QTest::newRow("a gas") << CircleFill{1000, 0.05, 2.0, 1.0, 1} << 4.0;
    QTest::newRow("at rest") << CircleFill{100, 0.1, 0.0, 1.0, 3} << 4.0;
    QTest::newRow("crowded, places at random") << CircleFill{700, 0.1, 2.0, 1.0, 5} << 4.0;
    QTest::newRow("crowded, on a lattice") << CircleFill{1200, 0.1, 2.0, 1.0, 5} << 4.0;
    QTest::newRow("as many as fit") << CircleFill{400, 0.2, 2.0, 1.0, 5} << 4.0;
    QTest::newRow("one as wide as the square") << CircleFill{1, 4.0, 2.0, 1.0, 5} << 4.0;
    QTest::newRow("in a small box") << CircleFill{50, 1e-5, 1e-3, 1.0, 9} << 1e-3;
    QTest::newRow("specks in a wide square") << CircleFill{10, 1e-4, 2.0, 1.0, 9} << 4.0;
    QTest::newRow("the largest seed") << CircleFill{10, 0.1, 1.0, 1.0, 2147483647} << 4.0;
    QTest::newRow("seed 0") << CircleFill{10, 0.1, 1.0, 1.0, 0} << 4.0;
}

void TestCircleFill::fillsAsAsked()
{
    QFETCH(CircleFill, fill);
    QFETCH(double, halfSize);
    const Result<std::vector<PresetCircle>> made = makeCircles(fill, halfSize);
    QVERIFY2(made.ok(), made ? "" : qPrintable(made.error().toString()));
    QCOMPARE(made->size(), static_cast<std::size_t>(fill.count));
    Vec2 sum{};
    double squares = 0.0;
    for (const PresetCircle &c : *made) {
        QCOMPARE(c.body.radius, fill.radius);
        QCOMPARE(c.body.density, fill.density);
        const double room = halfSize - fill.radius + 1e-9 * fill.radius;
        QVERIFY(std::abs(c.body.position.x) <= room);
        QVERIFY(std::abs(c.body.position.y) <= room);
        sum += c.body.velocity;
        squares += lengthSquared(c.body.velocity);
    }
    const double n = fill.count;
    COMPARE_NEAR(std::sqrt(squares / n), fill.rmsSpeed, 1e-12 * fill.rmsSpeed);
    if (fill.count > 1) {
        COMPARE_NEAR(sum.x, 0.0, 1e-12 * n * fill.rmsSpeed);
        COMPARE_NEAR(sum.y, 0.0, 1e-12 * n * fill.rmsSpeed);
        QVERIFY(smallestDistance(*made) >= 2.0 * fill.radius * (1.0 - 1e-9));
    }
    Preset preset;
    preset.halfWidth = halfSize;
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous};
    preset.circles = *made;
    const std::optional<Error> fault = findFault(preset);
    QVERIFY2(!fault, fault ? qPrintable(fault->toString()) : "");
}

void TestCircleFill::aCrowdTakesTheWholeSquare()
{
    // 1000 random places: each quarter holds about 250, ±5 standard deviations of 13.7.
    const Result<std::vector<PresetCircle>> made = makeCircles({1000, 0.02, 1.0, 1.0, 11}, 4.0);
    QVERIFY(made.ok());
    int quarters[4] = {};
    for (const PresetCircle &c : *made)
        ++quarters[(c.body.position.x > 0.0 ? 1 : 0) + (c.body.position.y > 0.0 ? 2 : 0)];
    for (const int count : quarters)
        QVERIFY(count > 181 && count < 319);
}

void TestCircleFill::theSameSeedGivesTheSameCrowd()
{
    for (const int count : {100, 1200}) {
        const CircleFill fill{count, 0.1, 2.0, 1.0, 42};
        QVERIFY(*makeCircles(fill, 4.0) == *makeCircles(fill, 4.0));
    }
}

void TestCircleFill::anotherSeedGivesAnotherCrowd()
{
    for (const int count : {100, 1200}) {
        const auto first = makeCircles({count, 0.1, 2.0, 1.0, 42}, 4.0);
        const auto second = makeCircles({count, 0.1, 2.0, 1.0, 43}, 4.0);
        QVERIFY(first->at(0).body.position != second->at(0).body.position);
        QVERIFY(first->at(0).body.velocity != second->at(0).body.velocity);
    }
}

void TestCircleFill::placesAreTheSameEverywhere_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<QByteArray>("hash");
    // A change of these numbers changes every preset with a fill: only on purpose.
    QTest::newRow("at random")
        << 100 << QByteArray("36c751665ff7a707278bbba6f52f061591ad747545248ede7daeb0ab21006426");
    QTest::newRow("on a lattice")
        << 1200 << QByteArray("938a36ef09e1b1294b7c28710ed2c9317e1ab7b33be39b2e0580b740ee548be8");
}

void TestCircleFill::placesAreTheSameEverywhere()
{
    QFETCH(int, count);
    QFETCH(QByteArray, hash);
    QCOMPARE(hashOfPlaces(*makeCircles({count, 0.1, 2.0, 1.0, 1}, 4.0)), hash);
}

void TestCircleFill::whatDoesNotFitIsRefused_data()
{
    QTest::addColumn<CircleFill>("fill");
    QTest::addColumn<QString>("most");
    QTest::newRow("one too many") << CircleFill{401, 0.2, 1.0, 1.0, 1}
                                  << QStringLiteral("at most 400");
    QTest::newRow("far too many") << CircleFill{100'000, 0.2, 1.0, 1.0, 1}
                                  << QStringLiteral("at most 400");
    QTest::newRow("wider than the square")
        << CircleFill{1, 4.01, 1.0, 1.0, 1} << QStringLiteral("at most 0");
    QTest::newRow("two that each fit")
        << CircleFill{2, 3.0, 1.0, 1.0, 1} << QStringLiteral("at most 1");
}

void TestCircleFill::whatDoesNotFitIsRefused()
{
    QFETCH(CircleFill, fill);
    QFETCH(QString, most);
    const Result<std::vector<PresetCircle>> made = makeCircles(fill, 4.0);
    QVERIFY(!made.ok());
    QCOMPARE(made.error().pointer, QStringLiteral("/circles/fill/count"));
    QVERIFY2(made.error().message.contains(most), qPrintable(made.error().message));
}

void TestCircleFill::circlesAreNumberedFromOne()
{
    const auto made = makeCircles({3, 0.1, 0.0, 1.0, 1}, 4.0);
    QCOMPARE(made->at(0).name, QStringLiteral("circle 1"));
    QCOMPARE(made->at(2).name, QStringLiteral("circle 3"));
}

QTEST_GUILESS_MAIN(TestCircleFill)
#include "test_circle_fill.moc"
