// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/world.h"
#include "views/charts/hit_note.h"
#include "views/charts/label_layout.h"
#include "views/charts/min_max_pyramid.h"
#include "views/charts/nice_scale.h"
#include "views/charts/time_window.h"

#include <QChartView>

#include <deque>

QT_BEGIN_NAMESPACE
class QLineSeries;
class QValueAxis;
QT_END_NAMESPACE

namespace cradle {

/// A curve of a chart and how it looks.
struct ChartCurve {
    QString label;
    QString column{};        ///< what a table calls it; empty: as the label
    bool isLabelled = true;  ///< the label is written at the curve
    bool showsValue = false; ///< the value at the moment shown is written behind the label
    QColor colour;
    Qt::PenStyle dash = Qt::SolidLine;
    double width = 1.5; ///< px
    const MinMaxPyramid *samples = nullptr;
    double shift = 0.0;    ///< s: drawn so much earlier than sampled
    double lift = 0.0;     ///< drawn so much higher
    bool isFilled = false; ///< down to the filled curve before it, or to zero

    friend bool operator==(const ChartCurve &, const ChartCurve &) = default;
};

/// What of a run a chart shows.
struct ChartMoment {
    double from = 0.0;               ///< left end, s
    double to = 1.0;                 ///< right end, s
    double shown = 0.0;              ///< the moment shown, s
    SteadyRange range{};             ///< of the values
    double scale = 0.0;              ///< of the run: what is below its rounding noise is zero
    std::optional<ValueSpan> zoom{}; ///< these values are shown instead of the range
    std::optional<HitNote> note{};   ///< on the hit at the moment shown
};

/// Curves over time with axes, hits, labels at the curves and a cursor at the moment shown. A click
/// or a drag picks a moment, or a hit that is near; the wheel zooms, a drag with Shift zooms to a
/// box, the middle button pans, a double click ends the zoom.
///
/// The curves are series of QtCharts, but for those that fill their columns of pixels: QtCharts
/// makes the outline of every series for picking, at a cost of all its corners. The axes' texts and
/// grid are drawn here too: those of QtCharts are laid out as rich text again whenever a range
/// changes, which takes most of a frame.
class ChartPlot final : public QChartView
{
    Q_OBJECT
public:
    explicit ChartPlot(QWidget *parent = nullptr);

    void showMoment(const ChartMoment &moment, const std::vector<ChartCurve> &curves,
                    const Recording &recording);
    /// Draws what is shown, curves and all, where nothing can clip: for pictures.
    void paint(QPainter &painter) const;
    /// Shows \p text instead of curves.
    void showEmpty(const QString &text);

    /// Whether the mouse is held down in it.
    [[nodiscard]] bool isPicking() const { return m_drag != Drag::None; }
    [[nodiscard]] double timeAt(double x) const;  ///< s, at x px; within the axis
    [[nodiscard]] double valueAt(double y) const; ///< at y px; within the axis
    [[nodiscard]] double xOf(double time) const;  ///< px
    [[nodiscard]] double yOf(double value) const; ///< px
    [[nodiscard]] const std::optional<HitNote> &note() const { return m_moment.note; }
    [[nodiscard]] QRectF noteRect() const { return m_noteRect; } ///< px; empty without a note
    [[nodiscard]] const std::vector<ChartCurve> &curves() const { return m_curves; }
    [[nodiscard]] TimeWindow::Span timeSpan() const { return {m_moment.from, m_moment.to}; }
    [[nodiscard]] ValueSpan valueSpan() const { return {m_scale.low, m_scale.high}; }
    [[nodiscard]] bool showsRun() const { return m_showsRun; }
    [[nodiscard]] QRectF plotArea() const { return m_area; }
    /// The labels shown with their places, for tests and for screen readers.
    [[nodiscard]] std::vector<std::pair<QString, QRectF>> labels() const;
    /// The curve that the keys Up and Down are at, with its value at the moment shown; empty before
    /// the chart first had the focus.
    [[nodiscard]] QString toldCurve() const;

signals:
    void pickingBegan();                          ///< before the first pick of a press
    void timePicked(double time);                 ///< a click or a drag, s
    void hitPicked(qint64 step);                  ///< a click on a hit: the step where it shows
    void pickingEnded();                          ///< the mouse was let go
    void timeZoomed(double factor, double about); ///< by the wheel, about a time in s
    void valuesZoomed(double factor, double about);
    void boxChosen(const cradle::TimeWindow::Span &times,
                   const std::optional<cradle::ValueSpan> &values);
    void panned(double seconds, double values); ///< what is shown is to move by
    void resetRequested();
    void curveTold(); ///< toldCurve() is of another curve
    /// Return was pressed: the curve that the keys are at is to be heard, at equal times of what is
    /// shown, as far as the run has come.
    void curvePlayed(const std::vector<double> &values);
    void resized(); ///< what is shown is to be shown anew

protected:
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
    /// A column of hits.
    struct HitMark {
        double x = 0.0;  ///< px
        qint64 step = 0; ///< where the first of them shows
    };
    /// What a drag with a button does.
    enum class Drag { None, Pick, Box, Pan };

    void setCurves(const std::vector<ChartCurve> &curves);
    void layOut();
    void fillSeries();
    void placeNote();
    void placeLabels();
    void markHits(const Recording &recording);
    void drawTicks(QPainter &painter) const;
    void drawOver(QPainter &painter) const;
    void drawHits(QPainter &painter) const;
    void drawLabels(QPainter &painter) const;
    void drawAreas(QPainter &painter) const;
    void drawDense(QPainter &painter) const;
    void drawBox(QPainter &painter) const;
    void tellNext(int direction);
    void playTold();
    void pick(double x);
    void chooseBox();
    [[nodiscard]] QRectF box() const; ///< px: that is dragged
    [[nodiscard]] QFont smallFont() const;

    QValueAxis *m_timeAxis;
    QValueAxis *m_valueAxis;
    std::vector<QLineSeries *> m_series;
    std::vector<ChartCurve> m_curves;
    ChartMoment m_moment;
    AxisScale m_scale;
    QRectF m_area; ///< px
    bool m_showsRun = false;
    int m_told = -1; ///< index of the curve that the keys are at
    Drag m_drag = Drag::None;
    QPointF m_dragStart;    ///< px
    QPointF m_dragEnd;      ///< px
    bool m_isOnHit = false; ///< the drag began on a hit and has not left it
    QString m_emptyText;    ///< shown instead of a run

    NoteForm m_noteForm = NoteForm::Whole;
    QRectF m_noteRect; ///< px
    LabelLayout m_layout;
    std::vector<CurveProfile> m_profiles;
    std::vector<QString> m_labelTexts;
    std::vector<QRectF> m_labelRects;
    std::vector<MinMaxPyramid::Window> m_windows; ///< the curves, as sampled
    std::vector<QList<QPointF>> m_lines;          ///< the curves, px
    std::vector<bool> m_dense;                    ///< those that fill their columns
    std::vector<QPolygonF> m_areas;               ///< under the filled curves, px
    std::vector<HitMark> m_hitMarks;
    std::vector<std::pair<double, double>> m_contacts; ///< that last, from and to px
    std::optional<double> m_nearestHit;                ///< px
};

} // namespace cradle
