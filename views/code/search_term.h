// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle {

/// What is searched for in a text.
struct SearchTerm {
    QString text;
    bool matchCase = false;
    bool wholeWord = false;

    friend bool operator==(const SearchTerm &, const SearchTerm &) = default;
};

/// Where a search is: the match that is selected, from 1 (0: none), of all that there are.
struct SearchPlace {
    int match = 0;
    int count = 0;

    friend bool operator==(const SearchPlace &, const SearchPlace &) = default;
};

} // namespace cradle
