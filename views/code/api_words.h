// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <vector>

namespace cradle {

/// A word that a student's program may use, with what there is to say about it.
struct ApiWord {
    enum class Kind {
        Value,    ///< a variable or a field
        Function, ///< with brackets
        Hook,     ///< a function that the student writes
        Keyword,  ///< of Lua
        Own       ///< found in the program itself
    };

    QString owner{}; ///< "vec", "circle", "xy", "square", "draw", "math" …; empty if global
    QString name{};
    QString signature{}; ///< as it is called: "dot(a, b)"; of a value its name
    QString doc{};       ///< one line, in the language of the application
    Kind kind = Kind::Value;

    friend bool operator==(const ApiWord &, const ApiWord &) = default;
};

/// All words of the interface and of Lua, in the language of the application.
[[nodiscard]] std::vector<ApiWord> apiWords();

/// The headings of docs/lua-api.md under which \p word may stand, the best first.
[[nodiscard]] QStringList headingsOf(const QString &word);

} // namespace cradle
