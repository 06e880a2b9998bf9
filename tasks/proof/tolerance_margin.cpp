// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/proof/tolerance_margin.h"

#include "tasks/checks/check_kinds.h"
#include "tasks/checks/check_library.h"
#include "tasks/runs/observation.h"

namespace cradle {

namespace {

constexpr int halvings = 10; ///< of the tolerance: the figure is right to a thousandth of it

bool passes(CheckSpec check, const Observation &run, double tolerance)
{
    check.parameters.insert(QStringLiteral("tolerance"), tolerance);
    return !judge(check, run);
}

/// The least tolerance with which \p run passes, between 0 and \p allowed, with which it does.
double leastTolerance(const CheckSpec &check, const Observation &run, double allowed)
{
    double fails = 0.0;
    double enough = allowed;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (fails + enough);
        (passes(check, run, middle) ? enough : fails) = middle;
    }
    return enough;
}

} // namespace

std::optional<TightTolerance> findTightTolerance(const Task &task, const CheckSpec &check,
                                                 const std::function<bool()> &stop)
{
    const auto kinds = checkKinds();
    const KindInfo *kind = findKind(kinds, check.kind);
    const ParameterInfo *info = kind ? findParameter(*kind, QStringLiteral("tolerance")) : nullptr;
    if (!info || task.solution.isEmpty())
        return std::nullopt;
    TightTolerance tight;
    tight.unit = info->unit;
    tight.allowed = check.parameters.value(info->name).toDouble(info->standard.toDouble());
    if (tight.allowed <= 0.0)
        return std::nullopt;
    for (const Variant &variant : makeVariants(task.preset, check, 1)) {
        if (stop())
            return std::nullopt;
        const Observation run = observe(variant, &task.solution, stop);
        if (run.error || !passes(check, run, tight.allowed))
            return std::nullopt;
        if (passes(check, run, tight.allowed / toleranceMargin))
            continue;
        const double needed = leastTolerance(check, run, tight.allowed);
        if (needed > tight.needed) {
            tight.needed = needed;
            tight.variant = variant.name;
        }
    }
    return tight.needed > 0.0 ? std::optional(tight) : std::nullopt;
}

} // namespace cradle
