// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/report_printer.h"

#include "views/drawing_object.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QCoreApplication>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>

#include <cmath>

namespace cradle {

namespace {

struct PrinterText {
    Q_DECLARE_TR_FUNCTIONS(ReportPrinter)
};

constexpr double layoutDpi = 96.0; ///< of sizes in px
constexpr double marginMm = 18.0;  ///< on all sides
constexpr int footerText = 11;     ///< px
constexpr double footerPx = 28.0;  ///< below the text
constexpr int fineness = 1200;     ///< dots per inch that places are rounded to

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
    QTextDocument document;
    document.setUseDesignMetrics(true);
    document.setDocumentMargin(0.0);
    document.documentLayout()->registerHandler(QTextFormat::ImageObject, &drawings);
    document.setHtml(page.html);
    document.setPageSize(sheet);

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
