// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"
#include "model/world/result.h"

#include <QByteArray>

namespace cradle {

/// What the file \p path holds, with the values of the step of a lab in whose folder it lies put
/// in, as for the student with that number. A file that lies in no step is as it is.
/// \param bytes  of the file
/// \return an error with its path about a value that is none
[[nodiscard]] Result<QByteArray> withValuesOfItsStep(const QString &path, const QByteArray &bytes,
                                                     const QString &student);

/// Reads a scene with its values and expressions so. \return an error as readPreset() has them
[[nodiscard]] Result<Preset> presetWithValues(const QString &path, const QString &student);

} // namespace cradle
