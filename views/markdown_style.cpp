// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/markdown_style.h"

#include "views/picture_objects.h"
#include "views/theme.h"

#include <QFontDatabase>
#include <QFontInfo>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextList>
#include <QTextTable>

#include <algorithm>
#include <array>

namespace cradle {

namespace {

constexpr double sideMargin = 12.0; ///< px, as of what stands above and below

// Distances in units of the font size.
constexpr double lineDistance = 0.22; ///< beyond the font's own, which is about 1.2
constexpr double paragraphGap = 0.6;
constexpr double headingGap = 1.1;
constexpr double itemGap = 0.2;
constexpr double listIndent = 1.5;
constexpr double codeScale = 0.92;
constexpr float lineTint = 0.3F;  ///< share of the text's colour in the lines of tables
constexpr float codeTint = 0.07F; ///< share of the text's colour in the background of code

/// The words that name the two parts of a velocity, in every language of the instructions.
constexpr std::array alongWords{u"along", u"längs", u"موازية"};
constexpr std::array acrossWords{u"across", u"quer", u"معامدة"};

/// The colour of a word that names a part of a velocity, made to be read; invalid for others.
QColor colourOf(const QString &word)
{
    const auto isWord = [&word](QStringView one) {
        return word.compare(one, Qt::CaseInsensitive) == 0;
    };
    if (std::ranges::any_of(alongWords, isWord))
        return readableOn(theme().along, theme().panel);
    if (std::ranges::any_of(acrossWords, isWord))
        return readableOn(theme().across, theme().panel);
    return {};
}

bool isCode(const QTextBlock &block)
{
    return block.blockFormat().hasProperty(QTextFormat::BlockCodeLanguage);
}

void setDistances(QTextDocument *document)
{
    const double size = fontSize(document->defaultFont());
    document->setDocumentMargin(sideMargin);
    document->setIndentWidth(listIndent * size);
    for (QTextBlock block = document->begin(); block.isValid(); block = block.next()) {
        QTextBlockFormat format = block.blockFormat();
        const bool code = isCode(block);
        if (code)
            format.setLayoutDirection(Qt::LeftToRight); // also where a comment is in Arabic
        const bool inList = block.textList() && block.next().textList();
        format.setNonBreakableLines(false);
        format.setLineHeight(code ? 0 : lineDistance * size, QTextBlockFormat::LineDistanceHeight);
        const double top = block.position() > 0 ? headingGap * size : 0;
        format.setTopMargin(format.headingLevel() > 0 ? top : 0);
        format.setBottomMargin(code ? 0 : (inList ? itemGap : paragraphGap) * size);
        format.setLeftMargin(format.leftMargin() > 0 ? listIndent * size : 0);
        format.setRightMargin(0);
        QTextCursor(block).setBlockFormat(format);
    }
}

void setFonts(QTextDocument *document)
{
    const QFont font = document->defaultFont();
    const double size = fontSize(font);
    for (QTextCursor &span : PictureObjects::spansOf(document)) {
        const int level = span.blockFormat().headingLevel();
        QTextCharFormat format = span.charFormat();
        if (format.fontItalic() && span.selectedText().isRightToLeft()) {
            // Arabic has no slanted letters, and fonts have none: they would show as boxes.
            format.setFontItalic(false);
            format.setFontWeight(QFont::DemiBold);
        }
        if (level > 0) {
            const double scale = level == 1 ? 1.25 : level == 2 ? 1.05 : 1.0;
            format.clearProperty(QTextFormat::FontSizeAdjustment);
            format.setFontPointSize(QFontInfo(font).pointSizeF() * scale);
            format.setFontWeight(QFont::DemiBold);
        } else if (isCode(span.block()) || format.fontFixedPitch()) {
            format = codeFormat(format, size);
        } else if (format.fontWeight() >= QFont::Bold && !format.isAnchor()) {
            if (const QColor colour = colourOf(span.selectedText()); colour.isValid())
                format.setForeground(colour);
        }
        span.setCharFormat(format);
    }
}

/// Puts each run of code lines into a tinted frame.
void frameCode(QTextDocument *document, const QColor &text)
{
    const double size = fontSize(document->defaultFont());
    QColor tint = text;
    tint.setAlphaF(codeTint);
    QTextBlockFormat flat; // of the empty blocks that a document needs around a frame
    flat.setLineHeight(1, QTextBlockFormat::FixedHeight);
    for (QTextBlock block = document->begin(); block.isValid(); block = block.next()) {
        if (!isCode(block) || document->frameAt(block.position()) != document->rootFrame())
            continue;
        QTextCursor lines(block);
        while (isCode(lines.block().next()))
            lines.movePosition(QTextCursor::NextBlock, QTextCursor::KeepAnchor);
        lines.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
        QTextFrameFormat frame;
        frame.setBackground(tint);
        frame.setPadding(paragraphGap * size);
        frame.setLeftMargin(block.blockFormat().indent() * document->indentWidth());
        frame.setBottomMargin(paragraphGap * size);
        const QTextFrame *framed = lines.insertFrame(frame);
        // The frame stands where the list has its text; its lines must not be moved once more.
        QTextBlockFormat inside;
        inside.setIndent(0);
        lines.setPosition(framed->firstPosition());
        lines.setPosition(framed->lastPosition(), QTextCursor::KeepAnchor);
        lines.mergeBlockFormat(inside);
        for (const int beside : {framed->firstPosition() - 1, framed->lastPosition() + 1}) {
            lines.setPosition(beside);
            if (lines.block().length() == 1)
                lines.setBlockFormat(flat);
        }
    }
}

/// Thin lines between the cells, and room in them.
void styleTables(QTextDocument *document, const QColor &text)
{
    const double size = fontSize(document->defaultFont());
    QColor line = text;
    line.setAlphaF(lineTint);
    for (QTextFrame *frame : document->rootFrame()->childFrames()) {
        auto *table = qobject_cast<QTextTable *>(frame);
        if (!table)
            continue;
        QTextTableFormat format = table->format();
        format.setBorder(1);
        format.setBorderBrush(line);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorderCollapse(true);
        format.setCellSpacing(0);
        format.setCellPadding(itemGap * size);
        format.setBottomMargin(paragraphGap * size);
        table->setFormat(format);
        for (QTextBlock block = document->findBlock(table->firstPosition());
             block.isValid() && block.position() <= table->lastPosition(); block = block.next()) {
            QTextBlockFormat inside = block.blockFormat();
            inside.setBottomMargin(0);
            QTextCursor(block).setBlockFormat(inside);
        }
    }
}

} // namespace

double fontSize(const QFont &font)
{
    return QFontInfo(font).pixelSize();
}

QTextCharFormat codeFormat(QTextCharFormat format, double size)
{
    const QString fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont).family();
    format.clearProperty(QTextFormat::FontPointSize);
    format.setProperty(QTextFormat::FontPixelSize, qRound(codeScale * size));
    format.setFontFamilies({QStringLiteral("JetBrains Mono"), fixed});
    format.setFontFixedPitch(true);
    format.setFontStyleStrategy(QFont::PreferNoShaping); // != is two signs, as they are typed
    return format;
}

void styleMarkdown(QTextDocument *document, const QColor &text)
{
    setDistances(document);
    setFonts(document);
    frameCode(document, text);
    styleTables(document, text);
}

} // namespace cradle
