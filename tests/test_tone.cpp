// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/patience.h"
#include "views/sound/tone.h"

#include "views/sound/hit_sounds.h"

#include <QTest>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

/// What hits and curves sound like: the samples alone, no device.
class TestTone : public QObject
{
    Q_OBJECT
private slots:
    void heavierIsLower();
    void harderIsLouder();
    void samplesHaveFrequencyAndAmplitude_data();
    void samplesHaveFrequencyAndAmplitude();
    void tonesTogetherAddUpWithinBounds();
    void curveRisesByOctaves();
    void curveWithoutValuesIsSilent();
    void runStrikesTheTonesOfItsHits();
    void silentUntilTurnedOn();
};

using namespace cradle;

namespace {

/// How much of \p frequency is in the samples from \p begin to \p end: Goertzel's sum, as a Fourier
/// integral.
double share(const std::vector<float> &samples, std::size_t begin, std::size_t end,
             double frequency)
{
    double re = 0.0;
    double im = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
        const double angle = 2.0 * std::numbers::pi * frequency * static_cast<double>(i) / 44100.0;
        re += static_cast<double>(samples[i]) * std::cos(angle);
        im += static_cast<double>(samples[i]) * std::sin(angle);
    }
    return std::hypot(re, im);
}

/// Upward zero crossings a second.
double pitch(const std::vector<float> &samples, std::size_t begin, std::size_t end)
{
    int crossings = 0;
    for (std::size_t i = begin + 1; i < end; ++i)
        crossings += samples[i - 1] < 0.0F && samples[i] >= 0.0F ? 1 : 0;
    return crossings * 44100.0 / static_cast<double>(end - begin);
}

double peak(const std::vector<float> &samples)
{
    double most = 0.0;
    for (const float sample : samples)
        most = std::max(most, std::abs(static_cast<double>(sample)));
    return most;
}

} // namespace

void TestTone::heavierIsLower()
{
    // A steel ball of 0.2 m: 7800 · 4/3 π 0.008 = 261.38 kg.
    const double steel = 7800.0 * 4.0 / 3.0 * std::numbers::pi * 0.008;
    QVERIFY(std::abs(toneOf(steel, 1.0).frequency - 440.0) < 0.01);
    // Eight times as heavy is twice as large, and an octave lower.
    QVERIFY(std::abs(toneOf(8.0 * steel, 1.0).frequency - 220.0) < 0.01);
    QVERIFY(std::abs(toneOf(steel / 8.0, 1.0).frequency - 880.0) < 0.01);
    QCOMPARE(toneOf(1e12, 1.0).frequency, 110.0);
    QCOMPARE(toneOf(1e-12, 1.0).frequency, 3520.0);
}

void TestTone::harderIsLouder()
{
    QCOMPARE(toneOf(1.0, 0.0).amplitude, 0.0);
    QCOMPARE(toneOf(1.0, 500.0).amplitude, 0.25);
    QCOMPARE(toneOf(1.0, -500.0).amplitude, 0.25);
    QCOMPARE(toneOf(9.0, 1500.0).amplitude, 0.375); // whatever the mass
    QVERIFY(toneOf(1.0, 1e9).amplitude <= 0.5);
}

void TestTone::samplesHaveFrequencyAndAmplitude_data()
{
    QTest::addColumn<double>("frequency");
    QTest::addColumn<double>("amplitude");
    QTest::newRow("low, loud") << 220.0 << 0.5;
    QTest::newRow("middle") << 440.0 << 0.25;
    QTest::newRow("high, quiet") << 1760.0 << 0.01;
}

void TestTone::samplesHaveFrequencyAndAmplitude()
{
    QFETCH(double, frequency);
    QFETCH(double, amplitude);
    const std::vector<float> samples = samplesOf(Tone{frequency, amplitude});
    QCOMPARE(samples.size(), std::size_t{17640}); // 0.4 s
    // Whole periods of all three within 0.1 s.
    QVERIFY(std::abs(pitch(samples, 0, 4410) - frequency) <= 10.0);
    const double own = share(samples, 0, 4410, frequency);
    for (const double other : {frequency / 2.0, frequency * 1.5, frequency * 2.0})
        QVERIFY2(own > 5.0 * share(samples, 0, 4410, other), qPrintable(QString::number(other)));
    // The envelope is at 1 within 2 ms and falls to 1/e in 80 ms.
    QVERIFY(peak(samples) <= amplitude);
    QVERIFY(peak(samples) > 0.9 * amplitude);
    QCOMPARE(samples.front(), 0.0F);
    const std::vector<float> later(samples.begin() + 3528, samples.begin() + 3528 + 441);
    QVERIFY(std::abs(peak(later) / amplitude - std::exp(-1.0)) < 0.04);
    const std::vector<float> last(samples.end() - 441, samples.end());
    QVERIFY(peak(last) < 0.01 * amplitude);
}

