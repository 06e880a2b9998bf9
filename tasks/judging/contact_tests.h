// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/measured_pair.h"

#include <QCoreApplication>

#include <functional>

namespace cradle {

struct ContactText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

/// A test of contact that a program may have in place of the sum of the radii.
struct ContactTest {
    std::function<double(const PairHit &)> distance; ///< at which it says that they touch, m
    QString headline;
    QString body;
    bool isOfParts = false; ///< it is the distance that is wrong, made of parts of the difference
};

/// Those that students write.
[[nodiscard]] std::vector<ContactTest> contactTests();

} // namespace cradle
