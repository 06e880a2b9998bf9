// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/text/formula_text.h"

#include <QRegularExpression>

namespace cradle {

FormulaText findFormulas(const QString &markdown)
{
    // In order: fenced block, code span, other backticks, escaped character, formula on its own
    // line, formula in an isolate (from left to right, in Arabic text) with the word or punctuation
    // that touches it, formula within text with its unit, other dollars. (?!\n\h*\n) keeps to one
    // paragraph.
    static const QRegularExpression token(QStringLiteral(
        R"((?sm)^[\h>]*(?:(?:[-*+]|\d+[.)])\h+)?(`{3,}|~{3,})[^`\n]*\n.*?(?:^[\h>]*\1[`~]*\h*$|\z))"
        R"(|(?<!`)(`+)(?!`).+?(?<!`)\2(?!`))"
        R"(|`+)"
        R"(|\\.)"
        R"(|\$\$(?<display>(?:\\.|(?!\n\h*\n)[^\\$`])+)\$\$)"
        R"(|(?<![\p{L}\p{N}])(?<ahead>[(«]{0,2}[وفبلك]?)\x{2066}\$(?=\S))"
        R"((?<isolated>(?:\\.|(?!\n\h*\n)[^\\$`\x{2069}])+)(?<=\S)\$\x{2069}(?<behind>[،؛.:؟)»]{0,3}))"
        R"(|(?<before>[(“‘"']{0,3})\$(?=\S)(?<inline>(?:\\.|(?!\n\h*\n)[^\\$`])+)(?<=\S)\$)"
        R"((?![\d$])(?<after>(?: (?:kg m/s|kg/m³|kg m|kg|m/s²|m/s|N s|m|s|J|N|%)(?![\w/²³]))?)"
        R"([.,;:?)”’"']{0,3}))"
        R"(|\$+)"));
    FormulaText result;
    QString text = markdown;
    text.remove(QChar(0xE000))
        .remove(QChar(0xE001))
        .replace(QLatin1String("\r\n"), QLatin1String("\n"));
    qsizetype done = 0;
    for (auto tokens = token.globalMatch(text); tokens.hasNext();) {
        const QRegularExpressionMatch match = tokens.next();
        const bool display = match.capturedLength(u"display") > 0;
        const bool fromRight = match.capturedLength(u"isolated") > 0;
        const QString tex =
            match.captured(display     ? u"display"
                           : fromRight ? u"isolated"
                                       : u"inline")
                .trimmed();
        if (tex.isEmpty())
            continue;
        result.markdown += text.mid(done, match.capturedStart() - done);
        result.markdown += QChar(0xE000) + QString::number(result.formulas.size()) + QChar(0xE001);
        result.formulas.push_back({tex, match.captured(), display,
                                   match.captured(fromRight ? u"ahead" : u"before"),
                                   match.captured(fromRight ? u"behind" : u"after"), fromRight});
        done = match.capturedEnd();
    }
    result.markdown += text.mid(done);
    return result;
}

} // namespace cradle
