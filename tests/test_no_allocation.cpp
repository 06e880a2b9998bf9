// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<int> allocations{0};

} // namespace

void *operator new(std::size_t bytes)
{
    ++allocations;
    if (void *memory = std::malloc(bytes))
        return memory;
    throw std::bad_alloc();
}

void operator delete(void *memory) noexcept
{
    std::free(memory);
}

void operator delete(void *memory, std::size_t) noexcept
{
    std::free(memory);
}

using namespace cradle;
using namespace cradle::scenes;

/// Once its lists have grown to what the scene needs, a step asks for no memory.
class TestNoAllocation : public QObject
{
    Q_OBJECT
private slots:
    void aWarmStepAllocatesNothing_data();
    void aWarmStepAllocatesNothing();
};

void TestNoAllocation::aWarmStepAllocatesNothing_data()
{
    QTest::addColumn<Timing>("timing");
    QTest::addColumn<Integrator>("integrator");
    for (const Timing timing : {Timing::Discrete, Timing::Continuous, Timing::Exact})
        QTest::newRow(shortName(timing)) << timing << Integrator::Verlet;
    QTest::newRow("continuous, symplectic Euler")
        << Timing::Continuous << Integrator::SymplecticEuler;
}

void TestNoAllocation::aWarmStepAllocatesNothing()
{
    QFETCH(Timing, timing);
    QFETCH(Integrator, integrator);
    Preset preset = scene({}, {WallLaw::Reflect, CircleLaw::Impulse, timing});
    preset.fill = CircleFill{.count = 300, .radius = 0.1, .rmsSpeed = 2.0, .density = 1.0};
    preset.circles = *makeCircles(*preset.fill, halfWidth);
    for (PresetCircle &c : preset.circles)
        c.integrator = integrator;
    Run run(preset);
    run.hits.reserve(100'000);
    run.steps(1200); // 20 s: the fullest moments have come
    run.hits.clear();
    const int before = allocations;
    run.steps(120);
    const int after = allocations;
    QVERIFY(run.hits.size() > 100);
    // A list may still meet its fullest moment, but that is once, not once a step.
    QVERIFY2(after - before <= 3, QByteArray::number(after - before).constData());
}

QTEST_APPLESS_MAIN(TestNoAllocation)
#include "test_no_allocation.moc"
