// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world.h"
#include "views/charts/label_layout.h"
#include "views/charts/min_max_pyramid.h"
#include "views/charts/nice_scale.h"

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
    bool showsValue = false; ///< the value at the moment shown is written behind the label
    QColor colour;
    Qt::PenStyle dash = Qt::SolidLine;
    double width = 1.5; ///< px
    const MinMaxPyramid *samples = nullptr;

    friend bool operator==(const ChartCurve &, const ChartCurve &) = default;
};

/// What of a run a chart shows.
struct ChartMoment {
    double from = 0.0;   ///< left end, s
    double to = 1.0;     ///< right end, s
    double shown = 0.0;  ///< the moment shown, s
    SteadyRange range{}; ///< of the values
    double scale = 0.0;  ///< of the run: what is below its rounding noise is zero
};

/// Curves over time with axes, hits, labels at the curves and a cursor at the moment shown.
///
/// The curves are series of QtCharts. The axes' texts and grid are drawn here: those of QtCharts
/// are laid out as rich text again whenever a range changes, which takes most of a frame.
class ChartPlot final : public QChartView
{
    Q_OBJECT
public:
    explicit ChartPlot(QWidget *parent = nullptr);

    void showMoment(const ChartMoment &moment, const std::vector<ChartCurve> &curves,
                    const std::deque<Hit> &hits);
    /// Shows \p text instead of curves.
    void showEmpty(const QString &text);

    /// Whether the mouse is held down in it.
    [[nodiscard]] bool isPicking() const { return m_isPicking; }
    [[nodiscard]] double timeAt(double x) const; ///< s, at x px; within the axis
    [[nodiscard]] QRectF plotArea() const { return m_area; }
    /// The labels shown with their places, for tests and for screen readers.
    [[nodiscard]] std::vector<std::pair<QString, QRectF>> labels() const;

signals:
    void timePicked(double time); ///< a click or a drag, s
    void pickingEnded();          ///< the mouse was let go

protected:
    void drawBackground(QPainter *painter, const QRectF &rect) override;
    void drawForeground(QPainter *painter, const QRectF &rect) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void setCurves(const std::vector<ChartCurve> &curves);
    void layOut();
    void fillSeries();
    void placeLabels();
    void markHits(const std::deque<Hit> &hits);
    void drawTicks(QPainter &painter) const;
    void drawHits(QPainter &painter) const;
    void drawLabels(QPainter &painter) const;
    [[nodiscard]] double xOf(double time) const;
    [[nodiscard]] double yOf(double value) const;
    [[nodiscard]] QFont smallFont() const;

    QValueAxis *m_timeAxis;
    QValueAxis *m_valueAxis;
    std::vector<QLineSeries *> m_series;
    std::vector<ChartCurve> m_curves;
    ChartMoment m_moment;
    AxisScale m_scale;
    QRectF m_area; ///< px
    bool m_showsRun = false;
    bool m_isPicking = false;
    QString m_emptyText; ///< shown instead of a run

    LabelLayout m_layout;
    std::vector<CurveProfile> m_profiles;
    std::vector<QString> m_labelTexts;
    std::vector<QRectF> m_labelRects;
    std::vector<double> m_hitMarks;     ///< px
    std::optional<double> m_nearestHit; ///< px
};

} // namespace cradle
