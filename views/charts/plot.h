// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/charts/label_layout.h"
#include "views/charts/nice_scale.h"

#include <QChartView>
#include <QPen>

QT_BEGIN_NAMESPACE
class QLineSeries;
class QValueAxis;
QT_END_NAMESPACE

namespace cradle {

/// An axis of a Plot and what is written at it.
struct PlotAxis {
    AxisScale scale{};
    QString unit{};       ///< behind the last number of a horizontal axis
    QString name{};       ///< at its end; a horizontal axis with a name has a grid
    bool isShare = false; ///< numbers are written as %, 1 is 100 %
};

/// A line of a Plot, in the units of its axes.
struct PlotLine {
    QList<QPointF> points{};
    QPen pen{};
    bool isOverTime = true; ///< from left to right; else it may go anywhere
    bool isFilled = false;  ///< down to the filled line before it, or to zero
};

/// Lines within two axes: the base of what is drawn over time, over another quantity, and of a
/// distribution. What is beneath and above the lines, and what the keys tell, is theirs.
///
/// The wheel zooms, a drag with Shift zooms to a box, the middle button pans, a double click ends
/// the zoom; down and up go from one thing that can be told to the next, Return lets it be heard.
///
/// Lines are series of QtCharts, in px of the plot, but for dense ones: docs/decisions.md has the
/// figures. Axes, grid, areas and dense lines are drawn here, on the screen and in pictures.
class Plot : public QChartView
{
    Q_OBJECT
public:
    /// Draws what is shown, lines and all, where nothing can clip: for pictures.
    void paint(QPainter &painter) const;
    /// Shows \p text instead of lines.
    virtual void showEmpty(const QString &text);

    [[nodiscard]] bool showsRun() const { return m_showsRun; }
    [[nodiscard]] const QString &emptyText() const { return m_emptyText; }
    [[nodiscard]] QRectF plotArea() const { return m_area; } ///< px
    [[nodiscard]] double xOf(double value) const;            ///< px
    [[nodiscard]] double yOf(double value) const;            ///< px
    [[nodiscard]] QPointF placeOf(QPointF values) const;     ///< px
    [[nodiscard]] QPointF valuesAt(QPointF pixel) const;     ///< beyond the axes too
    [[nodiscard]] ValueSpan acrossSpan() const;
    [[nodiscard]] ValueSpan upSpan() const;
    /// What the keys are at, in words; empty if they are at nothing.
    [[nodiscard]] virtual QString told() const = 0;
    [[nodiscard]] QSize sizeHint() const override { return {344, 180}; }

signals:
    void pickingBegan();        ///< before the first pick of a press
    void picked(QPointF pixel); ///< a click or a drag
    void pickingEnded();        ///< the mouse was let go
    /// By the wheel, about \p values; with Control the vertical axis alone.
    void zoomed(QPointF values, double factor, bool upOnly);
    /// \p up is empty if the box is so low that it means any.
    void boxChosen(const cradle::ValueSpan &across, const std::optional<cradle::ValueSpan> &up);
    void panned(QPointF values); ///< what is shown is to move by
    void resetRequested();
    void toldChanged(); ///< told() is of something else
    /// Return was pressed: these are to be heard, at equal times.
    void played(const std::vector<double> &values);
    void resized(); ///< what is shown is to be shown anew

protected:
    /// Room around the lines, and what the pointer does there.
    struct Form {
        double topRoom = 4.0;     ///< px over the lines
        double tickHeight = 40.0; ///< px from one value to the next, at least
        bool isPicked = true;     ///< else the pointer does nothing
    };
    Plot(const Form &form, QWidget *parent);

    /// How many values the vertical axis has room for.
    [[nodiscard]] int rows() const;
    /// Finds the place of the axes and of the lines between them. The step of the horizontal axis
    /// is as its numbers have room. \param isEqual  a unit is as long on both axes
    void layOut(const PlotAxis &across, const PlotAxis &up, bool isEqual = false);
    /// Shows them; layOut() comes before.
    void showLines(const std::vector<PlotLine> &lines);

    virtual void drawUnder(QPainter &) const {} ///< beneath the lines
    virtual void drawOver(QPainter &) const {}  ///< above them
    virtual void pick(QPointF pixel, bool isPress);
    /// Goes to the next thing that can be told (1) or the one before (−1).
    /// \return whether the plot has such things
    virtual bool tellNext(int) { return false; }
    virtual void playTold() = 0; ///< lets it be heard

    /// The lines as they are drawn, column by column.
    [[nodiscard]] const std::vector<CurveProfile> &profiles() const { return m_profiles; }
    [[nodiscard]] QPointF dragStart() const { return m_dragStart; }
    [[nodiscard]] QFont smallFont() const;
    /// The middle of the pixel, where a line of one pixel is sharp.
    [[nodiscard]] static double sharp(double x);

    void drawBackground(QPainter *painter, const QRectF &rect) override;
    void drawForeground(QPainter *painter, const QRectF &rect) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    /// A line as it is drawn.
    struct DrawnLine {
        QList<QPointF> pixels;
        QPen pen;
        QPolygonF area; ///< px: below it, if it is filled
        bool isOverTime = true;
        bool isDense = false;
    };
    /// What a drag with a button does.
    enum class Drag { None, Pick, Box, Pan };

    [[nodiscard]] double stepOf(const AxisScale &across) const;
    void fillSeries();
    [[nodiscard]] QString numberAt(const PlotAxis &axis, double tick) const;
    [[nodiscard]] QList<QRectF> columnsOf(std::size_t line) const;
    void drawUpAxis(QPainter &painter) const;
    void drawAcrossAxis(QPainter &painter) const;
    void drawDense(QPainter &painter) const;
    void drawBox(QPainter &painter) const;
    void drawFocus(QPainter &painter) const;
    void chooseBox();
    [[nodiscard]] QRectF box() const; ///< px: that is dragged

    Form m_form;
    QValueAxis *m_pixelsRight;
    QValueAxis *m_pixelsDown;
    std::vector<QLineSeries *> m_series; ///< at least one to a line
    std::vector<DrawnLine> m_lines;
    std::vector<CurveProfile> m_profiles; ///< one to a line
    PlotAxis m_across;
    PlotAxis m_up;
    QRectF m_area; ///< px
    bool m_showsRun = false;
    QString m_emptyText; ///< shown instead of a run
    Drag m_drag = Drag::None;
    QPointF m_dragStart; ///< px
    QPointF m_dragEnd;   ///< px
};

} // namespace cradle
