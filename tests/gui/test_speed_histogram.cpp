// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/simulation.h"
#include "tests/gui/chart_scenes.h"
#include "tests/gui/settled.h"
#include "tests/patience.h"
#include "views/charts/speed_histogram.h"
#include "views/charts/speed_plot.h"

#include <QSignalSpy>
#include <QTest>

#include <numeric>

using namespace cradle;

namespace {

constexpr double pi = std::numbers::pi;

/// Circles that move so fast along x, all in one place: nothing but their speeds matters.
std::vector<Circle> moving(const std::vector<double> &speeds, double density = 1.0)
{
    std::vector<Circle> circles;
    for (const double speed : speeds)
        circles.push_back({.velocity = {speed, 0.0}, .density = density});
    return circles;
}

/// Speeds at equal steps of the share that is slower: as near to the curve as can be.
std::vector<double> quantiles(std::size_t count, double spread)
{
    std::vector<double> speeds;
    for (std::size_t i = 0; i < count; ++i) {
        const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        speeds.push_back(spread * std::sqrt(-2.0 * std::log1p(-share)));
    }
    return speeds;
}

/// Equal circles on a lattice, all equally fast, in directions that turn by the golden angle.
Preset equallyFast(int side, double speed)
{
    Preset preset;
    preset.halfWidth = 0.35 * side;
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Exact};
    for (int i = 0; i < side * side; ++i) {
        const double angle = 2.39996 * i;
        PresetCircle circle;
        circle.body = {
            .position = {0.7 * (i % side - 0.5 * (side - 1)), 0.7 * (i / side - 0.5 * (side - 1))},
            .velocity = {speed * std::cos(angle), speed * std::sin(angle)},
            .radius = 0.2,
            .density = 1.0};
        preset.circles.push_back(circle);
    }
    return preset;
}

/// The histogram beside a run.
struct Shown {
    Simulation simulation;
    SpeedHistogram histogram{simulation};

    explicit Shown(const Preset &preset)
        : simulation(preset)
    {
        histogram.resize(344, 240);
        histogram.show();
        (void)QTest::qWaitForWindowExposed(&histogram, patience);
    }
    [[nodiscard]] const SpeedPicture &picture() const { return histogram.plot().picture(); }
};

} // namespace

class TestSpeedHistogram final : public QObject
{
    Q_OBJECT
private slots:
    void keysGoFromBarToBar();
    void speedsFallIntoTheirBins();
    void binsAreAMeanOverMoments();
    void temperatureIsTheMeanEnergy();
    void curveIntegratesToOne_data();
    void curveIntegratesToOne();
    void curveIsHighestAtItsSpread();
    void distanceMatchesHandWorkedCase();
    void distanceOfTheCurveItselfIsSmall();
    void unequalMassesAreScaled();
    void chanceAllowsLessForMore();
    void gasComesToEquilibrium();
    void barsAreThoseOfTheLastSecond();
    void tooFewCirclesSayWhatToDo();
    void nothingMovesSaysSo();
};

void TestSpeedHistogram::keysGoFromBarToBar()
{
    Shown shown(equallyFast(8, 1.05));
    shown.simulation.goTo(0);
    auto *plot = shown.histogram.findChild<SpeedPlot *>();
    QTRY_VERIFY(plot->showsRun());
    QVERIFY(plot->told().isEmpty());
    // All 64 are as fast: one bar has all of them, and the others none.
    const SpeedPicture picture = shown.picture();
    const auto full = std::find(picture.shares.begin(), picture.shares.end(), 1.0);
    QVERIFY(full != picture.shares.end());
    const auto index = full - picture.shares.begin();
    for (std::ptrdiff_t i = 0; i <= index; ++i)
        QTest::keyClick(plot, Qt::Key_Down);
    const double low = picture.binWidth * static_cast<double>(index);
    QVERIFY2(plot->told().contains(QStringLiteral("100.0 %, the curve ")),
             qPrintable(plot->told()));
    QVERIFY(low <= 1.05 && 1.05 < low + picture.binWidth);
    QVERIFY(plot->accessibleDescription().startsWith(plot->told() + QStringLiteral(". Not in")));
    QTest::keyClick(plot, Qt::Key_Up);
    QVERIFY2(plot->told().contains(QStringLiteral(": 0 %")), qPrintable(plot->told()));
    for (int i = 0; i < 100; ++i)
        QTest::keyClick(plot, Qt::Key_Up);
    QVERIFY2(plot->told().startsWith(QLatin1String("0")), qPrintable(plot->told()));
    QSignalSpy played(&shown.histogram, &SpeedHistogram::curvePlayed);
    QTest::keyClick(plot, Qt::Key_Return);
    QCOMPARE(played.size(), 1);
    QCOMPARE(played[0][0].value<std::vector<double>>(), picture.shares);
}

