// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"
#include "tasks/values/lab_values.h"

#include <QJsonValue>

namespace cradle {

/// \p text with the number of every {{EXPRESSION}} in its place, in the fewest digits.
/// \param lenient  leaves what is no expression as it is, for programs: {{1, 2}} is a table there
/// \return an error that names the first that has no value
[[nodiscard]] Result<QString> withNumbers(const QString &text, const Values &values,
                                          bool lenient = false);

/// An expression in which values stand between marks, without those: "3/{{k}}" is "3/(k)".
[[nodiscard]] QString withoutMarks(const QString &expression);

/// A scene whose numbers may be expressions, as "1 + 0.42*cos(pi/6)".
[[nodiscard]] Result<QJsonObject> sceneWithNumbers(const QJsonObject &scene, const Values &values);

/// A task.json: texts as of withNumbers(); in parameters, scenes and questions what is nothing but
/// {{EXPRESSION}} is a number.
[[nodiscard]] Result<QJsonObject> taskWithNumbers(const QJsonObject &task, const Values &values);

} // namespace cradle
