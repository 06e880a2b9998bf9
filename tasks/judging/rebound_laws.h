// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/rebound_reading.h"

#include <QCoreApplication>
#include <QString>

namespace cradle {

struct ReboundText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

/// A rebound that students make of e, in place of e itself.
struct FactorLaw {
    double (*rebound)(double e);
    QString headline;
};
[[nodiscard]] std::vector<FactorLaw> factorLaws();

/// That the push grows otherwise with e than as 1 + e.
[[nodiscard]] QString pushHeadline(const PushLine &push);

/// Whether in all hits with losses the new part of \p circle, from 0, along the line of centres is
/// e times that of an elastic hit of equal circles, or e times that which is right.
[[nodiscard]] bool isTimesE(int circle, const MeasuredPair &own, const MeasuredPair &right);

} // namespace cradle
