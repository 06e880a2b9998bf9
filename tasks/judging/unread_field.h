// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace cradle {

/// A field that a program sets and never reads, of whose name one of a circle's begins: `c.pos`.
/// It moves nothing, and nothing stops there: a program may have fields of its own.
struct UnreadField {
    int line = 0;
    QString name{};
    QString meant{}; ///< position

    friend bool operator==(const UnreadField &, const UnreadField &) = default;
};

/// The first in \p program; nothing if it has none.
[[nodiscard]] std::optional<UnreadField> unreadField(const QString &program);

} // namespace cradle
