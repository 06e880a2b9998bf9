// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/gas_engine.h"
#include "model/run/stepper.h"

namespace cradle {

namespace {

/// A solver of crowds. Like its peers it keeps the state, and hands it out when asked.
template <class Solver>
class CradleEngine final : public GasEngine
{
public:
    CradleEngine(const Gas &gas, Integrator integrator, int stepsPerFrame)
        : m_stepsPerFrame(stepsPerFrame)
        , m_timestep(1.0 / (60.0 * stepsPerFrame))
        , m_count(gas.circles.size())
    {
        Rules rules = rulesOf(gas);
        rules.integrators.assign(m_count, integrator);
        m_solver.start(rules, gas.bodies);
    }

    void step() override
    {
        ++m_step;
        m_hits.clear();
        m_solver.advance(m_timestep, static_cast<double>(m_step) * m_timestep, m_step, m_hits);
        m_hitCount += static_cast<qint64>(m_hits.size());
    }
    [[nodiscard]] int stepsPerFrame() const override { return m_stepsPerFrame; }
    [[nodiscard]] qint64 hitCount() const override { return m_hitCount; }

    void read(std::vector<Motion> &motions) const override
    {
        std::vector<Circle> circles(m_count);
        m_solver.read(circles);
        motions.clear();
        for (const Circle &circle : circles)
            motions.push_back({circle.position, circle.velocity});
    }

private:
    int m_stepsPerFrame;
    double m_timestep; // s
    qint64 m_step = 0;
    std::size_t m_count;
    Solver m_solver;
    std::vector<Hit> m_hits;
    qint64 m_hitCount = 0;
};

} // namespace

std::unique_ptr<GasEngine> makeExact(const Gas &gas)
{
    return std::make_unique<CradleEngine<ExactSolver>>(gas, Integrator::Verlet, 1);
}

std::unique_ptr<GasEngine> makeContinuous(const Gas &gas)
{
    return std::make_unique<CradleEngine<ContinuousSolver>>(gas, Integrator::Verlet, 4);
}

std::unique_ptr<GasEngine> makePiled(const Gas &gas)
{
    return std::make_unique<CradleEngine<ContinuousSolver>>(gas, Integrator::Verlet, 1);
}

std::unique_ptr<GasEngine> makeStepped(const Gas &gas)
{
    return std::make_unique<CradleEngine<ContinuousSolver>>(gas, Integrator::SymplecticEuler, 4);
}

} // namespace cradle
