// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/chart_export.h"

#include "model/file_io.h"

#include <QBuffer>
#include <QClipboard>
#include <QCoreApplication>
#include <QFileDialog>
#include <QGuiApplication>
#include <QImage>
#include <QMenu>
#include <QPainter>
#include <QSvgGenerator>

namespace cradle {

namespace {

struct ExportText {
    Q_DECLARE_TR_FUNCTIONS(ChartExport)
};

constexpr qreal fineness = 2.0; ///< device pixels of a picture to a pixel of the screen

QImage imageOf(const ChartPicture &picture)
{
    QImage image(picture.size * fineness, QImage::Format_RGB32);
    image.setDevicePixelRatio(fineness);
    QPainter painter(&image);
    picture.paint(painter);
    return image;
}

void askAndSavePicture(const ChartExports &exports, const QString &format)
{
    const QString filter = format == QLatin1String("svg") ? ExportText::tr("Drawings (*.svg)")
                                                          : ExportText::tr("Pictures (*.png)");
    const QString path =
        QFileDialog::getSaveFileName(exports.window, ExportText::tr("Save the chart"),
                                     QStringLiteral("chart.") + format, filter);
    if (path.isEmpty())
        return;
    if (const auto error = savePicture(exports.picture(), path, format))
        exports.reportError(*error);
}

void askAndSaveTable(const ChartExports &exports)
{
    const QString path = QFileDialog::getSaveFileName(
        exports.window, ExportText::tr("Save the numbers of the chart"),
        QStringLiteral("chart.csv"), ExportText::tr("Tables (*.csv)"));
    if (path.isEmpty())
        return;
    if (const auto error = writeFile(path, exports.table()))
        exports.reportError(*error);
}

} // namespace

void addExportActions(QMenu &menu, const ChartExports &exports, bool enabled)
{
    QWidget *context = exports.window;
    QAction *const actions[] = {
        menu.addAction(ExportText::tr("&Copy picture"), context,
                       [exports] { copyToClipboard(exports.picture()); }),
        menu.addAction(ExportText::tr("Picture as PN&G…"), context,
                       [exports] { askAndSavePicture(exports, QStringLiteral("png")); }),
        menu.addAction(ExportText::tr("Picture as &SVG…"), context,
                       [exports] { askAndSavePicture(exports, QStringLiteral("svg")); }),
        menu.addAction(ExportText::tr("&Numbers as CSV…"), context,
                       [exports] { askAndSaveTable(exports); })};
    for (QAction *action : actions)
        action->setEnabled(enabled);
}

std::optional<Error> savePicture(const ChartPicture &picture, const QString &path,
                                 const QString &format)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    if (format == QLatin1String("svg")) {
        QSvgGenerator generator;
        generator.setOutputDevice(&buffer);
        generator.setSize(picture.size);
        generator.setViewBox(QRect({}, picture.size));
        generator.setTitle(picture.title);
        QPainter painter(&generator);
        picture.paint(painter);
    } else {
        imageOf(picture).save(&buffer, "PNG");
    }
    return writeFile(path, buffer.data());
}

void copyToClipboard(const ChartPicture &picture)
{
    QGuiApplication::clipboard()->setImage(imageOf(picture));
}

QString csvCell(QString text)
{
    const bool needsQuotes = text.contains(QLatin1Char(',')) || text.contains(QLatin1Char('"'))
                             || text.contains(QLatin1Char('\n'));
    text.replace(QLatin1Char('"'), QLatin1String("\"\""));
    return needsQuotes ? QStringLiteral("\"%1\"").arg(text) : text;
}

} // namespace cradle
