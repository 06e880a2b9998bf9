// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/code/code_colours.h"

#include <Qsci/qscilexercustom.h>

namespace cradle {

/// Colours and folds a Lua program in an editor.
class LuaLexer final : public QsciLexerCustom
{
    Q_OBJECT
public:
    enum Style {
        Plain,
        Comment,
        Keyword,
        Constant,
        String,
        Call,
        Circle1,
        Circle2,
        Sign, ///< looks like Plain: in turn they keep the font from joining "<=" to one sign
        Dash, ///< looks like Comment, and does the same for "--" before words from the right
        StyleCount
    };

    explicit LuaLexer(QsciScintilla *editor);

    /// Takes colours and font for all styles; the editor must be given the lexer again.
    void setLook(const CodeColours &colours, const QFont &font);

    [[nodiscard]] const char *language() const override { return "Lua"; }
    [[nodiscard]] QString description(int style) const override;
    [[nodiscard]] const char *wordCharacters() const override;
    void styleText(int start, int end) override;

private:
    void styleComment(QByteArrayView comment);
    void fold(const QByteArray &text);
};

} // namespace cradle
