// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <zip.h>

namespace cradle {

// What is asked of every entry of a zip that was handed in, before anything of it is used.

/// Whether a name stays below the folder that it is unpacked into.
[[nodiscard]] bool staysBelow(const QByteArray &name);

/// Whether an entry is a symbolic link, which could lead anywhere.
[[nodiscard]] bool isZippedLink(zip_t *archive, zip_uint64_t index);

} // namespace cradle
