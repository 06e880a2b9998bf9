// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"

#include <QByteArray>
#include <QJsonObject>

namespace cradle {

/// The report as JSON for graders (format 1): numbers with the fewest digits that read back.
QByteArray writeReport(const CheckReport &report);

/// The same without its format and its times, to be a part of something larger.
QJsonObject reportObject(const CheckReport &report);

/// "start", "motion", "walls", "contact", "response" and "course"; and back.
[[nodiscard]] QString aspectName(Aspect aspect);
[[nodiscard]] std::optional<Aspect> aspectFromName(const QString &name);

} // namespace cradle
