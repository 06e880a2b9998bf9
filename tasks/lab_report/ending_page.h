// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_report/report_html.h"

namespace cradle {

/// The page at the end of a lab: the pictures of the student's runs as a strip, what was found
/// hard, the energy of the whole lab. With numbered drawings.
/// \param finished  whether it is told because the last step was passed
[[nodiscard]] LabReportPage endingPage(const LabReport &report, bool finished);

} // namespace cradle
