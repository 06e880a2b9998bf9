// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSyntaxHighlighter>

namespace cradle {

/// Colours the marks of CommonMark and TeX: headings, code, formulas, links and the lines that
/// begin parts for one mode.
class MarkdownHighlighter final : public QSyntaxHighlighter
{
    Q_OBJECT
public:
    explicit MarkdownHighlighter(QTextDocument *document);

protected:
    void highlightBlock(const QString &text) override;

private:
    enum State { Text = 0, Fence = 1, Formula = 2 };

    void colourSpans(const QString &text);
};

} // namespace cradle
