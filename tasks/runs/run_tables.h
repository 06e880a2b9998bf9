// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/recording.h"
#include "model/world/result.h"

#include <QByteArray>

#include <optional>

namespace cradle {

/// The tables that a run is written as, all in CSV with SI units.
enum class RunTable {
    States, ///< step,time,circle,x,y,vx,vy: a row for every circle of every step
    Totals, ///< step,time,px,py,kinetic,potential,total: of all circles together
    Events  ///< time,kind,a,b,nx,ny,impulse: a row for every hit
};

/// The line of names above the columns.
[[nodiscard]] QByteArray headerOf(RunTable table);

/// The rows of one state: none of RunTable::Events. Numbers read back to the same double.
[[nodiscard]] QByteArray rowsOf(RunTable table, const World &world, const Preset &scene);

/// The row of a hit in RunTable::Events.
[[nodiscard]] QByteArray rowOf(const Hit &hit);

/// Writes all that \p recording has kept of a run of \p scene, whole or not at all.
/// \return what could not be written
[[nodiscard]] std::optional<Error> saveRunTable(RunTable table, const Recording &recording,
                                                const Preset &scene, const QString &path);

} // namespace cradle
