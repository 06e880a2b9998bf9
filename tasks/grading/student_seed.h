// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QByteArray>

namespace cradle {

/// The seed of a student's scenes: nobody who does not know the class's secret can find it, and it
/// says nothing about a neighbour's. The first 52 bits of HMAC-SHA-256 (RFC 2104) of the id's UTF-8
/// under the secret, and 1 more: from 1 to 2^52, which every reader of JSON keeps whole.
[[nodiscard]] qint64 studentSeed(const QByteArray &secret, const QString &id);

/// Reads a secret: a file of 16 to 4096 bytes, without the white space around it.
Result<QByteArray> readSecret(const QString &path);

/// A new secret, 256 bits from the system as hexadecimal digits.
[[nodiscard]] QByteArray newSecret();

} // namespace cradle
