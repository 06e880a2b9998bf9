// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/markdown_html.h"

#include "tasks/text/formula_text.h"
#include "tasks/text/plain_text.h"

#include <QRegularExpression>
#include <QStringList>

namespace cradle {

namespace {

/// Emphasis and code within a line of which everything else is text.
QString inlineHtml(const QString &text)
{
    QString html;
    const QStringList parts = text.split(QLatin1Char('`'));
    static const QRegularExpression strong(QStringLiteral("\\*\\*([^*]+)\\*\\*"));
    static const QRegularExpression emphasis(
        QStringLiteral("(?<![\\w*])[*_]([^*_\\s](?:[^*_]*[^*_\\s])?)[*_](?![\\w*])"));
    for (qsizetype i = 0; i < parts.size(); ++i) {
        QString part = parts[i].toHtmlEscaped();
        const bool isCode = i % 2 == 1 && i + 1 < parts.size();
        if (isCode) {
            html += QStringLiteral("<code>%1</code>").arg(part);
            continue;
        }
        part.replace(strong, QStringLiteral("<b>\\1</b>"));
        part.replace(emphasis, QStringLiteral("<i>\\1</i>"));
        html += (i % 2 == 1 ? QStringLiteral("`") : QString()) + part;
    }
    return html;
}

/// Reads line by line what block it belongs to.
class Reader
{
public:
    QString read(const QString &markdown)
    {
        for (const QString &line : markdown.split(QLatin1Char('\n')))
            take(line);
        if (m_inCode)
            m_html += QStringLiteral("</pre>\n");
        endBlock();
        return m_html;
    }

private:
    void take(const QString &line)
    {
        static const QRegularExpression heading(QStringLiteral("^(#{1,6})\\s+(.*)$"));
        static const QRegularExpression item(
            QStringLiteral("^\\s*(?:([-*+])|\\d{1,9}[.)])\\s+(.*)$"));
        if (line.trimmed().startsWith(QLatin1String("```"))) {
            endBlock();
            m_inCode = !m_inCode;
            m_html += m_inCode ? QStringLiteral("<pre>") : QStringLiteral("</pre>\n");
        } else if (m_inCode) {
            m_html += line.toHtmlEscaped() + QLatin1Char('\n');
        } else if (line.trimmed().isEmpty()) {
            endBlock();
        } else if (const auto title = heading.match(line); title.hasMatch()) {
            endBlock();
            m_html += QStringLiteral("<h4>%1</h4>\n").arg(inlineHtml(title.captured(2)));
        } else if (const auto point = item.match(line); point.hasMatch()) {
            const QString list =
                point.captured(1).isEmpty() ? QStringLiteral("ol") : QStringLiteral("ul");
            if (m_list != list)
                endBlock();
            if (m_list.isEmpty())
                m_html += QStringLiteral("<%1>\n").arg(list);
            m_list = list;
            m_html += QStringLiteral("<li>%1</li>\n").arg(inlineHtml(point.captured(2)));
        } else {
            if (!m_list.isEmpty())
                endBlock();
            m_paragraph.append(line.trimmed());
        }
    }

    void endBlock()
    {
        if (!m_paragraph.isEmpty())
            m_html +=
                QStringLiteral("<p>%1</p>\n").arg(inlineHtml(m_paragraph.join(QLatin1Char(' '))));
        m_paragraph.clear();
        if (!m_list.isEmpty())
            m_html += QStringLiteral("</%1>\n").arg(m_list);
        m_list.clear();
    }

    QString m_html{};
    QStringList m_paragraph{};
    QString m_list{}; ///< the element of the open list; empty: none
    bool m_inCode = false;
};

} // namespace

QString markdownHtml(const QString &markdown, const FormulaHtml &formula)
{
    const FormulaText found = findFormulas(printable(markdown));
    const QRegularExpression marks(QStringView(FormulaText::markPattern).toString());
    const auto replaced = [&marks](const QString &text, const auto &byNumber) {
        QString result;
        qsizetype done = 0;
        for (auto each = marks.globalMatch(text); each.hasNext();) {
            const QRegularExpressionMatch mark = each.next();
            result += text.mid(done, mark.capturedStart() - done)
                      + byNumber(mark.captured(1).toUInt(), mark.captured());
            done = mark.capturedEnd();
        }
        return result + text.mid(done);
    };
    QStringList set;
    for (const FormulaSource &source : found.formulas)
        set.append(formula ? formula(source.tex, source.display) : QString());
    // What cannot be set goes back, to become plain text.
    const QString text = replaced(found.markdown, [&](uint number, const QString &mark) {
        return set[number].isEmpty() ? found.formulas[number].markdown : mark;
    });
    static const QRegularExpression alone(QStringLiteral("<p>(?=\\x{E000}[0-9]+\\x{E001}</p>)"));
    QString html = Reader().read(withPlainFormulas(text));
    html.replace(alone, QStringLiteral("<p align=\"center\">"));
    return replaced(html, [&](uint number, const QString &) {
        const FormulaSource &source = found.formulas[number];
        return source.before.toHtmlEscaped() + set[number] + source.after.toHtmlEscaped();
    });
}

} // namespace cradle
