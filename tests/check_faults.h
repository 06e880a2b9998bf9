// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/programs.h"
#include "tests/scenes.h"

#include <QTest>

#include <optional>

/// Runs of steps of 0.1 s, short enough to work out by hand what a check should say of them.
namespace cradle::programs::faults {

inline constexpr double h = 0.1; ///< s
/// 1000 kg/m³ of a circle of 0.2 m that weighs 1 kg.
inline const double kilogram = 1.0 / (1000.0 * 4.0 / 3.0 * scenes::pi * 0.008);

/// What to do at one step, from 1, after all circles have moved on by h v.
struct Change {
    int step = 0;
    std::function<void(Circles &)> make;
};

/// Circles that drift under \p gravity (m/s², symplectic Euler) but for \p changes.
inline Observation drift(const std::vector<Circle> &circles, const std::vector<Change> &changes,
                         double duration = 1.0, Vec2 gravity = {}, double e = 1.0)
{
    Preset preset = scene(circles, gravity, e);
    preset.timestep = h;
    // Half a step earlier, so that no rounding of the time adds a step.
    Observation o = observed(preset, duration - 0.5 * h, [&, step = 0](Circles &c, double) mutable {
        ++step;
        for (Circle &each : c)
            fall(each, gravity, h);
        for (const Change &change : changes) {
            if (change.step == step)
                change.make(c);
        }
    });
    o.variant.duration = duration;
    return o;
}

inline constexpr Vec2 unitGravity{0, -1}; ///< m/s²
inline const QString tolerance = QStringLiteral("tolerance");

/// One at rest in the middle, and \p second.
inline std::vector<Circle> beside(const Circle &second)
{
    return {{}, second};
}

/// A change of circle \p i at \p step.
inline std::vector<Change> change(int step, std::size_t i,
                                  const std::function<void(Circle &)> &make)
{
    return {{step, [i, make](Circles &c) { make(c[i]); }}};
}

/// The second is held where it is, and has these velocities one after the other.
inline std::vector<Change> held(const std::vector<Vec2> &velocities, Vec2 place)
{
    std::vector<Change> changes;
    for (std::size_t k = 0; k < velocities.size(); ++k)
        changes.push_back({static_cast<int>(k) + 1, [v = velocities[k], place](Circles &c) {
                               c[1].position = place;
                               c[1].velocity = v;
                           }});
    return changes;
}

struct Said {
    QString message{};
    std::optional<double> expected{};
    std::optional<double> observed{};
    QString unit{};
    qint64 step = 0;
};

inline void addColumns()
{
    QTest::addColumn<CheckSpec>("spec");
    QTest::addColumn<Observation>("run");
    QTest::addColumn<Said>("said");
}

inline void addRow(const char *name, const CheckSpec &spec, const Observation &run,
                   const char *message, qint64 step, std::optional<double> expected = {},
                   std::optional<double> observed = {}, const char *unit = "")
{
    QTest::newRow(name) << spec << run
                        << Said{QString::fromUtf8(message), expected, observed,
                                QString::fromUtf8(unit), step};
}

/// Whether one is there only if the other is, and they are near.
inline bool alike(const std::optional<double> &a, const std::optional<double> &b)
{
    return a.has_value() == b.has_value() && (!a || scenes::near(*a, *b, 1e-6));
}

} // namespace cradle::programs::faults

/// The check of the row says of its run what stands there, to the letter.
#define COMPARE_FAULT()                                                                            \
    do {                                                                                           \
        QFETCH(CheckSpec, spec);                                                                   \
        QFETCH(Observation, run);                                                                  \
        QFETCH(cradle::programs::faults::Said, said);                                              \
        const auto fault = judge(spec, run);                                                       \
        QVERIFY2(fault.has_value(), "it was accepted");                                            \
        QCOMPARE(fault->message, said.message);                                                    \
        QVERIFY(cradle::programs::faults::alike(fault->expected, said.expected));                  \
        QVERIFY(cradle::programs::faults::alike(fault->observed, said.observed));                  \
        QCOMPARE(fault->unit, said.unit);                                                          \
        QCOMPARE(fault->step, said.step);                                                          \
    } while (false)
