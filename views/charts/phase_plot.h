// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/charts/nice_scale.h"

#include <QPen>
#include <QWidget>

#include <optional>
#include <vector>

namespace cradle {

/// What a PhasePlot draws.
struct PhasePicture {
    struct Curve {
        QList<QPointF> points{};
        QPen pen{};
    };

    std::vector<Curve> curves{};     ///< the lowest first
    std::optional<QPointF> moment{}; ///< that is shown
    std::optional<std::pair<double, double>>
        across{};         ///< ends of the horizontal axis; else as fits
    bool isEqual = false; ///< both axes have the same scale
    QString acrossText{}; ///< with the unit
    QString upText{};
    QColor momentColour{};
};

/// Curves of one quantity over another, with axes and a dot at the moment shown.
class PhasePlot final : public QWidget
{
    Q_OBJECT
public:
    explicit PhasePlot(QWidget *parent = nullptr);

    void showPicture(const PhasePicture &picture);
    /// Shows \p text instead.
    void showEmpty(const QString &text);
    /// The axes are to fit anew.
    void forgetRanges();

    [[nodiscard]] const PhasePicture &picture() const { return m_picture; }
    [[nodiscard]] QPointF placeOf(QPointF values) const; ///< px
    [[nodiscard]] QRectF plotArea() const { return m_area; }
    void paint(QPainter &painter) const;

    [[nodiscard]] QSize sizeHint() const override { return {344, 180}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 80}; }

signals:
    void picked(QPointF pixel); ///< a click or a drag

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;

private:
    void layOut();
    void drawAxes(QPainter &painter) const;
    void drawCurves(QPainter &painter) const;
    [[nodiscard]] QFont smallFont() const;

    PhasePicture m_picture;
    QString m_emptyText;
    SteadyRange m_acrossRange;
    SteadyRange m_upRange;
    AxisScale m_across;
    AxisScale m_up;
    QRectF m_area; ///< px
};

} // namespace cradle
