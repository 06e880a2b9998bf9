// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/preset_json.h"

#include "tests/scene_files.h"
#include "tests/scenes.h"

#include <QDir>
#include <QFileInfo>

using namespace cradle;
using namespace cradle::scenes;

/// What a scene file says is what is read, and what is written reads back the same.
class TestPresetJson : public QObject
{
    Q_OBJECT
private slots:
    void readsEveryKey();
    void whatIsLeftOutHasItsDefault();
    void readsEveryLaw_data();
    void readsEveryLaw();
    void readsEveryIntegrator_data();
    void readsEveryIntegrator();
    void goodFilesAreRead_data();
    void goodFilesAreRead();
    void goodFilesRoundTrip_data();
    void goodFilesRoundTrip();
    void aFillIsMadeAndKept();
    void timingNamesReadBack();
};

void TestPresetJson::readsEveryKey()
{
    const Result<Preset> preset = readPreset(fixture(QStringLiteral("good/full")));
    QVERIFY2(preset.ok(), preset ? "" : qPrintable(preset.error().toString()));
    QCOMPARE(preset->name, QStringLiteral("Glancing hit"));
    QCOMPARE(preset->halfWidth, 4.0);
    QVERIFY(preset->gravity == (Vec2{0, -9.81}));
    QCOMPARE(preset->restitution, 0.75);
    QCOMPARE(preset->timestep, 1.0 / 60.0);
    QVERIFY(preset->laws == (Laws{WallLaw::Reflect, CircleLaw::Impulse, Timing::Exact}));
    QVERIFY(!preset->fill.has_value());
    QCOMPARE(preset->circles.size(), std::size_t{2});
    const PresetCircle &second = preset->circles[1];
    QCOMPARE(preset->circles[0].name, QStringLiteral("circle 1"));
    QVERIFY(preset->circles[0].body.position == (Vec2{-2, 2.3}));
    QVERIFY(preset->circles[0].body.velocity == (Vec2{2, 0}));
    QVERIFY(preset->circles[0].integrator == Integrator::Euler);
    QVERIFY(second.body == (Circle{{2, 2}, {0, 0}, 0.252, 1.5}));
    QCOMPARE(second.colour, QStringLiteral("#FF0000"));
    QVERIFY(second.integrator == Integrator::RungeKutta4);
}

void TestPresetJson::whatIsLeftOutHasItsDefault()
{
    const Result<Preset> preset = readPreset(fixture(QStringLiteral("good/minimal")));
    QVERIFY(preset.ok());
    QCOMPARE(preset->halfWidth, 4.0);
    QVERIFY(preset->gravity == Vec2{});
    QCOMPARE(preset->restitution, 1.0);
    QCOMPARE(preset->timestep, 1.0 / 60.0);
    QVERIFY(preset->laws == (Laws{WallLaw::None, CircleLaw::None, Timing::Discrete}));
    QCOMPARE(preset->circles.size(), std::size_t{1});
    QVERIFY(preset->circles[0].body == (Circle{{1, -2}, {0, 0}, 0.2, 7.8}));
    QCOMPARE(preset->circles[0].name, QStringLiteral("circle 1"));
    QCOMPARE(preset->circles[0].colour, QStringLiteral("#1e90ff"));
    QVERIFY(preset->circles[0].integrator == Integrator::Euler);
}

void TestPresetJson::readsEveryLaw_data()
{
    QTest::addColumn<QByteArray>("laws");
    QTest::addColumn<WallLaw>("walls");
    QTest::addColumn<CircleLaw>("circles");
    QTest::addColumn<Timing>("timing");
    const auto row = [](const char *laws, WallLaw walls, CircleLaw circles, Timing timing) {
        QTest::newRow(laws) << QByteArray(laws) << walls << circles << timing;
    };
    row(R"("walls": "none")", WallLaw::None, CircleLaw::None, Timing::Discrete);
    row(R"("walls": "reflect")", WallLaw::Reflect, CircleLaw::None, Timing::Discrete);
    row(R"("circles": "none")", WallLaw::None, CircleLaw::None, Timing::Discrete);
    row(R"("circles": "stop")", WallLaw::None, CircleLaw::Stop, Timing::Discrete);
    row(R"("circles": "swap_velocities")", WallLaw::None, CircleLaw::SwapVelocities,
        Timing::Discrete);
    row(R"("circles": "swap_normal")", WallLaw::None, CircleLaw::SwapNormal, Timing::Discrete);
    row(R"("circles": "impulse")", WallLaw::None, CircleLaw::Impulse, Timing::Discrete);
    row(R"("timing": "discrete")", WallLaw::None, CircleLaw::None, Timing::Discrete);
    row(R"("timing": "continuous")", WallLaw::None, CircleLaw::None, Timing::Continuous);
    row(R"("timing": "exact")", WallLaw::None, CircleLaw::None, Timing::Exact);
}

