// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/world.h"
#include "views/charts/hit_note.h"
#include "views/charts/label_layout.h"
#include "views/charts/min_max_pyramid.h"
#include "views/charts/nice_scale.h"
#include "views/charts/plot.h"
#include "views/charts/time_window.h"

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

/// Curves over time with hits, labels at the curves and a cursor at the moment shown. A click or a
/// drag picks a moment, or a hit that is near; down and up go from curve to curve.
class ChartPlot final : public Plot
{
    Q_OBJECT
public:
    explicit ChartPlot(QWidget *parent = nullptr);

    void showMoment(const ChartMoment &moment, const std::vector<ChartCurve> &curves,
                    const Recording &recording);
    void showEmpty(const QString &text) override;

    [[nodiscard]] const std::optional<HitNote> &note() const { return m_moment.note; }
    [[nodiscard]] QRectF noteRect() const { return m_noteRect; } ///< px; empty without a note
    [[nodiscard]] const std::vector<ChartCurve> &curves() const { return m_curves; }
    [[nodiscard]] TimeWindow::Span timeSpan() const { return {m_moment.from, m_moment.to}; }
    /// The labels shown with their places, for tests and for screen readers.
    [[nodiscard]] std::vector<std::pair<QString, QRectF>> labels() const;
    /// A curve with its value at the moment shown; empty before the plot first had the focus.
    [[nodiscard]] QString told() const override;

signals:
    void timePicked(double time); ///< a click or a drag, s
    void hitPicked(qint64 step);  ///< a click on a hit: the step where it shows

protected:
    void drawOver(QPainter &painter) const override;
    void pick(QPointF pixel, bool isPress) override;
    bool tellNext(int direction) override;
    void playTold() override;
    void focusInEvent(QFocusEvent *event) override;

private:
    /// A column of hits.
    struct HitMark {
        double x = 0.0;  ///< px
        qint64 step = 0; ///< where the first of them shows
    };

    [[nodiscard]] std::vector<PlotLine> lines();
    void placeNote();
    void placeLabels();
    void markHits(const Recording &recording);
    void drawHits(QPainter &painter) const;
    void drawLabels(QPainter &painter) const;

    std::vector<ChartCurve> m_curves;
    ChartMoment m_moment;
    int m_told = -1;        ///< index of the curve that the keys are at
    bool m_isOnHit = false; ///< the drag began on a hit and has not left it

    NoteForm m_noteForm = NoteForm::Whole;
    QRectF m_noteRect; ///< px
    LabelLayout m_layout;
    std::vector<QString> m_labelTexts;
    std::vector<QRectF> m_labelRects;
    std::vector<MinMaxPyramid::Window> m_windows; ///< the curves, as sampled
    std::vector<HitMark> m_hitMarks;
    std::vector<std::pair<double, double>> m_contacts; ///< that last, from and to px
    std::optional<double> m_nearestHit;                ///< px
};

} // namespace cradle
