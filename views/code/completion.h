// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/code/api_words.h"

#include <QByteArrayView>

#include <optional>
#include <vector>

namespace cradle {

/// What stands before the cursor where a word may be completed.
struct CompletionPlace {
    QString owner;      ///< the name before "." or ":"; "circles[]" for a member of a list
    QChar link;         ///< "." or ":", or null
    QString begun;      ///< what is typed of the word
    bool known = false; ///< the members of owner are known

    friend bool operator==(const CompletionPlace &, const CompletionPlace &) = default;
};

/// \param before  the text up to the cursor, UTF-8
/// \return nothing in a comment, a string or a number
[[nodiscard]] std::optional<CompletionPlace> completionPlace(QByteArrayView before);

/// The words that fit: the interface's first, then those of the program.
[[nodiscard]] std::vector<ApiWord> completions(const CompletionPlace &place,
                                               QByteArrayView program);

/// The call that the cursor stands in.
struct CallPlace {
    ApiWord function;
    int argument = 0; ///< from 0

    friend bool operator==(const CallPlace &, const CallPlace &) = default;
};

/// \param after  the text behind the cursor, where functions may be defined too
/// \return nothing outside a call, and for a function that is not known
[[nodiscard]] std::optional<CallPlace> callPlace(QByteArrayView before, QByteArrayView after);

} // namespace cradle
