// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"

#include <QSet>

#include <vector>

namespace cradle {

/// The names that the text of a step may use in code: those of the lab's Lua, of its programs and
/// of the fields of a preset.
struct TextNames {
    QSet<QString> words{};
    int circles = 0; ///< of the preset: circle1 … circleN
};

[[nodiscard]] TextNames textNames(const Task &task);

/// A name in backticks that nothing in the step is called.
struct UnknownName {
    qsizetype start = 0; ///< in the text, in characters
    qsizetype length = 0;
    QString name{};
    int line = 1; ///< of the text, from 1

    friend bool operator==(const UnknownName &, const UnknownName &) = default;
};

/// The names in single backticks in \p markdown that are not in \p known. Only what looks like a
/// name or a path of names (circle1.velocity) is looked at, never whole expressions, nor what
/// stands in fenced blocks.
[[nodiscard]] std::vector<UnknownName> unknownNames(const QString &markdown,
                                                    const TextNames &known);

} // namespace cradle
