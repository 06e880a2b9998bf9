// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace cradle {

/// Tells screen readers what our own widgets are (scene, charts, dots of the steps) and
/// what they show, and speaks formulas in words. Called again it does nothing.
void installAccessibleRoles();

} // namespace cradle
