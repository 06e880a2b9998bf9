// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes.h"

#include <QCryptographicHash>

#include <cstring>

using namespace cradle;
using namespace cradle::scenes;

namespace {

/// Twelve circles of several sizes and densities, all integrators, walls, gravity, e = 0.9.
Preset goldenPreset(Timing timing)
{
    Preset preset = scene({}, {WallLaw::Reflect, CircleLaw::Impulse, timing});
    preset.gravity = {0, -g};
    preset.restitution = 0.9;
    for (int i = 0; i < 12; ++i) {
        const Vec2 position{-3.0 + 2.0 * (i % 4), -1.0 + 2.0 * (i / 4)};
        const Vec2 velocity{1.5 - 0.75 * (i % 5), -1.0 + 0.5 * (i % 7)};
        preset.circles.push_back(circle(position, velocity, 0.2 + 0.05 * (i % 3),
                                        allIntegrators[static_cast<std::size_t>(i % 4)],
                                        1.0 + 0.5 * (i % 6)));
    }
    return preset;
}

void addNumber(QCryptographicHash &hash, double value)
{
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    hash.addData(QByteArrayView(bytes, sizeof bytes));
}

} // namespace

class TestGoldenRun : public QObject
{
    Q_OBJECT
private slots:
    void everyBitIsAsItWas_data();
    void everyBitIsAsItWas();
};

void TestGoldenRun::everyBitIsAsItWas_data()
{
    QTest::addColumn<Timing>("timing");
    QTest::addColumn<QByteArray>("sha256");
    // The same from GCC and Clang, with and without optimization. A change of the physics
    // changes these numbers on purpose; anything else must not.
    QTest::newRow("discrete")
        << Timing::Discrete
        << QByteArray("e9c1f24bdef340040d93ef11d147b6b0407103f29f47d13f583a7719eaeb0a37");
    QTest::newRow("continuous")
        << Timing::Continuous
        << QByteArray("73b8da787c2a0f08b48717d9ff4f40e88ffaf2eb5f3a509a53265d1969434fbd");
    QTest::newRow("exact")
        << Timing::Exact
        << QByteArray("e0a34bf01b741fa770a12d64419b963ac9cd1605bc5ba5f618a880ff3dcd76ab");
}

void TestGoldenRun::everyBitIsAsItWas()
{
    QFETCH(Timing, timing);
    QFETCH(QByteArray, sha256);
    const Preset preset = goldenPreset(timing);
    QVERIFY(!findFault(preset).has_value());
    Run run(preset);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (int step = 0; step < 600; ++step) {
        run.steps(1);
        addNumber(hash, run.world.time);
        for (const Circle &c : run.world.circles) {
            for (const double value : {c.position.x, c.position.y, c.velocity.x, c.velocity.y})
                addNumber(hash, value);
        }
    }
    QVERIFY(run.hits.size() > 100);
    QCOMPARE(hash.result().toHex(), sha256);
}

QTEST_APPLESS_MAIN(TestGoldenRun)
#include "test_golden_run.moc"
