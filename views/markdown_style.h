// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTextFormat>

class QColor;
class QTextDocument;

namespace cradle {

/// Font size in px; QFont itself knows it in either points or pixels.
[[nodiscard]] double fontSize(const QFont &font);

/// \p format with the font of code, for text of \p size px.
[[nodiscard]] QTextCharFormat codeFormat(QTextCharFormat format, double size);

/// Gives a document, read from Markdown in its default font, the distances, headings, code and
/// coloured words of instructions.
/// \param text  the colour of its text, of which the background of code gets a tint
void styleMarkdown(QTextDocument *document, const QColor &text);

} // namespace cradle