void TestSpeedHistogram::speedsFallIntoTheirBins()
{
    const auto circles = moving({0.0, 0.49, 0.5, 1.2, 1.3, 1.4, 2.0, 7.0});
    SpeedBins bins(0.5, 4);
    bins.add(circles, gasState(circles));
    // [0, 0.5), [0.5, 1), [1, 1.5), [1.5, 2); two of the eight are faster.
    QCOMPARE(bins.shares(), (std::vector<double>{0.25, 0.125, 0.375, 0.0}));
    QCOMPARE(bins.shareBeyond(), 0.25);
}

void TestSpeedHistogram::binsAreAMeanOverMoments()
{
    const auto before = moving({0.1, 0.1});
    const auto after = moving({0.1, 0.9});
    SpeedBins bins(0.5, 2);
    bins.add(before, gasState(before));
    bins.add(after, gasState(after));
    QCOMPARE(bins.shares(), (std::vector<double>{0.75, 0.25}));
}

void TestSpeedHistogram::temperatureIsTheMeanEnergy()
{
    const auto circles = moving({1.0, 2.0, 3.0});
    const GasState gas = gasState(circles);
    const double m = 1000.0 * 4.0 / 3.0 * pi * 0.008;
    QVERIFY(std::abs(gas.temperature - 0.5 * m * 14.0 / 3.0) < 1e-9);
    QVERIFY(std::abs(gas.meanMass - m) < 1e-9);
    // σ² = ⟨v²⟩ / 2
    QVERIFY(std::abs(gas.spread() - std::sqrt(7.0 / 3.0)) < 1e-12);
    QVERIFY(!gas.isMixed);
}

void TestSpeedHistogram::curveIntegratesToOne_data()
{
    QTest::addColumn<double>("spread");
    for (const double spread : {0.01, 1.0, 1.5, 300.0})
        QTest::addRow("%g m/s", spread) << spread;
}

void TestSpeedHistogram::curveIntegratesToOne()
{
    QFETCH(double, spread);
    constexpr int steps = 20'000;
    const double width = 10.0 * spread / steps;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
        sum += width * maxwellDensity((i + 0.5) * width, spread);
    QVERIFY2(std::abs(sum - 1.0) < 1e-6, qPrintable(QString::number(sum, 'g', 12)));
    // And up to any speed to the share that is slower: 1 − e^(−1/2) at σ.
    double below = 0.0;
    for (int i = 0; i < steps / 10; ++i)
        below += width * maxwellDensity((i + 0.5) * width, spread);
    QVERIFY(std::abs(below - 0.3934693402873666) < 1e-6);
    QVERIFY(std::abs(maxwellShareBelow(spread, spread) - 0.3934693402873666) < 1e-12);
}

void TestSpeedHistogram::curveIsHighestAtItsSpread()
{
    const double top = maxwellDensity(1.4, 1.4);
    QVERIFY(std::abs(top - std::exp(-0.5) / 1.4) < 1e-12);
    QVERIFY(top > maxwellDensity(1.39, 1.4));
    QVERIFY(top > maxwellDensity(1.41, 1.4));
    QCOMPARE(maxwellDensity(0.0, 1.4), 0.0);
}

void TestSpeedHistogram::distanceMatchesHandWorkedCase()
{
    // All equally fast: kT = ½ m v², so σ² = v²/2, and 1 − e⁻¹ should be slower where none is.
    const auto circles = moving(std::vector<double>(50, 2.0));
    QVERIFY(std::abs(distanceFromMaxwell(circles) - (1.0 - std::exp(-1.0))) < 1e-12);
    QCOMPARE(distanceFromMaxwell(moving({0.0, 0.0})), 1.0);
}

