// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_report/svg_picture.h"

namespace cradle {

/// One curve of a chart.
struct ChartLine {
    QString name{};
    std::vector<Vec2> points{}; ///< x rising
    SvgPicture::Pen pen{};
};

/// A chart with axes in round numbers and the names of its curves beside it.
/// \param title  what y is, with its unit: "Momentum, kg m/s"
[[nodiscard]] QByteArray chartSvg(double width, double height, const QString &title,
                                  const std::vector<ChartLine> &lines);

} // namespace cradle
