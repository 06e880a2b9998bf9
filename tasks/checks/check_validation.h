// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QJsonObject>

#include <vector>

namespace cradle {

/// What is wrong with the checks and remarks of a step, by the catalogue of kinds: unknown kinds
/// and parameters, wrong types, numbers out of range, circles that there are not. Each with the
/// JSON pointer of the place and what would be right.
/// \param task     a task.json that fits its schema
/// \param circles  how many circles the step's scene has
/// \param source   the file's name for messages
[[nodiscard]] std::vector<Error> findCheckFaults(const QJsonObject &task, std::size_t circles,
                                                 const QString &source);

} // namespace cradle
