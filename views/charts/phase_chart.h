// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"
#include "model/world/result.h"
#include "views/charts/chart_export.h"
#include "views/charts/min_max_pyramid.h"
#include "views/charts/nice_scale.h"
#include "views/charts/phase_quantity.h"
#include "views/charts/time_window.h"

#include <QWidget>

#include <deque>

QT_BEGIN_NAMESPACE
class QLabel;
class QMenu;
QT_END_NAMESPACE

namespace cradle {

class FrameThrottle;
class Menu;
class PhasePlot;
struct PhasePicture;
class PinnedRuns;
class QuietButton;

/// Any quantity of a run against any other, over the time that the charts show. Against time it is
/// drawn however long the run is, against others its newest 20,000 steps. Its window title is the
/// title of its tab, in the language.
class PhaseChart final : public QWidget
{
    Q_OBJECT
public:
    static constexpr qint64 mostSteps = 20'000;

    explicit PhaseChart(const Simulation &simulation, QWidget *parent = nullptr);

    /// Lets it share the time that is shown, and runs that are kept. They are borrowed.
    void share(TimeWindow &window, PinnedRuns &pins);
    /// The student's choice: no scene changes it any more.
    void setAxes(const PhaseVariable &up, const PhaseVariable &across);
    [[nodiscard]] const PhaseVariable &up() const { return m_up; }
    [[nodiscard]] const PhaseVariable &across() const { return m_across; }
    [[nodiscard]] const PhasePlot &plot() const { return *m_plot; }
    /// For pictures.
    [[nodiscard]] ChartPicture picture() const;
    /// Both quantities at every step within the window, as CSV.
    [[nodiscard]] QByteArray table() const;
    /// What can be done with the chart, anew for each time that it is shown.
    void fillMenu(QMenu &menu);
    void addExports(QMenu &menu);
    [[nodiscard]] QSize sizeHint() const override { return {344, 240}; }

public slots:
    void zoomIn(); ///< about the moment shown
    void zoomOut();
    void resetZoom();

signals:
    void seekRequested(double time);
    /// Return was pressed in the plot: its vertical quantity is to be heard, at equal times.
    void curvePlayed(const std::vector<double> &values);
    void runRequested(); ///< to go on, after a click that meant something else
    void failed(const cradle::Error &error);

protected:
    void changeEvent(QEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

private:
    /// A step of the run as it is drawn.
    struct Sample {
        double time = 0.0; ///< s
        QPointF values{};
    };

    void retranslate();
    void reset();
    void read();
    void redraw();
    void suggest();
    [[nodiscard]] QString told() const;
    void play();
    void changed();
    void seekNear(QPointF pixel);
    void wirePlot();
    void zoomBy(QPointF about, double across, double up);
    void panBy(QPointF way);
    [[nodiscard]] bool isOverTime() const { return m_across.quantity == Quantity::Time; }
    [[nodiscard]] double pinnedEnd() const; ///< s
    [[nodiscard]] TimeWindow::Span whole() const;
    [[nodiscard]] TimeWindow::Span timesShown() const; ///< where the horizontal axis is the time
    void fillAxisMenu(Menu &menu, PhaseVariable &axis);
    void addPinned(PhasePicture &picture, double from, double to) const;
    [[nodiscard]] std::optional<QPointF> pointAt(qint64 index) const;
    [[nodiscard]] QColor colour() const;

    /// The moment before a click, to which a double click goes back: it only ends the zoom.
    struct BeforeClick {
        double time = 0.0; ///< s
        bool ran = false;
    };
    void keepMoment();
    void resetByClick();

    const Simulation &m_simulation;
    std::optional<BeforeClick> m_beforeClick;
    TimeWindow *m_window = nullptr;
    PinnedRuns *m_pins = nullptr;
    QLabel *m_heading;
    QLabel *m_against;
    QuietButton *m_upButton;
    QuietButton *m_acrossButton;
    QuietButton *m_moreButton;
    PhasePlot *m_plot;
    FrameThrottle *m_throttle;
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
