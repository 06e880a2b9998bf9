// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QByteArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace cradle {

/// Reads a file whole, but never more than \p maxBytes: a larger one is refused unread.
Result<QByteArray> readFile(const QString &path, qint64 maxBytes);

/// Parses \p text as a JSON object that fits the JSON Schema (draft 7) at \p schemaResource.
/// Each place of the schema carries a "description" of what would be right there; it becomes
/// the error's message, with the JSON pointer of the place, or the line if the syntax is broken.
/// \param source  the file's name for messages; may be empty
Result<QJsonObject> parseJson(const QByteArray &text, const QString &schemaResource,
                              const QString &source);

} // namespace cradle
