// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/check_library.h"

namespace cradle::kinds {

/// One function for each kind of check; see judge().
std::optional<Fault> start(const CheckSpec &check, const Observation &o);
std::optional<Fault> integrates(const CheckSpec &check, const Observation &o);
std::optional<Fault> closedForm(const CheckSpec &check, const Observation &o);
std::optional<Fault> bounces(const CheckSpec &check, const Observation &o);
std::optional<Fault> staysInside(const CheckSpec &check, const Observation &o);
std::optional<Fault> together(const CheckSpec &check, const Observation &o);
std::optional<Fault> sameIntegrator(const CheckSpec &check, const Observation &o);
std::optional<Fault> passesThrough(const CheckSpec &check, const Observation &o);
std::optional<Fault> collides(const CheckSpec &check, const Observation &o);
std::optional<Fault> rebounds(const CheckSpec &check, const Observation &o);
std::optional<Fault> touches(const CheckSpec &check, const Observation &o);
std::optional<Fault> conserves(const CheckSpec &check, const Observation &o);
std::optional<Fault> afterContact(const CheckSpec &check, const Observation &o);
std::optional<Fault> losesEnergy(const CheckSpec &check, const Observation &o);
std::optional<Fault> settles(const CheckSpec &check, const Observation &o);
std::optional<Fault> endsAt(const CheckSpec &check, const Observation &o);
std::optional<Fault> script(const CheckSpec &check, const Observation &o);
std::optional<Fault> bounceHeights(const CheckSpec &check, const Observation &o);

} // namespace cradle::kinds