void TestPresetJson::readsEveryLaw()
{
    QFETCH(QByteArray, laws);
    QFETCH(WallLaw, walls);
    QFETCH(CircleLaw, circles);
    QFETCH(Timing, timing);
    const QByteArray text = R"({"format": 1, "laws": {)" + laws + R"(}, "circles": []})";
    const Result<Preset> preset = parsePreset(text);
    QVERIFY(preset.ok());
    QVERIFY(preset->laws == (Laws{walls, circles, timing}));
    QVERIFY(writePreset(*preset).contains(laws));
}

void TestPresetJson::readsEveryIntegrator_data()
{
    QTest::addColumn<Integrator>("integrator");
    QTest::newRow("euler") << Integrator::Euler;
    QTest::newRow("symplectic_euler") << Integrator::SymplecticEuler;
    QTest::newRow("verlet") << Integrator::Verlet;
    QTest::newRow("rk4") << Integrator::RungeKutta4;
}

void TestPresetJson::readsEveryIntegrator()
{
    QFETCH(Integrator, integrator);
    const QByteArray key = QByteArray(R"("integrator": ")") + QTest::currentDataTag() + '"';
    const Result<Preset> preset =
        parsePreset(R"({"format": 1, "circles": [{"position": [0, 0], )" + key + "}]}");
    QVERIFY(preset.ok());
    QVERIFY(preset->circles.at(0).integrator == integrator);
    QVERIFY(writePreset(*preset).contains(key));
}

void TestPresetJson::goodFilesAreRead_data()
{
    QTest::addColumn<QString>("path");
    const QFileInfoList files =
        QFileInfo(fixture(QStringLiteral("good/full"))).dir().entryInfoList(QDir::Files);
    for (const QFileInfo &file : files)
        QTest::newRow(qPrintable(file.baseName())) << file.filePath();
}

void TestPresetJson::goodFilesAreRead()
{
    QFETCH(QString, path);
    const Result<Preset> preset = readPreset(path);
    QVERIFY2(preset.ok(), preset ? "" : qPrintable(preset.error().toString()));
}

void TestPresetJson::goodFilesRoundTrip_data()
{
    goodFilesAreRead_data();
}

void TestPresetJson::goodFilesRoundTrip()
{
    QFETCH(QString, path);
    const Result<Preset> preset = readPreset(path);
    QVERIFY(preset.ok());
    const QByteArray written = writePreset(*preset);
    const Result<Preset> again = parsePreset(written);
    QVERIFY(again.ok());
    QVERIFY(*again == *preset);
    QCOMPARE(writePreset(*again), written);
}

void TestPresetJson::aFillIsMadeAndKept()
{
    const Result<Preset> preset = readPreset(fixture(QStringLiteral("good/fill")));
    QVERIFY(preset.ok());
    QVERIFY(preset->fill == (CircleFill{100, 0.05, 2.0, 1.0, 7}));
    QCOMPARE(preset->circles.size(), std::size_t{100});
    QVERIFY(writePreset(*preset).contains(
        R"("circles": {"fill": {"count": 100, "radius": 0.05, "rms_speed": 2, "density": 1, "seed": 7}})"));
}

void TestPresetJson::timingNamesReadBack()
{
    QVERIFY(timingFromName(QStringLiteral("discrete")) == Timing::Discrete);
    QVERIFY(timingFromName(QStringLiteral("continuous")) == Timing::Continuous);
    QVERIFY(timingFromName(QStringLiteral("exact")) == Timing::Exact);
    QVERIFY(!timingFromName(QStringLiteral("Exact")).has_value());
    QVERIFY(!timingFromName(QString()).has_value());
}

QTEST_GUILESS_MAIN(TestPresetJson)
#include "test_preset_json.moc"
