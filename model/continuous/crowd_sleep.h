// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuous/step_groups.h"

namespace cradle {

/// Lays groups to sleep all of whose members have been at rest for long enough after a step of
/// \p dt s: they are left alone until something may meet one of them.
void layToSleep(Crowd &crowd, double dt, StepGroups &groups);

} // namespace cradle
