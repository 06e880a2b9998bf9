// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/preset.h"

#include "model/files/json_schema.h"
#include "model/files/preset_json.h"
#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::scenes;

using Setter = std::function<void(Preset &, double)>;

namespace {

Preset valid()
{
    return scene({circle({-1, 0}), circle({1, 0})},
                 {WallLaw::Reflect, CircleLaw::Impulse, Timing::Discrete});
}

/// Two circles without laws, so that nothing but the range of a number can be at fault.
Preset lawless()
{
    return scene({circle({-1, 0}), circle({1, 0})}, {});
}

/// Whether the schema of the file format takes what would be written of \p preset.
bool schemaTakes(const Preset &preset)
{
    return parseJson(writePreset(preset), QStringLiteral(":/schemas/preset.schema.json"), {}).ok();
}

} // namespace

/// The values of a scene and their ranges.
class TestPreset : public QObject
{
    Q_OBJECT
private slots:
    void defaultsAreThoseOfTheLab();
    void aPresetWithoutFaultHasNone();
    void numbersOutsideTheirRangeAreFaults_data();
    void numbersOutsideTheirRangeAreFaults();
    void theSchemaHasTheSameRanges_data();
    void theSchemaHasTheSameRanges();
    void theFirstFaultIsReported();
    void tooManyCirclesAreAFault();
    void whatHasNoFaultCanBeReadBack_data();
    void whatHasNoFaultCanBeReadBack();
    void theInitialWorldIsThePreset();
    void exactTimingMovesOnParabolas();
};

void TestPreset::defaultsAreThoseOfTheLab()
{
    const Preset preset;
    QCOMPARE(preset.halfWidth, 4.0);
    QCOMPARE(preset.timestep, 1.0 / 60.0);
    QCOMPARE(preset.restitution, 1.0);
    QVERIFY(preset.gravity == Vec2{});
    QVERIFY(preset.laws == (Laws{WallLaw::None, CircleLaw::None, Timing::Discrete}));
    QCOMPARE(PresetCircle{}.body.radius, 0.2);
    QCOMPARE(PresetCircle{}.body.density, 7.8);
    QCOMPARE(PresetCircle{}.colour, QStringLiteral("#1e90ff"));
}

void TestPreset::aPresetWithoutFaultHasNone()
{
    QVERIFY(!findFault(Preset{}).has_value());
    QVERIFY(!findFault(valid()).has_value());
}

void TestPreset::numbersOutsideTheirRangeAreFaults_data()
{
    QTest::addColumn<Setter>("set");
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::addColumn<QString>("pointer");
    const auto row = [](const char *name, Setter set, double low, double high,
                        const char *pointer) {
        QTest::newRow(name) << std::move(set) << low << high << QString::fromLatin1(pointer);
    };
    row(
        "half width", [](Preset &p, double v) { p.halfWidth = v; }, 1e-6, 1e4,
        "/square/half_width");
    row(
        "gravity x", [](Preset &p, double v) { p.gravity.x = v; }, -1e4, 1e4, "/gravity/0");
    row(
        "gravity y", [](Preset &p, double v) { p.gravity.y = v; }, -1e4, 1e4, "/gravity/1");
    row(
        "restitution", [](Preset &p, double v) { p.restitution = v; }, 0.0, 1.0, "/restitution");
    row(
        "timestep", [](Preset &p, double v) { p.timestep = v; }, 1e-6, 0.1, "/timestep");
    row(
        "position x", [](Preset &p, double v) { p.circles[0].body.position.x = v; }, -1e4, 1e4,
        "/circles/0/position/0");
    row(
        "position y", [](Preset &p, double v) { p.circles[1].body.position.y = v; }, -1e4, 1e4,
        "/circles/1/position/1");
    row(
        "velocity x", [](Preset &p, double v) { p.circles[1].body.velocity.x = v; }, -1e7, 1e7,
        "/circles/1/velocity/0");
    row(
        "velocity y", [](Preset &p, double v) { p.circles[0].body.velocity.y = v; }, -1e7, 1e7,
        "/circles/0/velocity/1");
    row(
        "radius", [](Preset &p, double v) { p.circles[1].body.radius = v; }, 1e-6, 1e4,
        "/circles/1/radius");
    row(
        "density", [](Preset &p, double v) { p.circles[0].body.density = v; }, 1e-9, 1e9,
        "/circles/0/density");
}

