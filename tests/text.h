// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle {

/// A text of the sources, which are in UTF-8.
inline QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

} // namespace cradle
