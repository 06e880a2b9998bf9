// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/list_numbers.h"

#include <QRegularExpression>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextList>

namespace cradle {

namespace {

constexpr int mostNumber = 1000;

/// Puts items that are not seen before the first of a list, so that it counts on from them.
void beginAt(QTextDocument *document, const QTextBlock &first, int number)
{
    QTextList *list = first.textList();
    const int position = first.position();
    for (int i = 1; i < number; ++i) {
        QTextCursor cursor(document);
        cursor.setPosition(position);
        cursor.insertBlock(first.blockFormat());
        QTextBlock hidden = document->findBlock(position);
        list->add(hidden);
        hidden.setVisible(false);
    }
}

} // namespace

QString markListNumbers(const QString &markdown)
{
    static const QRegularExpression item(
        QStringLiteral("^([ \\t>*+-]*)(\\d{1,9})([.)][ "
                       "\\t]+)(?!(?:[-+*]\\s|[#>]|```|~~~|\\d+[.)]\\s))(?=\\S)"),
        QRegularExpression::MultilineOption);
    QString marked = markdown;
    return marked.replace(item, QStringLiteral("\\1\\2\\3\uE002\\2\uE003"));
}

void applyListNumbers(QTextDocument *document)
{
    static const QRegularExpression mark(QStringLiteral("\uE002(\\d{1,9})\uE003"));
    for (QTextCursor cursor = document->find(mark, 0); !cursor.isNull();
         cursor = document->find(mark, cursor)) {
        const int number = mark.match(cursor.selectedText()).captured(1).toInt();
        const bool begins = cursor.selectionStart() == cursor.block().position();
        cursor.removeSelectedText();
        const QTextBlock block = cursor.block();
        const QTextList *list = block.textList();
        if (begins && list && list->itemNumber(block) == 0 && number <= mostNumber
            && list->format().style() == QTextListFormat::ListDecimal)
            beginAt(document, block, number);
    }
}

} // namespace cradle
