// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace cradle {

/// The colours of a program's text, all readable on every background that a line may have.
struct CodeColours {
    QColor background;
    QColor currentLine; ///< frame of the line with the cursor
    QColor selection;
    QColor text;
    QColor muted; ///< comments, line numbers
    QColor keyword;
    QColor constant; ///< numbers, true, false, nil
    QColor string;
    QColor call; ///< names of functions where they are called or defined
    QColor circle1;
    QColor circle2;
    QColor error;         ///< mark and message
    QColor errorLine;     ///< background
    QColor suspect;       ///< mark
    QColor suspectLine;   ///< background
    QColor executing;     ///< mark
    QColor executingLine; ///< background
    QColor match;         ///< around what a search finds
};

/// In the colours of the theme in force.
[[nodiscard]] CodeColours codeColours();

} // namespace cradle
