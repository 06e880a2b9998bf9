// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes.h"

#include <utility>

using namespace cradle;
using namespace cradle::scenes;

namespace {

constexpr double speed = 3.0;        ///< m/s, of a towards b
constexpr double parameter = 0.5;    ///< impact parameter b over R, the sum of the radii
constexpr double allowed = 1e-12;    ///< m/s and s, whatever the phase
constexpr int phases = 101;          ///< places in the step at which they meet
constexpr int meetingStep = 20;      ///< they meet within or just after it
constexpr Vec2 drift{0.625, -1.125}; ///< m/s, of both

/// a at 3 m/s along \p way towards b, beside the line of its centre by half of R, and both drift.
/// The centres' line is then turned from the way by φ with sin φ = b/R = ½, so cos φ = √¾.
struct Scattering {
    double radiusA = 0.2;
    double radiusB = 0.2;
    double densityB = 7.8;
    Vec2 way{1, 0};
    Vec2 drift{};

    [[nodiscard]] double distance() const { return radiusA + radiusB; } ///< R, m
    [[nodiscard]] double along() const                                  ///< R cos φ, m
    {
        return std::sqrt(1.0 - parameter * parameter) * distance();
    }
    /// The unit vector from a to b when they touch.
    [[nodiscard]] Vec2 normal() const
    {
        return (along() * way + parameter * distance() * perpendicular(way)) / distance();
    }
    /// They meet after \p time s, counted from the start.
    [[nodiscard]] Preset preset(double time, double restitution, Timing timing) const
    {
        const Vec2 start =
            -(speed * time + along()) * way - (parameter * distance()) * perpendicular(way);
        Preset p = scene({circle(start, speed * way + drift, radiusA),
                          circle({0, 0}, drift, radiusB, Integrator::Verlet, densityB)},
                         {WallLaw::None, CircleLaw::Impulse, timing});
        p.restitution = restitution;
        return p;
    }
    /// The velocities after the hit, from conserved momentum and Newton's restitution law:
    ///     v_a' = v_a − (1 + e) μ/m_a u n,   v_b' = v_b + (1 + e) μ/m_b u n,   u = v cos φ
    [[nodiscard]] std::pair<Vec2, Vec2> after(double restitution) const
    {
        const double a = 7.8 * radiusA * radiusA * radiusA; // masses but for the common factor
        const double b = densityB * radiusB * radiusB * radiusB;
        const double closing = speed * along() / distance();
        const Vec2 change = ((1.0 + restitution) * closing / (a + b)) * normal();
        return {speed * way + drift - b * change, drift + a * change};
    }
};

} // namespace

/// One glancing hit of two free circles, told to rounding by a closed formula, at every phase of
/// the step.
class TestTwoBodyScattering : public QObject
{
    Q_OBJECT
private slots:
    void velocitiesAfterAreTheFormulas_data();
    void velocitiesAfterAreTheFormulas();
};

void TestTwoBodyScattering::velocitiesAfterAreTheFormulas_data()
{
    QTest::addColumn<Scattering>("scattering");
    QTest::addColumn<double>("restitution");
    QTest::addColumn<Timing>("timing");
    const std::pair<const char *, Scattering> scatterings[] = {
        {"equal masses", {}},
        {"equal masses, slanting", {.way = {0.6, -0.8}}},
        {"equal masses, drifting", {.drift = drift}},
        {"equal radii, 1 : 5", {.densityB = 39.0}},
        {"unequal radii", {.radiusA = 0.1, .radiusB = 0.35}},
        {"heavy on light", {.radiusA = 0.5, .radiusB = 0.05, .way = {0, 1}}},
    };
    for (const Timing timing : {Timing::Exact, Timing::Continuous}) {
        for (const double restitution : {1.0, 0.5}) {
            for (const auto &[name, scattering] : scatterings)
                QTest::addRow("%s, %s, e = %g", shortName(timing), name, restitution)
                    << scattering << restitution << timing;
        }
    }
}

void TestTwoBodyScattering::velocitiesAfterAreTheFormulas()
{
    QFETCH(Scattering, scattering);
    QFETCH(double, restitution);
    QFETCH(Timing, timing);
    const auto [a, b] = scattering.after(restitution);
    const Vec2 n = scattering.normal();
    for (int phase = 0; phase < phases; ++phase) {
        const double time = (meetingStep - 1 + phase / (phases - 1.0)) * dt;
        const Preset preset = scattering.preset(time, restitution, timing);
        QVERIFY(!findFault(preset).has_value());
        Run run(preset);
        run.steps(2 * meetingStep);
        QCOMPARE(run.hits.size(), std::size_t{1});
        COMPARE_NEAR(run.hits[0].time, time, allowed);
        COMPARE_NEAR(length(run.hits[0].normal - n), 0.0, allowed);
        COMPARE_NEAR(length(run[0].velocity - a), 0.0, allowed);
        COMPARE_NEAR(length(run[1].velocity - b), 0.0, allowed);
    }
}

QTEST_APPLESS_MAIN(TestTwoBodyScattering)
#include "test_two_body_scattering.moc"
