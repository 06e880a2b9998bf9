// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArrayView>

#include <optional>
#include <vector>

namespace cradle {

inline constexpr int luaIndent = 2; ///< spaces

/// The indentation of a line that is begun after \p before, in spaces.
[[nodiscard]] int indentAfter(QByteArrayView before);

/// The indentation that the last line of \p before should have, if it is nothing but a word or sign
/// that ends a block: that of the line where the block begins.
[[nodiscard]] std::optional<int> indentOfCloser(QByteArrayView before);

/// The lines of \p text that begin or end blocks.
struct LuaFold {
    int depth = 0;       ///< of the line: blocks that it stands in
    bool header = false; ///< a block begins in it that ends later
};
[[nodiscard]] std::vector<LuaFold> luaFolds(QByteArrayView text);

} // namespace cradle
