// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"

#include <QJsonObject>

#include <utility>
#include <vector>

namespace cradle {

/// A check of that kind of these circles, from 0, in the step's own scene.
inline CheckSpec checkOf(const char *kind, const QJsonObject &parameters,
                         std::vector<int> circles = {0})
{
    CheckSpec check;
    check.kind = QLatin1String(kind);
    check.circles = std::move(circles);
    check.parameters = parameters;
    return check;
}

} // namespace cradle