void TestPreset::numbersOutsideTheirRangeAreFaults()
{
    QFETCH(Setter, set);
    QFETCH(double, low);
    QFETCH(double, high);
    QFETCH(QString, pointer);
    for (const double right : {low, high, 0.5 * (low + high)}) {
        Preset preset = lawless();
        set(preset, right);
        const std::optional<Error> fault = findFault(preset);
        QVERIFY2(!fault, fault ? qPrintable(fault->toString()) : "");
    }
    for (const double wrong : {std::nextafter(low, -infinity), std::nextafter(high, infinity),
                               low - 1.0, 10.0 * high, infinity, -infinity, notANumber}) {
        Preset preset = lawless();
        set(preset, wrong);
        const std::optional<Error> fault = findFault(preset);
        QVERIFY2(fault, QByteArray::number(wrong, 'g', 17).constData());
        QCOMPARE(fault->pointer, pointer);
        QVERIFY2(fault->message.contains(QStringLiteral("is right")), qPrintable(fault->message));
    }
}

void TestPreset::theSchemaHasTheSameRanges_data()
{
    numbersOutsideTheirRangeAreFaults_data();
}

void TestPreset::theSchemaHasTheSameRanges()
{
    QFETCH(Setter, set);
    QFETCH(double, low);
    QFETCH(double, high);
    for (const double right : {low, high, std::nextafter(low, high), std::nextafter(high, low)}) {
        Preset preset = lawless();
        set(preset, right);
        QVERIFY2(schemaTakes(preset), QByteArray::number(right, 'g', 17).constData());
    }
    for (const double wrong : {std::nextafter(low, -infinity), std::nextafter(high, infinity)}) {
        Preset preset = lawless();
        set(preset, wrong);
        QVERIFY2(!schemaTakes(preset), QByteArray::number(wrong, 'g', 17).constData());
    }
}

void TestPreset::theFirstFaultIsReported()
{
    Preset preset = valid();
    preset.circles[1].body.radius = -1.0;
    preset.restitution = 2.0;
    preset.timestep = notANumber;
    const std::optional<Error> fault = findFault(preset);
    QVERIFY(fault.has_value());
    QCOMPARE(fault->pointer, QStringLiteral("/restitution"));
    QVERIFY2(fault->message.contains(QLatin1Char('2')), qPrintable(fault->message));
}

void TestPreset::tooManyCirclesAreAFault()
{
    Preset preset;
    preset.circles.resize(100'000);
    QVERIFY(!findFault(preset).has_value());
    preset.circles.resize(100'001);
    const std::optional<Error> fault = findFault(preset);
    QVERIFY(fault.has_value());
    QCOMPARE(fault->pointer, QStringLiteral("/circles"));
    QVERIFY(fault->message.contains(QStringLiteral("100000")));
}

void TestPreset::whatHasNoFaultCanBeReadBack_data()
{
    QTest::addColumn<Preset>("preset");
    QTest::newRow("a plain scene") << valid();
    Preset preset = valid();
    preset.name = QString(200, QLatin1Char('x'));
    QTest::newRow("the longest name") << preset;
    preset.name = QString(201, QLatin1Char('x'));
    QTest::newRow("too long a name") << preset;
    preset = valid();
    preset.circles[1].name = QString(201, QLatin1Char('x'));
    QTest::newRow("too long a name of a circle") << preset;
    preset = valid();
    preset.circles[1].colour = QStringLiteral("red");
    QTest::newRow("a colour by its name") << preset;
}

void TestPreset::whatHasNoFaultCanBeReadBack()
{
    QFETCH(Preset, preset);
    QCOMPARE(findFault(preset).has_value(), !schemaTakes(preset));
}

void TestPreset::theInitialWorldIsThePreset()
{
    const World world = initialWorld(valid());
    QCOMPARE(world.time, 0.0);
    QCOMPARE(world.step, qint64{0});
    QCOMPARE(world.circles.size(), std::size_t{2});
    QVERIFY(world.circles[1] == valid().circles[1].body);
}

void TestPreset::exactTimingMovesOnParabolas()
{
    Preset preset = valid();
    preset.circles[0].integrator = Integrator::Euler;
    preset.circles[1].integrator = Integrator::RungeKutta4;
    preset.gravity = {1, -2};
    preset.restitution = 0.5;
    Rules rules = rulesOf(preset);
    QVERIFY(rules.integrators == (std::vector{Integrator::Euler, Integrator::RungeKutta4}));
    QVERIFY(rules.gravity == (Vec2{1, -2}));
    QCOMPARE(rules.restitution, 0.5);
    QCOMPARE(rules.halfWidth, 4.0);
    QVERIFY(rules.laws == preset.laws);
    preset.laws.timing = Timing::Exact;
    rules = rulesOf(preset);
    for (const Integrator integrator : rules.integrators)
        QCOMPARE(pathCurvature(integrator), 0.5);
}

QTEST_GUILESS_MAIN(TestPreset)
#include "test_preset.moc"
