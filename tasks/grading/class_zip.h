// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QByteArray>

namespace cradle {

/// Whether \p path is a file that is named like a zip.
[[nodiscard]] bool isClassZip(const QByteArray &path);

/// Takes the zip of a class apart into the new folder \p place, without trust in it: links, names
/// that lead out of it and files that are too large for a student's work are left out and named.
/// Names stay the bytes that they are.
/// \return what was left out, or an error if it is no zip, holds absurdly much, or cannot be
/// written
Result<QStringList> unpackClass(const QByteArray &path, const QString &place);

} // namespace cradle