void TestSpeedHistogram::distanceOfTheCurveItselfIsSmall()
{
    // The quantiles lie in the middle of the rises: half a rise away, and σ is a little less.
    const double distance = distanceFromMaxwell(moving(quantiles(1000, 1.4)));
    QVERIFY2(distance < 0.002, qPrintable(QString::number(distance)));
}

void TestSpeedHistogram::unequalMassesAreScaled()
{
    // Each kind at the temperature of the other: four times the mass, half the speed.
    auto circles = moving(quantiles(500, 2.0), 1.0);
    const auto heavy = moving(quantiles(500, 1.0), 4.0);
    circles.insert(circles.end(), heavy.begin(), heavy.end());
    const GasState gas = gasState(circles);
    QVERIFY(gas.isMixed);
    QVERIFY(std::abs(scaledSpeed(circles[10], gas) - scaledSpeed(circles[510], gas)) < 1e-12);
    QVERIFY(distanceFromMaxwell(circles) < 0.004);
}

void TestSpeedHistogram::chanceAllowsLessForMore()
{
    // Stephens' 1.308 of √N: 1.308 / (31.6228 + 0.26 + 0.0158) + 0.0002
    QVERIFY(std::abs(distanceByChance(1000) - 0.041205) < 1e-6);
    QVERIFY(distanceByChance(20) > distanceByChance(100));
    QVERIFY(distanceByChance(0) <= 1.0);
}

void TestSpeedHistogram::gasComesToEquilibrium()
{
    Shown shown(equallyFast(15, 2.0));
    QTRY_VERIFY(shown.histogram.plot().showsRun());
    const auto circlesNow = [&] {
        return shown.simulation.recording().circles(shown.simulation.current());
    };
    const double start = distanceFromMaxwell(circlesNow());
    QVERIFY(std::abs(start - (1.0 - std::exp(-1.0))) < 1e-9);
    QVERIFY(shown.histogram.sentence().startsWith(QStringLiteral("Not in equilibrium")));
    run(shown.simulation, 180);
    const double end = distanceFromMaxwell(circlesNow());
    QVERIFY2(end < distanceByChance(225), qPrintable(QString::number(end)));
    QVERIFY(shown.histogram.sentence().startsWith(QStringLiteral("In equilibrium")));
    QTRY_VERIFY(shown.histogram.plot().accessibleDescription() == shown.histogram.sentence());
    // Back at the start it is far from it again.
    shown.simulation.seek(0);
    QVERIFY(shown.histogram.sentence().startsWith(QStringLiteral("Not in equilibrium")));
}

void TestSpeedHistogram::barsAreThoseOfTheLastSecond()
{
    Preset preset = equallyFast(5, 2.05);
    preset.laws = {}; // they keep their speed for ever
    Shown shown(preset);
    QTRY_VERIFY(shown.histogram.plot().showsRun());
    const auto onlyBin = [&] {
        const auto &shares = shown.picture().shares;
        return shares.at(static_cast<std::size_t>(2.05 / shown.picture().binWidth));
    };
    QCOMPARE(onlyBin(), 1.0);
    run(shown.simulation, 120);
    settle();
    QCOMPARE(onlyBin(), 1.0);
    const auto &shares = shown.picture().shares;
    QCOMPARE(std::accumulate(shares.begin(), shares.end(), 0.0), 1.0);
    QVERIFY(std::abs(shown.picture().spread - 2.05 / std::numbers::sqrt2) < 1e-9);
    QVERIFY(!shown.histogram.grab().isNull());
}

void TestSpeedHistogram::tooFewCirclesSayWhatToDo()
{
    Shown shown(glancing());
    QTRY_VERIFY(shown.histogram.plot().emptyText().contains(QStringLiteral("Example scenes")));
    QVERIFY(!shown.histogram.plot().showsRun());
    QVERIFY(!shown.histogram.plot().accessibleName().isEmpty());
    QVERIFY(!shown.histogram.grab().isNull());
}

void TestSpeedHistogram::nothingMovesSaysSo()
{
    Shown shown(equallyFast(5, 0.0));
    QTRY_COMPARE(shown.histogram.plot().emptyText(),
                 QStringLiteral("Nothing moves yet: press Run"));
}

QTEST_MAIN(TestSpeedHistogram)

#include "test_speed_histogram.moc"
