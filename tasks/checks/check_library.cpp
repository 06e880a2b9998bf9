// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_library.h"

#include "tasks/checks/kinds.h"

#include <array>
#include <utility>

namespace cradle {

namespace {

using Judge = std::optional<Fault> (*)(const CheckSpec &, const Observation &);

constexpr std::array<std::pair<const char *, Judge>, 18> library{{
    {"start", kinds::start},
    {"integrates", kinds::integrates},
    {"closed_form", kinds::closedForm},
    {"bounces", kinds::bounces},
    {"stays_inside", kinds::staysInside},
    {"together", kinds::together},
    {"same_integrator", kinds::sameIntegrator},
    {"passes_through", kinds::passesThrough},
    {"collides", kinds::collides},
    {"rebounds", kinds::rebounds},
    {"touches", kinds::touches},
    {"conserves", kinds::conserves},
    {"after_contact", kinds::afterContact},
    {"loses_energy", kinds::losesEnergy},
    {"settles", kinds::settles},
    {"ends_at", kinds::endsAt},
    {"script", kinds::script},
    {"bounce_heights", kinds::bounceHeights},
}};

Judge find(const QString &kind)
{
    for (const auto &[name, judgeOfKind] : library) {
        if (kind == QLatin1String(name))
            return judgeOfKind;
    }
    return nullptr;
}

} // namespace

std::optional<Fault> judge(const CheckSpec &check, const Observation &observation)
{
    const Judge judgeOfKind = find(check.kind);
    Q_ASSERT(judgeOfKind);
    return judgeOfKind(check, observation);
}

} // namespace cradle
