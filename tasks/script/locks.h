// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"

#include <QStringList>

#include <optional>

namespace cradle {

// What a step fixes in its scene ("locked" in task.json): names of fields as "gravity",
// "laws/timing" or "circles/1/velocity", circles counted from 1. "circles" fixes how many there
// are, "circles/1/mass" both radius and density.

/// All fields of \p preset that can be locked; of more than ten circles the first ten.
[[nodiscard]] QStringList lockableFields(const Preset &preset);

/// What the field is called for people: "gravity", "velocity of circle 1".
[[nodiscard]] QString lockedName(const QString &field, const Preset &preset);

/// The first of \p locked in which \p changed differs from \p original.
[[nodiscard]] std::optional<QString> firstChangedLock(const Preset &original, const Preset &changed,
                                                      const QStringList &locked);

/// Why such a field cannot be changed, for the student.
[[nodiscard]] QString lockReason(const QString &field, const Preset &original);

} // namespace cradle
