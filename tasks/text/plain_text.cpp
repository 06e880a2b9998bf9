// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/text/plain_text.h"

#include <QRegularExpression>
#include <QStringList>

#include <array>
#include <functional>
#include <utility>

namespace cradle {

namespace {

/// Stands for a space of a formula, at which no line is broken.
constexpr QChar glue(0xE000);
/// Longer formulas are broken, too.
constexpr qsizetype longestGlued = 24;

struct Symbol {
    const char16_t *name;
    const char16_t *text;
};

/// The signs of mechanics that have a letter of their own; other commands keep their name.
constexpr std::array symbols{
    Symbol{u"Delta", u"Δ"},   Symbol{u"alpha", u"α"}, Symbol{u"beta", u"β"},
    Symbol{u"theta", u"θ"},   Symbol{u"mu", u"μ"},    Symbol{u"pi", u"π"},
    Symbol{u"rho", u"ρ"},     Symbol{u"omega", u"ω"}, Symbol{u"cdot", u" · "},
    Symbol{u"times", u" × "}, Symbol{u"pm", u" ± "},  Symbol{u"le", u" ≤ "},
    Symbol{u"leq", u" ≤ "},   Symbol{u"ge", u" ≥ "},  Symbol{u"geq", u" ≥ "},
    Symbol{u"ne", u" ≠ "},    Symbol{u"neq", u" ≠ "}, Symbol{u"approx", u" ≈ "},
    Symbol{u"to", u" → "},    Symbol{u"quad", u" "},  Symbol{u"left", u""},
    Symbol{u"right", u""},    Symbol{u"vec", u""},    Symbol{u"mathbf", u""},
    Symbol{u"mathrm", u""},   Symbol{u"text", u""},   Symbol{u"lVert", u"|"},
    Symbol{u"rVert", u"|"},   Symbol{u"sqrt", u"√"}};

QString symbolOf(const QString &name)
{
    for (const Symbol &symbol : symbols) {
        if (name == QStringView(symbol.name))
            return QString::fromUtf16(symbol.text);
    }
    return name + QLatin1Char(' ');
}

/// A copy of \p text in which every match has become what \p made says of it.
QString replaced(const QString &text, const QRegularExpression &pattern,
                 const std::function<QString(const QRegularExpressionMatch &)> &made)
{
    QString result;
    qsizetype done = 0;
    for (auto matches = pattern.globalMatch(text); matches.hasNext();) {
        const QRegularExpressionMatch match = matches.next();
        result += text.mid(done, match.capturedStart() - done) + made(match);
        done = match.capturedEnd();
    }
    return result + text.mid(done);
}

QString plainFormula(QString tex)
{
    static const QRegularExpression fraction(
        QStringLiteral(R"(\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\})"));
    static const QRegularExpression space(QStringLiteral(R"(\\[,;:! ]|~)"));
    static const QRegularExpression command(QStringLiteral(R"(\\([A-Za-z]+)\s*)"));
    static const QRegularExpression power(QStringLiteral(R"(\^\{?([0-9])\}?(?![0-9]))"));
    static const QRegularExpression braces(QStringLiteral(R"(\\?([{}]))"));
    const auto part = [](const QString &term) {
        static const QRegularExpression sum(QStringLiteral(R"(\S\s*[-+/]\s*\S)"));
        return term.contains(sum) ? QLatin1Char('(') + term + QLatin1Char(')') : term;
    };
    while (tex.contains(fraction)) {
        tex = replaced(tex, fraction, [&](const QRegularExpressionMatch &m) {
            return part(m.captured(1)) + QLatin1Char('/') + part(m.captured(2));
        });
    }
    tex.replace(space, QStringLiteral(" "));
    tex = replaced(tex, command,
                   [](const QRegularExpressionMatch &m) { return symbolOf(m.captured(1)); });
    tex = replaced(tex, power, [](const QRegularExpressionMatch &m) {
        return QString(QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹").at(m.captured(1).toInt()));
    });
    tex = replaced(tex, braces, [](const QRegularExpressionMatch &m) {
        return m.capturedLength() == 2 ? m.captured(1) : QString();
    });
    return tex.simplified();
}

/// Whether every brace of a formula has its other; else it is none, and stands as it was written.
bool isBalanced(QString tex)
{
    static const QRegularExpression escaped(QStringLiteral(R"(\\.)"));
    tex.remove(escaped);
    int open = 0;
    for (const QChar c : std::as_const(tex)) {
        if (c == QLatin1Char('{'))
            ++open;
        else if (c == QLatin1Char('}') && --open < 0)
            return false;
    }
    return open == 0;
}

/// One paragraph without its marks; code spans keep theirs, they say what is code.
QString plainParagraph(const QString &markdown, bool keepMarks)
{
    // In order: code span, escaped character, formula, strong, emphasis.
    static const QRegularExpression token(
        QStringLiteral(R"((?s)(?<!`)(?<code>(?<ticks>`+)(?!`).+?(?<!`)\k<ticks>(?!`)))"
                       R"(|\\(?<escaped>[!-/:-@\[-`{-~]))"
                       R"(|\$\$(?<display>[^$]+)\$\$)"
                       R"(|\$(?=\S)(?<inline>(?:\\.|[^\\$`])+)(?<=\S)\$(?![\d$]))"
                       R"(|\*\*(?=\S)(?<strong>.+?)(?<=\S)\*\*)"
                       R"(|(?<![\w*])\*(?=[^\s*])(?<emphasis>[^*]+)(?<=\S)\*(?![\w*]))"));
    return replaced(markdown, token, [&](const QRegularExpressionMatch &match) {
        const QString tex = match.captured(u"inline") + match.captured(u"display");
        if (!tex.isEmpty()) {
            if (!isBalanced(tex))
                return match.captured();
            QString formula = plainFormula(tex);
            return formula.size() > longestGlued || keepMarks
                       ? formula
                       : formula.replace(QLatin1Char(' '), glue);
        }
        if (keepMarks || !match.captured(u"code").isEmpty())
            return match.captured();
        if (!match.captured(u"escaped").isEmpty())
            return match.captured(u"escaped");
        return plainParagraph(match.captured(u"strong") + match.captured(u"emphasis"), false);
    });
}

/// Parts a text into its paragraphs, items of lists and fenced blocks, in order.
/// \param made  called with each block, whether it is code, and whether it follows closely
void forBlocks(const QString &markdown,
               const std::function<void(const QString &, bool code, bool close)> &made)
{
    static const QRegularExpression fence(QStringLiteral(R"(^\s*(```|~~~))"));
    static const QRegularExpression item(QStringLiteral(R"(^\s*(?:[-*+]|\d+[.)])\s+\S)"));
    // A number that a paragraph goes on with begins no list, unless it is 1.
    static const QRegularExpression firstItem(QStringLiteral(R"(^\s*(?:[-*+]|1[.)])\s+\S)"));
    QStringList block;
    bool inCode = false;
    bool close = false;
    const auto end = [&](bool nextIsClose) {
        if (!block.isEmpty())
            made(block.join(QLatin1Char('\n')), inCode, close);
        close = !block.isEmpty() ? nextIsClose : close && nextIsClose;
        block.clear();
    };
    for (const QString &line : markdown.split(QLatin1Char('\n'))) {
        if (line.contains(fence)) {
            end(true);
            inCode = !inCode;
        } else if (inCode) {
            block.append(line);
        } else if (line.trimmed().isEmpty()) {
            end(false);
        } else {
            const bool inList = block.isEmpty() || block.first().contains(item);
            if (line.contains(inList ? item : firstItem))
                end(true);
            block.append(line);
        }
    }
    end(false);
}

} // namespace

QString wrapped(const QString &text, int columns, const QString &first, const QString &rest)
{
    QStringList lines;
    QString line = first;
    bool empty = true;
    for (const QString &word : text.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        if (!empty && line.size() + 1 + word.size() > columns) {
            lines.append(line);
            line = rest;
            empty = true;
        }
        line += (empty ? QString() : QStringLiteral(" ")) + word;
        empty = false;
    }
    lines.append(line);
    return lines.join(QLatin1Char('\n')).replace(glue, QLatin1Char(' '));
}

QString plainText(const QString &markdown, int columns)
{
    static const QRegularExpression marker(QStringLiteral(R"(^\s*([-*+]|\d+[.)])\s+(?=\S))"));
    static const QRegularExpression heading(QStringLiteral(R"(^#{1,6}\s+)"));
    QString text;
    forBlocks(printable(markdown), [&](const QString &block, bool code, bool close) {
        if (!text.isEmpty())
            text += close ? QStringLiteral("\n") : QStringLiteral("\n\n");
        if (code) {
            for (const QString &line : block.split(QLatin1Char('\n')))
                text += (line.isEmpty() ? line : QStringLiteral("    ") + line) + QLatin1Char('\n');
            text.chop(1);
            return;
        }
        const QRegularExpressionMatch item = marker.match(block);
        const QString mark = item.hasMatch() ? item.captured(1) + QLatin1Char(' ') : QString();
        QString words = block.mid(item.hasMatch() ? item.capturedEnd() : 0);
        words = plainParagraph(words.remove(heading).simplified(), false);
        text += wrapped(words, columns, mark, QString(mark.size(), QLatin1Char(' ')));
    });
    return text;
}

QString withPlainFormulas(const QString &markdown)
{
    QString text;
    forBlocks(printable(markdown), [&](const QString &block, bool code, bool close) {
        if (!text.isEmpty())
            text += close && !code ? QStringLiteral("\n") : QStringLiteral("\n\n");
        text += code ? QStringLiteral("```\n%1\n```").arg(block) : plainParagraph(block, true);
    });
    return text;
}

QString printable(const QString &text)
{
    QString result;
    result.reserve(text.size());
    for (qsizetype i = 0; i < text.size(); ++i) {
        const QChar c = text.at(i);
        if (c.isHighSurrogate() && i + 1 < text.size() && text.at(i + 1).isLowSurrogate()) {
            result += c;
            result += text.at(++i);
        } else if (c == QLatin1Char('\n') || c == QLatin1Char('\t')
                   || (c.category() != QChar::Other_Control && !c.isSurrogate()
                       && !c.isNonCharacter())) {
            result += c;
        }
    }
    return result;
}

} // namespace cradle
