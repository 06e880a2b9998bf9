// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QRegularExpression>
#include <QString>

namespace cradle {

/// The expression of that text, made ready once in a thread: that takes longer than all matching.
/// Only for texts of the program itself, of which there are few.
inline const QRegularExpression &keptPattern(const QString &text)
{
    thread_local QHash<QString, QRegularExpression> kept;
    auto found = kept.find(text);
    if (found == kept.end())
        found = kept.insert(text, QRegularExpression(text));
    return *found;
}

} // namespace cradle
