// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/preset.h"
#include "model/world.h"

#include <QByteArray>

#include <vector>

namespace cradle::cli {

/// Collects the three tables of a run as CSV, each only if somebody asked for it.
class SimulateTables
{
public:
    QByteArray states = "step,time,circle,x,y,vx,vy\n";
    QByteArray totals = "step,time,px,py,kinetic,potential,total\n";
    QByteArray events = "time,kind,a,b,nx,ny,impulse\n";
    bool wantStates = false;
    bool wantTotals = false;
    bool wantEvents = false;

    /// A row for every circle, and one for all together.
    void addState(const World &world, const Preset &scene);
    void addHits(const std::vector<Hit> &hits);
};

/// What became of a run, in two lines, for those who asked for no table.
[[nodiscard]] QByteArray summaryOf(const Preset &scene, const World &world, std::size_t hits);

} // namespace cradle::cli
