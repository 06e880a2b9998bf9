// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstddef>

namespace cradle {

// A circle that was given no name of its own is called "circle N" in every file, so that scenes do
// not depend on the language of whoever saved them. It is shown in the student's language.

/// The name that files give the circle with that number, from 1.
[[nodiscard]] QString plainCircleName(std::size_t number);

/// \p name as the student reads it: "circle 2" is "Kreis 2" in German; other names stay.
[[nodiscard]] QString shownCircleName(const QString &name);

/// \p shown, as a student typed it, as it is kept: the inverse of shownCircleName().
[[nodiscard]] QString keptCircleName(const QString &shown);

} // namespace cradle
