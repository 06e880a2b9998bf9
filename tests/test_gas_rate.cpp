// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes.h"

#include <algorithm>

using namespace cradle;
using namespace cradle::scenes;

namespace {

constexpr int discs = 1000;
constexpr double radius = 0.2;             ///< m
constexpr double fraction = 0.2;           ///< of the square's area that discs cover
constexpr double rmsSpeed = 2.0;           ///< m/s
constexpr double finestStep = 1.0 / 240.0; ///< s

/// The gas at random places, at 2 m/s. Its flight is straight with any integrator; with symplectic
/// Euler continuous timing moves it step by step.
Preset gas(Timing timing, qint64 seed)
{
    Preset preset = scene({}, {WallLaw::Reflect, CircleLaw::Impulse, timing});
    preset.timestep = finestStep;
    preset.halfWidth = 0.5 * std::sqrt(discs * pi * radius * radius / fraction);
    preset.fill = CircleFill{.count = discs, .radius = radius, .rmsSpeed = rmsSpeed, .seed = seed};
    preset.circles = *makeCircles(*preset.fill, preset.halfWidth);
    for (PresetCircle &c : preset.circles)
        c.integrator = Integrator::SymplecticEuler;
    return preset;
}

/// Hits of two discs per second (1/s), in all, that kinetic theory expects of the gas.
///
/// In the bulk, at the number density n, covered fraction φ = n π r² and contact value χ of the
/// pair correlation, a disc of diameter d is hit
///     ν = 2 d n χ √(π k T/m)          (Enskog),   k T/m = ⟨v²⟩/2
///     χ = (1 − 7 φ/16)/(1 − φ)²       (Henderson),   p = n k T (1 + 2 φ χ)
/// times a second. Hard walls change that near them. Two exact statements sum it up:
/// - The wall feels the bulk's pressure on the accessible area A_c = (L − d)². By the virial
///   theorem 2 p A_c = 2 N k T + d Σ|J|/time, and a hit exchanges on average m √(π k T/m). So
///     hits/time = 2 (p A_c/(k T) − N) √(k T/m)/(d √π)
///   which without walls is ½ N ν.
/// - n follows from N = n A + 4 L Γ with the adsorption Γ = −∂γ/∂μ on a wall, where the tension is
///       γ/(k T) = [φ/(1 − φ) + (1 − 8/(3π)) φ²/(1 − φ)²]/(π r)
///   Its first term is scaled particle theory's. The second makes the order n² exact, which is the
///   crowd that the shadow of the wall draws: ∫ (segment of a disc of radius d, cut at z) dz = ⅔
///   d³. With ∂μ/∂φ = k T (1 + φ)/(φ (1 − φ)³)
///       Γ = −n r (1 − φ)/(1 + φ) (1 + (2 − 16/(3π)) φ/(1 − φ))
///   (for φ → 0 the strip of width r that no centre enters).
/// What is neglected, corners and wall layers that meet, is of the order (d/L)² = 2.5e-4,
/// and what is left of Γ's error is some 0.3 % of the rate.
/// Sources: Chapman, Cowling: Mathematical Theory of Non-uniform Gases, ch. 16; Henderson: A
/// simple equation of state for hard discs, Mol. Phys. 30, 971 (1975); Helfand, Frisch,
/// Lebowitz: Theory of the two- and one-dimensional rigid sphere fluids, J. Chem. Phys. 34, 1037
/// (1961).
double expectedRate(double halfWidthOfBox)
{
    const double side = 2.0 * halfWidthOfBox;
    const double d = 2.0 * radius;
    double n = discs / (side * side);
    for (int i = 0; i < 50; ++i) { // a contraction by about d/L
        const double phi = n * pi * radius * radius;
        const double strip = radius * (1.0 - phi) / (1.0 + phi)
                             * (1.0 + (2.0 - 16.0 / (3.0 * pi)) * phi / (1.0 - phi));
        n = discs / (side * side - 4.0 * side * strip);
    }
    const double phi = n * pi * radius * radius;
    const double chi = (1.0 - 7.0 / 16.0 * phi) / ((1.0 - phi) * (1.0 - phi));
    const double pressure = n * (1.0 + 2.0 * phi * chi); // over k T
    const double thermalSpeed = rmsSpeed / std::sqrt(2.0);
    const double accessible = (side - d) * (side - d);
    return 2.0 * (pressure * accessible - discs) * thermalSpeed / (d * std::sqrt(pi));
}

/// Hits of two discs per second, and the standard deviation of that mean.
struct Rate {
    double mean = 0.0;
    double sigma = 0.0;
};

/// Long enough for a difference of 0.5 % of two rates: a part has 2300 ± 49 hits (as many as
/// Poisson's law gives), so the mean is good to 0.14 %, a difference of two to 0.19 %.
constexpr int parts = 250;

/// Measured over parts of one second each, after the gas has forgotten its start: 5 s, some 20 hits
/// a disc. The deviation is that of the parts' mean.
Rate measuredRate(Timing timing)
{
    Run run(gas(timing, 11));
    const int second = static_cast<int>(std::lround(1.0 / finestStep));
    run.steps(5 * second);
    double sum = 0.0;
    double squares = 0.0;
    for (int part = 0; part < parts; ++part) {
        run.hits.clear();
        run.steps(second);
        const auto count =
            static_cast<double>(std::count_if(run.hits.begin(), run.hits.end(), [](const Hit &hit) {
                return hit.kind == Hit::Kind::Circle;
            }));
        sum += count;
        squares += count * count;
    }
    const double mean = sum / parts;
    const double variance = (squares - sum * mean) / (parts - 1);
    return {mean, std::sqrt(variance / parts)};
}

} // namespace

/// The gas of elastic discs: its rate of hits is known from theory, and no timing may change it.
/// Sigmas: 0.14 % for the rate itself, 0.19 % for the difference of two.
class TestGasRate : public QObject
{
    Q_OBJECT
private slots:
    void exactRateIsEnskogs();
    void continuousRateIsTheExactOne();

private:
    Rate m_exact{};
};

void TestGasRate::exactRateIsEnskogs()
{
    m_exact = measuredRate(Timing::Exact);
    const double expected = expectedRate(gas(Timing::Exact, 11).halfWidth);
    qInfo("%.1f hits/s, sigma %.1f; expected %.1f: off by %.2f %%", m_exact.mean, m_exact.sigma,
          expected, 100.0 * (m_exact.mean / expected - 1.0));
    COMPARE_NEAR(m_exact.mean / expected, 1.0, 0.01);
}

void TestGasRate::continuousRateIsTheExactOne()
{
    const Rate continuous = measuredRate(Timing::Continuous);
    const double sigma = std::hypot(m_exact.sigma, continuous.sigma) / m_exact.mean;
    qInfo("%.1f hits/s, sigma %.1f: off by %.2f %%", continuous.mean, continuous.sigma,
          100.0 * (continuous.mean / m_exact.mean - 1.0));
    QVERIFY(2.5 * sigma < 0.005);
    COMPARE_NEAR(continuous.mean / m_exact.mean, 1.0, 0.005);
}

QTEST_APPLESS_MAIN(TestGasRate)
#include "test_gas_rate.moc"