void TestTone::tonesTogetherAddUpWithinBounds()
{
    const Tone low{220.0, 0.3};
    const Tone high{880.0, 0.3};
    const std::array both{low, high};
    const std::vector<float> sum = samplesOf(both);
    const std::vector<float> a = samplesOf(low);
    const std::vector<float> b = samplesOf(high);
    for (std::size_t i = 0; i < sum.size(); ++i)
        QCOMPARE(sum[i], a[i] + b[i]);
    const std::array many{Tone{440.0, 0.5}, Tone{440.0, 0.5}, Tone{440.0, 0.5}};
    QCOMPARE(peak(samplesOf(many)), 1.0);
    QVERIFY(samplesOf(std::span<const Tone>()).empty());
}

void TestTone::curveRisesByOctaves()
{
    // Least, middle, greatest and nothing: 220, 440 and 880 Hz for half a second each.
    const std::array values{-3.0, 1.0, 5.0, std::numeric_limits<double>::quiet_NaN()};
    const std::vector<float> samples = samplesOfCurve(values);
    QCOMPARE(samples.size(), std::size_t{88200});
    QVERIFY(std::abs(pitch(samples, 0, 22050) - 220.0) <= 2.0);
    QVERIFY(std::abs(pitch(samples, 22050, 44100) - 440.0) <= 2.0);
    QVERIFY(std::abs(pitch(samples, 44100, 66150) - 880.0) <= 2.0);
    for (std::size_t i = 66150; i < samples.size(); ++i)
        QCOMPARE(samples[i], 0.0F);
    const std::array level{7.0, 7.0};
    QVERIFY(std::abs(pitch(samplesOfCurve(level), 0, 44100) - 440.0) <= 1.0);
}

void TestTone::curveWithoutValuesIsSilent()
{
    QVERIFY(samplesOfCurve({}).empty());
    const std::array none{std::numeric_limits<double>::infinity()};
    QVERIFY(samplesOfCurve(none).empty());
}

namespace {

/// Circle 1, 8 times as heavy as circle 2, runs into it; hand-made so that they meet before the
/// wall.
Preset meeting()
{
    Preset preset;
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous};
    preset.circles = {
        {QStringLiteral("heavy"), {.position = {-1.0, 0.0}, .velocity = {2.0, 0.0}, .radius = 0.4}},
        {QStringLiteral("light"), {.position = {1.0, 0.0}, .radius = 0.2}}};
    return preset;
}

} // namespace

void TestTone::runStrikesTheTonesOfItsHits()
{
    Simulation simulation(meeting());
    HitSounds sounds(simulation);
    sounds.setOn(true);
    std::vector<std::vector<Tone>> struck;
    connect(&sounds, &HitSounds::struck, this,
            [&](const std::vector<Tone> &tones) { struck.push_back(tones); });
    // The gap of 1.4 m closes in 0.7 s: after step 42 of 1/60 s.
    for (int i = 0; i < 50; ++i)
        simulation.stepForward();
    QCOMPARE(struck.size(), std::size_t{1});
    QCOMPARE(struck[0].size(), std::size_t{2});
    const double light = 7800.0 * 4.0 / 3.0 * std::numbers::pi * 0.008;
    // J = (1 + e) μ Δv = 2 · 8m/9 · 2 m/s.
    const double impulse = 2.0 * 8.0 * light / 9.0 * 2.0;
    const double amplitude = 0.5 * impulse / (impulse + 500.0);
    for (std::size_t i = 0; i < 2; ++i)
        QVERIFY(std::abs(struck[0][i].amplitude - amplitude) < 1e-9);
    QVERIFY(std::abs(struck[0][0].frequency - 220.0) < 0.01);
    QVERIFY(std::abs(struck[0][1].frequency - 440.0) < 0.01);
    // Standing at it again is hearing it again.
    simulation.seek(0);
    simulation.seekNextHit();
    QTRY_COMPARE(struck.size(), std::size_t{2});
}

void TestTone::silentUntilTurnedOn()
{
    Simulation simulation(meeting());
    HitSounds sounds(simulation);
    bool heard = false;
    connect(&sounds, &HitSounds::struck, this, [&] { heard = true; });
    for (int i = 0; i < 50; ++i)
        simulation.stepForward();
    QVERIFY(!heard);
}

QTEST_GUILESS_MAIN(TestTone)
#include "test_tone.moc"
