// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/markdown_highlighter.h"

#include "views/theme.h"

#include <QRegularExpression>

namespace cradle {

namespace {

QTextCharFormat inColour(const QColor &colour, bool bold = false)
{
    QTextCharFormat format;
    format.setForeground(colour);
    if (bold)
        format.setFontWeight(QFont::DemiBold);
    return format;
}

} // namespace

MarkdownHighlighter::MarkdownHighlighter(QTextDocument *document)
    : QSyntaxHighlighter(document)
{
}

void MarkdownHighlighter::highlightBlock(const QString &text)
{
    const Theme &colours = theme();
    const QString line = text.trimmed();
    const int before = std::max(previousBlockState(), 0);
    const auto whole = static_cast<int>(text.size());
    if (line.startsWith(QLatin1String("```"))) {
        setCurrentBlockState(before == Fence ? Text : Fence);
        setFormat(0, whole, inColour(colours.mutedText));
    } else if (before == Fence) {
        setCurrentBlockState(Fence);
        setFormat(0, whole, inColour(colours.success));
    } else if (line == QLatin1String("$$")) {
        setCurrentBlockState(before == Formula ? Text : Formula);
        setFormat(0, whole, inColour(colours.potential));
    } else if (before == Formula) {
        setCurrentBlockState(Formula);
        setFormat(0, whole, inColour(colours.potential));
    } else {
        setCurrentBlockState(Text);
        if (line.startsWith(QLatin1Char('#')))
            setFormat(0, whole, inColour(colours.accent, true));
        else if (line.startsWith(QLatin1String("<!--")))
            setFormat(0, whole, inColour(colours.mutedText));
        else
            colourSpans(text);
    }
}

void MarkdownHighlighter::colourSpans(const QString &text)
{
    static const QRegularExpression code(QStringLiteral("`[^`]+`"));
    static const QRegularExpression formula(QStringLiteral("\\$\\$?[^$]+\\$\\$?"));
    static const QRegularExpression strong(QStringLiteral("\\*\\*[^*]+\\*\\*"));
    static const QRegularExpression link(QStringLiteral("!?\\[[^\\]]*\\]\\([^)]*\\)"));
    const Theme &colours = theme();
    const std::pair<const QRegularExpression &, QTextCharFormat> rules[] = {
        {strong, inColour(colours.text, true)},
        {link, inColour(colours.accent)},
        {formula, inColour(colours.potential)},
        {code, inColour(colours.success)}};
    for (const auto &[pattern, format] : rules) {
        auto it = pattern.globalMatch(text);
        while (it.hasNext()) {
            const auto match = it.next();
            setFormat(static_cast<int>(match.capturedStart()),
                      static_cast<int>(match.capturedLength()), format);
        }
    }
}

} // namespace cradle
