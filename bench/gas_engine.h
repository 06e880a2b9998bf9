// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/gas.h"

#include <memory>
#include <vector>

namespace cradle {

/// A simulation of the gas, so that engines can be timed and judged alike.
class GasEngine
{
public:
    virtual ~GasEngine() = default;

    /// One step of the engine's own timestep.
    virtual void step() = 0;
    /// How many steps make a frame of 1/60 s.
    [[nodiscard]] virtual int stepsPerFrame() const = 0;
    /// Position and velocity of every circle now, in the order of the preset.
    virtual void read(std::vector<Motion> &motions) const = 0;
    /// Hits since the start, on circles and walls; 0 if the engine does not count them.
    [[nodiscard]] virtual qint64 hitCount() const { return 0; }
};

/// Every engine takes half width, gravity, restitution and circles from a gas() or a heap() and
/// starts from the same state.
using MakeEngine = std::unique_ptr<GasEngine> (*)(const Gas &gas);

/// Cradle from event to event, read once a frame.
std::unique_ptr<GasEngine> makeExact(const Gas &gas);

/// Cradle's steps of 1/240 s that miss no hit, with velocity Verlet: the same motion as exact.
std::unique_ptr<GasEngine> makeContinuous(const Gas &gas);

/// The same with symplectic Euler, which is moved step by step.
std::unique_ptr<GasEngine> makeStepped(const Gas &gas);

/// Cradle's steps of 1/60 s that miss no hit: what a heap is moved by.
std::unique_ptr<GasEngine> makePiled(const Gas &gas);

/// Box2D 2.4 with steps of 1/60 s, 8 velocity and 3 position iterations, in single precision.
/// Every contact of a gas is elastic: its restitution threshold (1 m/s by default) is set to 0.
std::unique_ptr<GasEngine> makeBox2d(const Gas &gas);

/// Chipmunk 7 with steps of 1/240 s, its 10 iterations and its slop of 0.1 m: a finer slop costs
/// the same.
std::unique_ptr<GasEngine> makeChipmunk(const Gas &gas);

/// The textbook's event-driven hard discs, the yardstick of a machine; without gravity.
std::unique_ptr<GasEngine> makeBaseline(const Gas &gas);

} // namespace cradle
