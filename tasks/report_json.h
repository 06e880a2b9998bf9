// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/check_report.h"

#include <QByteArray>

namespace cradle {

/// The report as JSON for graders (format 1): numbers with the fewest digits that read back.
QByteArray writeReport(const CheckReport &report);

} // namespace cradle
