// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/report_printer.h"

#include "views/drawing_object.h"
#include "views/picture_objects.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QCoreApplication>
#include <QFontInfo>
#include <QPainter>
#include <QPdfWriter>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextLayout>

#include <cmath>

namespace cradle {

namespace {

struct PrinterText {
    Q_DECLARE_TR_FUNCTIONS(ReportPrinter)
};

constexpr double layoutDpi = 96.0; ///< of sizes in px
constexpr double marginMm = 16.0;  ///< on all sides
constexpr double textSize = 9.0;   ///< pt, where the page says nothing else; of headings, too
constexpr int footerText = 11;     ///< px
constexpr double footerPx = 28.0;  ///< below the text
constexpr double littleUsed = 0.4; ///< of a page, on which another section may begin
constexpr double roundedPx = 1.0;  ///< by which a layout may miss the top of a page
constexpr int fineness = 1200;     ///< dots per inch that places are rounded to
/// At equal x-height TeX's capitals and digits stand above those of other fonts.
constexpr double printedFormulaScale = 0.94;

/// A ligature has no letters of its own: "--" and "<=" would be missing where text is selected.
void withoutLigatures(QTextDocument &document)
{
    QTextCharFormat plain;
    plain.setFontStyleStrategy(QFont::PreferNoShaping);
    QTextCursor all(&document);
    all.select(QTextCursor::Document);
    all.mergeCharFormat(plain);
}

/// What the page calls "formula:N:WIDTH:HEIGHT:DEPTH", in ex, stands on the line as it is set.
void placeFormulas(QTextDocument &document, const std::vector<QByteArray> &drawings,
                   PictureObjects &pictures)
{
    for (QTextCursor &span : PictureObjects::spansOf(&document)) {
        QTextCharFormat format = span.charFormat();
        const QStringList parts = format.isImageFormat()
                                      ? format.toImageFormat().name().split(QLatin1Char(':'))
                                      : QStringList();
        const auto number = parts.value(1).toUInt();
        if (parts.size() != 5 || parts[0] != QLatin1String("formula") || number >= drawings.size())
            continue;
        Picture picture;
        picture.font = format.font().resolve(document.defaultFont());
        // Points would be those of the paper, in which the painter does not measure here.
        picture.font.setPixelSize(QFontInfo(picture.font).pixelSize());
        const double ex = QFontMetricsF(picture.font).xHeight() * printedFormulaScale;
        picture.svg = drawings[number];
        picture.beneath = format.stringProperty(QTextFormat::ImageAltText);
        picture.size = QSizeF(parts[2].toDouble(), parts[3].toDouble()) * ex;
        QTextCharFormat plain;
        plain.setForeground(QColor(0x212529));
        pictures.insertAtDepth(span, plain, picture, parts[4].toDouble() * ex);
    }
}

/// Where a page begins; all is laid out anew, for QTextDocument forgets lines where it mends a
/// part.
void setPageBreak(QTextDocument &document, const QTextBlock &block,
                  QTextFormat::PageBreakFlag policy)
{
    QTextBlockFormat format;
    format.setPageBreakPolicy(policy);
    QTextCursor(block).mergeBlockFormat(format);
    document.markContentsDirty(0, document.characterCount());
}

/// Where the first or the last line of a block ends, px from the top of all pages. A block may
/// begin above the place that its first line found.
double endOfLine(const QTextDocument &document, const QTextBlock &block, bool last)
{
    const QTextLayout &lines = *block.layout();
    const double top = document.documentLayout()->blockBoundingRect(block).top();
    return lines.lineCount() == 0
               ? top
               : top + lines.lineAt(last ? lines.lineCount() - 1 : 0).rect().bottom();
}

/// A section begins a page of its own only where the one before has used most of its last page:
/// three lines make no page, and the space below a table must not.
void fillPages(QTextDocument &document, double pageHeight)
{
    for (QTextBlock block = document.begin().next(); block.isValid(); block = block.next()) {
        if ((block.blockFormat().pageBreakPolicy() & QTextFormat::PageBreak_AlwaysBefore) == 0)
            continue;
        const double before = endOfLine(document, block.previous(), true) / pageHeight;
        const double first = endOfLine(document, block, false) / pageHeight;
        const bool isPageEmpty = std::floor(first) > std::floor(before) + 1.0;
        if (isPageEmpty || before - std::floor(before) < littleUsed)
            setPageBreak(document, block, QTextFormat::PageBreak_Auto);
    }
}

/// A heading goes to the next page with what it is about.
void keepHeadingsWithText(QTextDocument &document, double pageHeight)
{
    const auto pageOf = [&](const QTextBlock &block) {
        return std::floor((endOfLine(document, block, false) - roundedPx) / pageHeight);
    };
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        const QTextBlock next = block.next();
        if (block.blockFormat().headingLevel() > 0 && next.isValid()
            && pageOf(block) != pageOf(next))
            setPageBreak(document, block, QTextFormat::PageBreak_AlwaysBefore);
    }
}

} // namespace

QByteArray printedPdf(const LabReportPage &page, const QString &title)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(marginMm, marginMm, marginMm, marginMm),
                          QPageLayout::Millimeter);
    writer.setResolution(fineness);
    writer.setTitle(title);
    writer.setCreator(QStringLiteral("Cradle"));

    const double scale = fineness / layoutDpi;
    const QSizeF paper(writer.width() / scale, writer.height() / scale);
    const QSizeF sheet(paper.width(), paper.height() - footerPx);
    DrawingObject drawings(page.drawings);
    PictureObjects formulas(nullptr);
    QTextDocument document;
    document.setUseDesignMetrics(true);
    document.setDocumentMargin(0.0);
    document.documentLayout()->registerHandler(QTextFormat::ImageObject, &drawings);
    document.documentLayout()->registerHandler(PictureObjects::objectType, &formulas);
    QFont font(QStringList{QStringLiteral("Inter"), QStringLiteral("DejaVu Sans")});
    font.setPointSizeF(textSize);
    document.setDefaultFont(font);
    document.setHtml(page.html);
    withoutLigatures(document);
    placeFormulas(document, page.drawings, formulas);
    document.setPageSize(sheet);
    fillPages(document, sheet.height());
    keepHeadingsWithText(document, sheet.height());

    QPainter painter(&writer);
    painter.scale(scale, scale);
    const int pages = document.pageCount();
    for (int number = 0; number < pages; ++number) {
        if (number > 0)
            writer.newPage();
        painter.save();
        painter.translate(0.0, -number * sheet.height());
        const QRectF view(0.0, number * sheet.height(), sheet.width(), sheet.height());
        painter.setClipRect(view);
        QAbstractTextDocumentLayout::PaintContext context;
        context.clip = view;
        context.palette.setColor(QPalette::Text, Qt::black);
        document.documentLayout()->draw(&painter, context);
        painter.restore();
        QFont small = document.defaultFont();
        small.setPixelSize(footerText);
        painter.setFont(small);
        painter.setPen(QColor(0x5c636a));
        painter.drawText(QRectF(0.0, sheet.height(), paper.width(), footerPx),
                         Qt::AlignRight | Qt::AlignBottom,
                         PrinterText::tr("%1 of %2").arg(number + 1).arg(pages));
        painter.drawText(QRectF(0.0, sheet.height(), 0.8 * paper.width(), footerPx),
                         Qt::AlignLeft | Qt::AlignBottom, title);
    }
    painter.end();
    return buffer.data();
}

} // namespace cradle
