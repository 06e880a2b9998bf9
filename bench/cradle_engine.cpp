// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/gas_engine.h"
#include "model/stepper.h"

namespace cradle {

namespace {

/// The model as the window drives it: a world, its stepper, and the hits of a step.
class CradleEngine final : public GasEngine
{
public:
    CradleEngine(Preset preset, Timing timing, int stepsPerFrame)
        : m_stepsPerFrame(stepsPerFrame)
        , m_world(initialWorld(preset))
        , m_stepper(withTiming(std::move(preset), timing, stepsPerFrame))
    {
    }

    void step() override
    {
        m_hits.clear();
        m_stepper.advance(m_world, m_hits);
        m_hitCount += static_cast<qint64>(m_hits.size());
    }
    [[nodiscard]] int stepsPerFrame() const override { return m_stepsPerFrame; }
    [[nodiscard]] qint64 hitCount() const override { return m_hitCount; }

    void read(std::vector<Motion> &motions) const override
    {
        motions.clear();
        for (const Circle &circle : m_world.circles)
            motions.push_back({circle.position, circle.velocity});
    }

private:
    static Preset withTiming(Preset preset, Timing timing, int stepsPerFrame)
    {
        preset.laws.timing = timing;
        preset.timestep = 1.0 / (60.0 * stepsPerFrame);
        for (PresetCircle &circle : preset.circles)
            circle.integrator = Integrator::Verlet;
        return preset;
    }

    int m_stepsPerFrame;
    World m_world;
    Stepper m_stepper;
    std::vector<Hit> m_hits;
    qint64 m_hitCount = 0;
};

} // namespace

std::unique_ptr<GasEngine> makeExact(const Preset &gas)
{
    return std::make_unique<CradleEngine>(gas, Timing::Exact, 1);
}

std::unique_ptr<GasEngine> makeContinuous(const Preset &gas)
{
    return std::make_unique<CradleEngine>(gas, Timing::Continuous, 4);
}

} // namespace cradle
