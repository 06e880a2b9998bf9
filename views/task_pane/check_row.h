// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/check_report.h"

#include <QWidget>

namespace cradle {

/// One check of a report: a tick or a ring, its title, and if it failed what was observed, shown
/// on request.
class CheckRow final : public QWidget
{
    Q_OBJECT
public:
    explicit CheckRow(const CheckOutcome &outcome, QWidget *parent = nullptr);
};

} // namespace cradle
