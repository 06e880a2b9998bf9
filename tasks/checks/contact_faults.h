// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/contact_answer.h"
#include "tasks/checks/hit_places.h"

#include <cstddef>

/// What is said of contacts of two circles that are not answered as they should be.
namespace cradle::contact_faults {

/// They changed their velocities before they touched.
[[nodiscard]] Fault tooEarly(const ContactAnswer &answer);
/// They were moving apart already.
[[nodiscard]] Fault hitAgain(const ContactAnswer &answer);
/// Their velocities are not those of \p law.
[[nodiscard]] Fault wrongAnswer(const ContactAnswer &answer, CircleLaw law);
/// Their relative speed along the normal, m/s, did not become e times what it was.
[[nodiscard]] Fault wrongRebound(const ContactAnswer &answer, double closing, double parting);
/// The hit put circle \p who, from 0, where it does not belong.
[[nodiscard]] Fault misplaced(const ContactAnswer &answer, int who, const Misplacement &found);
/// By \p step they have run into each other, and nothing happened. \param e  of the scene
[[nodiscard]] Fault missed(qint64 step, double e);
/// By \p step they have run into each other; the answer came in the step that makes state
/// \p answered, when they were \p centres (m) apart.
[[nodiscard]] Fault late(qint64 step, qint64 answered, double centres);
/// \p fault in a run whose hit that makes state \p step, of the same circles, came out right.
[[nodiscard]] Fault afterRight(Fault fault, qint64 step);
/// \p fault of a step in which a wall may push one of them, too.
[[nodiscard]] Fault besideWall(Fault fault);
[[nodiscard]] Fault tooFew(std::size_t observed, int wanted);

} // namespace cradle::contact_faults
