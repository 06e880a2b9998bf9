// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/runs/observation.h"
#include "tasks/script/lua_state.h"

namespace cradle {

/// A run as a check in Lua sees it; outlives the Lua state.
struct RunView {
    const Observation &run;
    QString language;        ///< of the student
    std::vector<Hit> hits{}; ///< filled in when they are asked for
    bool knowsHits = false;
};

/// Pushes the table `run`; what it offers is in check_script.h.
void pushRun(lua_State *L, RunView &view);

} // namespace cradle
