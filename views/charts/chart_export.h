// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QByteArray>
#include <QSize>

#include <functional>
#include <optional>

QT_BEGIN_NAMESPACE
class QMenu;
class QPainter;
class QWidget;
QT_END_NAMESPACE

namespace cradle {

/// A chart as it can be drawn anywhere.
struct ChartPicture {
    QSize size; ///< px
    QString title;
    std::function<void(QPainter &)> paint;
};

/// What can leave a chart.
struct ChartExports {
    QWidget *window; ///< that asks for the file
    std::function<ChartPicture()> picture;
    std::function<QByteArray()> table;              ///< CSV
    std::function<void(const Error &)> reportError; ///< a file could not be written
};

/// Adds the actions that copy and write what \p exports gives, enabled if there is a run.
void addExportActions(QMenu &menu, const ChartExports &exports, bool enabled);

/// Writes the picture of a chart, whole or not at all.
/// \param format  "png" (twice as fine as on the screen) or "svg"
/// \return what could not be written
[[nodiscard]] std::optional<Error> savePicture(const ChartPicture &picture, const QString &path,
                                               const QString &format);

/// Puts the picture of a chart on the clipboard.
void copyToClipboard(const ChartPicture &picture);

/// A cell of a table of comma separated values, in quotes where it needs them.
[[nodiscard]] QString csvCell(QString text);

} // namespace cradle
