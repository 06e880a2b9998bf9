// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/chart_export.h"

#include "model/files/file_io.h"

#include <QBuffer>
#include <QClipboard>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
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

/// A file must not say that it is something else, as a drawing in chart.csv would.
std::optional<Error> suffixFault(const QString &path, const QString &format)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    static const QStringList known{QStringLiteral("png"), QStringLiteral("svg"),
                                   QStringLiteral("csv")};
    if (suffix == format || !known.contains(suffix))
        return std::nullopt;
    return Error{.message = ExportText::tr("the name ends in .%1, but this is a .%2 file; choose "
                                           "another name")
                                .arg(suffix, format),
                 .file = path};
}

/// Asks for a file; a name without an ending gets that of \p format.
QString askForFile(QWidget *window, const QString &title, const QString &format,
                   const QString &filter)
{
    QFileDialog dialog(window, title, QString(), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(format);
    dialog.selectFile(QStringLiteral("chart.") + format);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

void askAndSavePicture(const ChartExports &exports, const QString &format)
{
    const QString filter = format == QLatin1String("svg") ? ExportText::tr("Drawings (*.svg)")
                                                          : ExportText::tr("Pictures (*.png)");
    const QString path =
        askForFile(exports.window, ExportText::tr("Save the chart"), format, filter);
    if (path.isEmpty())
        return;
    if (const auto error = suffixFault(path, format))
        exports.reportError(*error);
    else if (const auto fault = savePicture(exports.picture(), path, format))
        exports.reportError(*fault);
}

void askAndSaveTable(const ChartExports &exports)
{
    const QString path = askForFile(exports.window, ExportText::tr("Save the numbers of the chart"),
                                    QStringLiteral("csv"), ExportText::tr("Tables (*.csv)"));
    if (path.isEmpty())
        return;
    if (const auto error = suffixFault(path, QStringLiteral("csv")))
        exports.reportError(*error);
    else if (const auto fault = writeFile(path, exports.table()))
        exports.reportError(*fault);
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
