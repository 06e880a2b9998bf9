// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace cradle {

/// A program with one small change that may mend it.
struct Repair {
    QString source;
    int line = 0;      ///< of the program, from 1, in which something was changed
    bool alone = true; ///< else the same was changed in lines that are alike
    /// Other lines tell that it is meant so: one that says it of the other circle, a value that
    /// was worked out for it and is used nowhere.
    bool told = false;
    /// It turns a sign where none stands, or leaves a question out: what does the same by another
    /// word is likelier meant.
    bool isRoundabout = false;
    /// It changes what is right by itself, or makes of it what nobody means.
    bool isDoubtful = false;
};

/// Programs that differ from \p source in one token, one factor, one term, one part of a condition
/// or one statement: what students forget, exchange or get the wrong way round, undone. Such as
/// cannot be read are among them.
/// \param reference  who names no restitution there and here has none to put in
/// \param lines  in which something may be changed, in that order
/// \param most  of them
[[nodiscard]] std::vector<Repair> repairsOf(const QString &source, const QString &reference,
                                            const std::vector<int> &lines, std::size_t most);

} // namespace cradle
