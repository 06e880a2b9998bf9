// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle::programs::integration {

/// Ways to move a circle, as pieces of a LawProgram.
inline const QString euler = QStringLiteral("c.position = c.position + c.velocity * h "
                                            "c.velocity = c.velocity + gravity * h");
inline const QString symplectic = QStringLiteral("c.velocity = c.velocity + gravity * h "
                                                 "c.position = c.position + c.velocity * h");
inline const QString verlet =
    QStringLiteral("c.position = c.position + c.velocity * h + gravity * (h * h / 2) "
                   "c.velocity = c.velocity + gravity * h");

} // namespace cradle::programs::integration
