// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/charts/min_max_pyramid.h"
#include "views/charts/nice_scale.h"
#include "views/charts/phase_quantity.h"
#include "views/charts/plot_pane.h"

#include <deque>

namespace cradle {

class Menu;
class PhasePlot;
struct PhasePicture;

/// Any quantity of a run against any other, over the time that the charts show. Against time it is
/// drawn however long the run is, against others its newest 20,000 steps. Its window title is the
/// title of its tab, in the language.
class PhaseChart final : public PlotPane
{
    Q_OBJECT
public:
    static constexpr qint64 mostSteps = 20'000;

    explicit PhaseChart(const Simulation &simulation, QWidget *parent = nullptr);

    /// The student's choice: no scene changes it any more.
    void setAxes(const PhaseVariable &up, const PhaseVariable &across);
    [[nodiscard]] const PhaseVariable &up() const { return m_up; }
    [[nodiscard]] const PhaseVariable &across() const { return m_across; }
    [[nodiscard]] const PhasePlot &plot() const { return *m_plot; }
    [[nodiscard]] ChartPicture picture() override;
    /// Both quantities at every step within the window, as CSV.
    [[nodiscard]] QByteArray table() override;
    void resetZoom() override;

private:
    /// A step of the run as it is drawn.
    struct Sample {
        double time = 0.0; ///< s
        QPointF values{};
    };

    void retranslate() override;
    void reset();
    void read();
    void redraw() override;
    void suggest();
    [[nodiscard]] QString told() const;
    void play();
    void changed();
    void seekNear(QPointF pixel);
    void wirePlot();
    void zoomBy(QPointF about, double factor, bool upOnly) override;
    void panBy(QPointF way);
    [[nodiscard]] bool isOverTime() const { return m_across.quantity == Quantity::Time; }
    [[nodiscard]] double pinnedEnd() const; ///< s
    [[nodiscard]] TimeWindow::Span whole() const override;
    [[nodiscard]] QPointF placeShown() const override;
    [[nodiscard]] bool isZoomed() const override;
    [[nodiscard]] TimeWindow::Span timesShown() const; ///< where the horizontal axis is the time
    [[nodiscard]] TimeWindow::Span spanShown() const;  ///< of the run alone
    void fillAxisMenu(Menu &menu, PhaseVariable &axis);
    void addPinned(PhasePicture &picture, double from, double to) const;
    [[nodiscard]] std::optional<QPointF> pointOf(const PhaseMoment &moment,
                                                 const Preset &preset) const;
    [[nodiscard]] std::optional<QPointF> pointAt(qint64 index) const;
    [[nodiscard]] QColor colour() const;

    PhaseChart(const Simulation &simulation, PhasePlot *plot, QWidget *parent);

    QLabel *m_against;
    QuietButton *m_upButton;
    QuietButton *m_acrossButton;
    PhasePlot *m_plot;
    PhaseVariable m_up{Quantity::VelocityX, 0};
    PhaseVariable m_across{Quantity::X, 0};
    bool m_isChosen = false; ///< by the student
    std::deque<Sample> m_samples;
    MinMaxPyramid m_overTime; ///< where the horizontal axis is the time
    qint64 m_nextFrame = 0;
    std::optional<ValueSpan> m_acrossZoom; ///< never of the time, which the charts share
    std::optional<ValueSpan> m_upZoom;
};

} // namespace cradle
