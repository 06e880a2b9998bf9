// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QJsonObject>

namespace cradle {

/// Applies to the JSON object in \p text what \p after differs in from \p before, and keeps all
/// else as it is written: order of keys, spaces, forms of numbers, keys that neither knows.
/// New members stand where the order of the format wants them, in the layout that is around them:
/// in a file of its own a member on each line, lists of texts and of objects with an element on
/// each, numbers with the fewest digits that read back the same.
/// \pre text is a JSON object
[[nodiscard]] QByteArray patchJson(const QByteArray &text, const QJsonObject &before,
                                   const QJsonObject &after);

} // namespace cradle
