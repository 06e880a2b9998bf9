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

    std::vector<Curve> curves{};       ///< the lowest first
    std::optional<QPointF> moment{};   ///< that is shown
    std::optional<ValueSpan> across{}; ///< the horizontal axis; else as fits
    std::optional<ValueSpan> up{};     ///< the vertical axis; else as fits
    bool isEqual = false;              ///< both axes have the same scale
    QString acrossText{};              ///< with the unit
    QString upText{};
    QColor momentColour{};
    QString told{}; ///< both values at the moment, in words, where the keys act
};

/// Curves of one quantity over another, with axes and a dot at the moment shown. The pointer does
/// what it does in a ChartPlot, and so do the keys.
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
    [[nodiscard]] QPointF valuesAt(QPointF pixel) const;
    [[nodiscard]] QRectF plotArea() const { return m_area; }
    [[nodiscard]] ValueSpan acrossSpan() const { return {m_across.low, m_across.high}; }
    [[nodiscard]] ValueSpan upSpan() const { return {m_up.low, m_up.high}; }
    [[nodiscard]] bool showsRun() const { return !m_picture.curves.empty(); }
    void paint(QPainter &painter) const;

    [[nodiscard]] QSize sizeHint() const override { return {344, 180}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 80}; }

signals:
    void pickingBegan();        ///< before the first pick of a press
    void picked(QPointF pixel); ///< a click or a drag
    /// By the wheel, about \p values: the axes by these factors.
    void zoomed(QPointF values, double across, double up);
    void boxChosen(const cradle::ValueSpan &across, const cradle::ValueSpan &up);
    void panned(QPointF values); ///< what is shown is to move by
    void resetRequested();
    void playRequested(); ///< Return was pressed: the curve is to be heard

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    /// What a drag with a button does.
    enum class Drag { None, Pick, Box, Pan };

    void layOut();
    [[nodiscard]] QRectF box() const; ///< px: that is dragged
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
    Drag m_drag = Drag::None;
    QPointF m_dragStart; ///< px
    QPointF m_dragEnd;   ///< px
};

} // namespace cradle
