// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/repairs.h"

#include <set>

namespace cradle {

/// Puts \p repairs into the order in which they are tried: first those that other lines tell, and
/// those that make the names of a
/// line agree on whose value it is, as in `local m2 = mass(circle1)`, last those that make them
/// disagree, those that ask for nothing any more, those of the
/// first of two equal lines of which the second is meant for circle 2, and those of lines that are
/// \p sound.
void putInOrder(std::vector<Repair> &repairs, const QString &source, const std::set<int> &sound);

} // namespace cradle
