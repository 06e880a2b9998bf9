// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_text.h"
#include "tests/scenes.h"

#include "model/run/recording.h"
#include "model/world/measurements.h"

#include <QCryptographicHash>

#include <cstring>

using namespace cradle;
using namespace cradle::scenes;

/// Every bit of crowds, heaps, chains and what rests, with every hit, in every timing:
/// tests/approved/runs.txt has their hashes, the same from GCC and Clang, with and without
/// optimization. A change of the physics changes them on purpose; anything else must not.
class TestApprovedRuns : public QObject
{
    Q_OBJECT
private slots:
    void everyBitIsAsApproved_data();
    void everyBitIsAsApproved();
    void cleanupTestCase();

private:
    QMap<QString, QString> m_approved{}; ///< what is told, by the name of the run
};

namespace {

using Circles = std::vector<PresetCircle>;

Preset made(Circles circles, Timing timing, double gravity, double restitution)
{
    Preset preset = scene({}, {WallLaw::Reflect, CircleLaw::Impulse, timing});
    preset.gravity = {0.0, -gravity};
    preset.restitution = restitution;
    preset.circles = std::move(circles);
    return preset;
}

Circles crowd(int count, double radius, double speed, qint64 seed, double half = halfWidth)
{
    return *makeCircles(
        {.count = count, .radius = radius, .rmsSpeed = speed, .density = 7.8, .seed = seed}, half);
}

/// Of every integrator, in turns.
Circles mixed(Circles circles)
{
    for (std::size_t i = 0; i < circles.size(); ++i) {
        circles[i].integrator = allIntegrators[i % 4];
        circles[i].body.density = 1.0 + static_cast<double>(i % 5);
        circles[i].body.radius *= 0.6 + 0.1 * static_cast<double>(i % 4);
    }
    return circles;
}

/// Small ones among four that are ten times as large.
Circles giants()
{
    Circles all = crowd(70, 0.06, 1.5, 13, 2.2);
    for (const Vec2 corner : {Vec2{-3, -3}, {3, -3}, {3, 3}, {-3, 3}})
        all.push_back(circle(corner, {-0.5 * corner.y, 0.4 * corner.x}, 0.6));
    return all;
}

/// Five in a row that touch, and one that comes.
Circles cradleOfFive(double gap = 0.0)
{
    Circles all{circle({-3.0, 0.0}, {2.0, 0.0})};
    for (int i = 0; i < 5; ++i)
        all.push_back(circle({(0.4 + gap) * i, 0.0}));
    return all;
}

/// A triangle that touches itself, and a fast one from the left.
Circles rack()
{
    Circles all{circle({-3.5, 0.05}, {6.0, 0.0})};
    const double rise = std::sqrt(3.0) / 2.0;
    for (int row = 0; row < 4; ++row) {
        for (int i = 0; i <= row; ++i)
            all.push_back(circle({0.41 * rise * row, 0.41 * (i - 0.5 * row)}));
    }
    return all;
}

/// Rows on the floor, those above in the gaps, and a heavy one that falls upon them.
Circles wall(int rows)
{
    Circles all;
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < 6 - row; ++i)
            all.push_back(circle({-1.2 + 0.42 * i + 0.21 * row, -3.79 + 0.37 * row}));
    }
    all.push_back(circle({-0.1, 3.0}, {0.0, -1.0}, 0.35, Integrator::Verlet, 20.0));
    return all;
}

/// A tower that rests, two that come to rest beside it, one in a corner.
Circles resting()
{
    return {circle({0.0, -3.8}), circle({0.0, -3.4}),   circle({0.0, -3.0}),
            circle({3.8, -3.8}), circle({1.0, -3.795}), circle({-2.0, -3.0}, {1.0, 0.0}),
            circle({-3.8, -1.0})};
}

/// Rows that sleep on the floor, and one above each that falls upon it, one after the other.
Circles sleepers()
{
    Circles all;
    for (int i = 0; i < 60; ++i)
        all.push_back(circle({-3.9 + 0.13 * i, -3.95}, {}, 0.05));
    for (int i = 0; i < 60; ++i)
        all.push_back(circle({-3.9 + 0.13 * i, -2.35 + 0.1 * i}, {}, 0.05));
    return all;
}

/// Many that meet at the same moments: mirrored across both axes, into walls, corners and each
/// other.
Circles mirrored(double speed)
{
    Circles all;
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            all.push_back(circle({1.5 * x, 1.5 * y}, {-speed * x, -speed * y}));
            all.push_back(circle({2.6 * x, 2.6 * y}, {speed * x, speed * y}, 0.3));
            all.push_back(circle({3.0 * x, 0.9 * y}, {speed * x, 0.0}, 0.1));
        }
    }
    all.push_back(circle({}));
    return all;
}

