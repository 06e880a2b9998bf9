// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/check_kinds.h"

#include <utility>

namespace cradle::parameters {

/// Short ways to write a catalogue of kinds down.
struct Bounds {
    std::optional<double> least{};
    std::optional<double> most{};
};

[[nodiscard]] inline ParameterInfo make(const char *name, ParameterInfo::Type type, QString label,
                                        QString help)
{
    ParameterInfo info;
    info.name = QLatin1String(name);
    info.type = type;
    info.label = std::move(label);
    info.help = std::move(help);
    return info;
}

[[nodiscard]] inline ParameterInfo inUnit(ParameterInfo info, const char *unit, Bounds bounds = {})
{
    info.unit = QString::fromUtf8(unit);
    info.least = bounds.least;
    info.most = bounds.most;
    return info;
}

[[nodiscard]] inline ParameterInfo usually(ParameterInfo info, QJsonValue standard)
{
    info.standard = std::move(standard);
    return info;
}

[[nodiscard]] inline ParameterInfo outOf(ParameterInfo info, QStringList choices)
{
    info.choices = std::move(choices);
    return info;
}

[[nodiscard]] inline ParameterInfo needed(ParameterInfo info)
{
    info.required = true;
    return info;
}

} // namespace cradle::parameters
