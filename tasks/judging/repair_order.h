// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/repairs.h"

#include <set>

namespace cradle {

/// Puts \p repairs into the order in which they are tried: first those that other lines tell, those
/// that make the names of a line agree on whose value it is, as in `local m2 = mass(circle1)`, and
/// numbers with names; then those of one line, then those of several that are alike; last the
/// doubtful: those that make names disagree, ask for nothing any more or leave out what is written
/// back, those of the first of two equal lines of which the second is meant for circle 2, and those
/// of lines that are \p sound.
/// \param triesNumbers  whether a number with a name is at fault itself, and not where it is taken
void putInOrder(std::vector<Repair> &repairs, const QString &source, const std::set<int> &sound,
                bool triesNumbers);

} // namespace cradle