/// Some of each size, from grains to one that takes a sixteenth of the square.
Circles sizes(double speed)
{
    Circles all = crowd(80, 0.05, speed, 14, 1.9);
    for (const PresetCircle &c : crowd(12, 0.1, speed, 15, 1.0)) {
        PresetCircle other = c;
        other.body.position = 0.6 * c.body.position + Vec2{3.2, -3.2};
        other.body.radius = 0.02 + 0.04 * std::abs(c.body.position.x);
        all.push_back(other);
    }
    all.push_back(circle({-2.9, 2.9}, {2.0 * speed, -1.5 * speed}, 1.0));
    all.push_back(circle({2.9, 2.9}, {-speed, 2.0 * speed}, 0.8));
    return all;
}

/// All touch another, or a wall, from the start.
Circles touching()
{
    return {circle({0.0, 0.0}, {1.0, 0.2}),
            circle({0.4, 0.0}, {-1.0, 0.0}),
            circle({0.0, 0.4}),
            circle({3.8, 0.0}, {0.5, 0.1}),
            circle({-3.8, -3.8}),
            circle({-3.8, -3.4}, {0.0, -2.0}),
            circle({2.0, 3.8}, {0.3, 3.0}),
            circle({2.4, 3.8}, {-0.3, 1.0})};
}

void addNumber(QCryptographicHash &hash, double value)
{
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    hash.addData(QByteArrayView(bytes, sizeof bytes));
}

void addVector(QCryptographicHash &hash, Vec2 v)
{
    addNumber(hash, v.x);
    addNumber(hash, v.y);
}

void addHit(QCryptographicHash &hash, const Hit &hit)
{
    addNumber(hash, hit.time);
    addNumber(hash, hit.a);
    addNumber(hash, hit.b);
    for (const Vec2 v : {hit.normal, hit.beforeA, hit.afterA, hit.beforeB, hit.afterB})
        addVector(hash, v);
    addNumber(hash, hit.loss);
}

} // namespace

void TestApprovedRuns::everyBitIsAsApproved_data()
{
    QTest::addColumn<Preset>("preset");
    QTest::addColumn<int>("steps");
    const auto add = [](const char *name, const Preset &preset, int steps) {
        QTest::addRow("%s, %s", name, shortName(preset.laws.timing)) << preset << steps;
    };
    for (const Timing timing : {Timing::Discrete, Timing::Continuous, Timing::Exact}) {
        add("thin gas", made(crowd(60, 0.1, 2.0, 3), timing, 0.0, 1.0), 240);
        add("dense gas", made(crowd(150, 0.14, 1.5, 4), timing, 0.0, 1.0), 60);
        add("gas that loses", made(crowd(80, 0.12, 3.0, 5), timing, 0.0, 0.6), 240);
        add("gas that falls", made(crowd(80, 0.12, 2.0, 6), timing, 9.81, 1.0), 180);
        add("all integrators", made(mixed(crowd(60, 0.2, 2.0, 7)), timing, 9.81, 0.9), 240);
        add("giants", made(giants(), timing, 0.0, 1.0), 240);
        add("giants that fall", made(giants(), timing, 9.81, 0.7), 120);
        add("heap", made(crowd(60, 0.2, 0.5, 8), timing, 9.81, 0.5), 240);
        add("heap without rebound", made(crowd(40, 0.2, 0.5, 9), timing, 9.81, 0.0), 180);
        add("cradle", made(cradleOfFive(), timing, 0.0, 1.0), 240);
        add("cradle with gaps", made(cradleOfFive(0.01), timing, 0.0, 0.9), 240);
        add("rack", made(rack(), timing, 0.0, 0.95), 240);
        add("wall", made(wall(4), timing, 9.81, 0.3), 240);
        add("resting", made(resting(), timing, 9.81, 0.4), 300);
        add("resting, elastic", made(resting(), timing, 9.81, 1.0), 120);
        if (timing != Timing::Exact) // which merges the contacts of large heaps
            add("large heap", made(crowd(300, 0.1, 0.5, 12), timing, 9.81, 0.3), 150);
        add("sleepers", made(sleepers(), timing, 9.81, 0.5), 120);
        Preset other = made(crowd(30, 0.2, 2.0, 10), timing, 0.0, 1.0);
        for (const CircleLaw law :
             {CircleLaw::SwapVelocities, CircleLaw::SwapNormal, CircleLaw::Stop, CircleLaw::None}) {
            other.laws.circles = law;
            add(qPrintable(QStringLiteral("law %1").arg(int(law))), other, 90);
        }
        other = made(crowd(30, 0.2, 2.0, 11), timing, 9.81, 0.7);
        other.timestep = 1.0 / 25.0;
        add("coarse steps", other, 100);
        other.timestep = 1.0 / 240.0;
        other.gravity = {3.0, -2.0};
        add("fine steps, aslant", other, 400);
        other.laws.walls = WallLaw::None;
        add("no walls", other, 200);
        for (const CircleLaw law : {CircleLaw::SwapVelocities, CircleLaw::SwapNormal,
                                    CircleLaw::Stop, CircleLaw::Impulse}) {
            for (const double e : {1.0, 0.5, 0.0}) {
                for (const double gravity : {0.0, 9.81}) {
                    const auto addAll = [&](const char *name, const Circles &circles) {
                        Preset preset = made(circles, timing, gravity, e);
                        preset.laws.circles = law;
                        add(qPrintable(QStringLiteral("%1, law %2, e %3, %4 m/s²")
                                           .arg(QLatin1String(name))
                                           .arg(int(law))
                                           .arg(e)
                                           .arg(gravity)),
                            preset, 100);
                    };
                    addAll("mirrored", mirrored(1.7));
                    addAll("touching", touching());
                    addAll("resting", resting());
                }
            }
        }
        // Towards each wall, and into each corner.
        for (const Vec2 gravity : {Vec2{0, 9.81}, Vec2{9.81, 0}, Vec2{-9.81, 0}, Vec2{4, 5},
                                   Vec2{-4, 5}, Vec2{4, -5}, Vec2{-4, -5}, Vec2{0, -0.05}}) {
            const auto addAll = [&](const char *name, const Circles &circles, double e, int steps) {
                Preset preset = made(circles, timing, 0.0, e);
                preset.gravity = gravity;
                add(qPrintable(QStringLiteral("%1, gravity %2, %3")
                                   .arg(QLatin1String(name))
                                   .arg(gravity.x)
                                   .arg(gravity.y)),
                    preset, steps);
            };
            addAll("few", crowd(12, 0.3, 1.0, 16), 0.4, 240);
            addAll("sizes", sizes(1.0), 0.8, 60);
        }
        for (const bool walled : {true, false}) {
            for (const double width : {4.0, 4.9, 40.0}) {
                Preset preset = made(sizes(2.0), timing, walled ? 0.0 : 1.0, 1.0);
                preset.halfWidth = width;
                if (!walled)
                    preset.laws.walls = WallLaw::None;
                add(qPrintable(QStringLiteral("sizes, %1 m, walls %2").arg(width).arg(walled)),
                    preset, 120);
            }
        }
        add("one", made({circle({0.3, -0.2}, {2.0, -1.0})}, timing, 9.81, 0.6), 240);
        add("none", made({}, timing, 9.81, 0.6), 10);
    }
}

void TestApprovedRuns::everyBitIsAsApproved()
{
    QFETCH(Preset, preset);
    QFETCH(int, steps);
    const auto fault = findFault(preset);
    QVERIFY2(!fault, fault ? qPrintable(fault->toString()) : "");
    Run run(preset);
    Recording recording(256 * 1024);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    std::size_t seen = 0;
    for (int step = 0; step < steps; ++step) {
        run.steps(1);
        addNumber(hash, run.world.time);
        for (const Circle &c : run.world.circles) {
            addVector(hash, c.position);
            addVector(hash, c.velocity);
        }
        recording.append(run.world, std::span(run.hits).subspan(seen));
        for (; seen < run.hits.size(); ++seen)
            addHit(hash, run.hits[seen]);
    }
    for (const Encounter &contact : recording.encounters()) {
        addNumber(hash, contact.time);
        addNumber(hash, contact.endTime);
    }
    const QString told =
        QStringLiteral("%1 hits, %2 contacts from step %3, %4")
            .arg(seen)
            .arg(recording.droppedEncounters() + qint64(recording.encounters().size()))
            .arg(recording.first())
            .arg(QString::fromLatin1(hash.result().toHex().left(32)));
    const QString name = QString::fromUtf8(QTest::currentDataTag());
    m_approved[name] = told;
    if (!approved::isApproving()) {
        const QString all = approved::read(QStringLiteral("runs.txt"));
        QVERIFY2(all.contains(name + QStringLiteral(": ") + told + QLatin1Char('\n')),
                 qPrintable(told));
    }
}

void TestApprovedRuns::cleanupTestCase()
{
    if (!approved::isApproving())
        return;
    QString all;
    for (auto it = m_approved.cbegin(); it != m_approved.cend(); ++it)
        all += it.key() + QStringLiteral(": ") + it.value() + QLatin1Char('\n');
    approved::write(QStringLiteral("runs.txt"), all);
}

QTEST_APPLESS_MAIN(TestApprovedRuns)
#include "test_approved_runs.moc"
