// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"
#include "model/world/result.h"
#include "views/charts/chart_export.h"
#include "views/charts/time_window.h"

#include <QMargins>
#include <QPointF>
#include <QWidget>

#include <optional>

QT_BEGIN_NAMESPACE
class QHBoxLayout;
class QLabel;
class QMenu;
class QVBoxLayout;
QT_END_NAMESPACE

namespace cradle {

class FrameThrottle;
class PinnedRuns;
class Plot;
class QuietButton;

/// A plot of a run under its heading, with a menu that zooms, keeps the run and exports; a double
/// click goes back to the moment before it and ends the zoom.
class PlotPane : public QWidget
{
    Q_OBJECT
public:
    /// Lets it share the time that is shown, and runs that are kept, with others. They are
    /// borrowed.
    virtual void share(TimeWindow &window, PinnedRuns &pins);
    [[nodiscard]] TimeWindow &timeWindow() const { return *m_window; }
    [[nodiscard]] const Simulation &simulation() const { return m_simulation; }
    /// What can be done with the plot, anew for each time that it is shown.
    void fillMenu(QMenu &menu);
    /// The part of that menu which copies and writes.
    void addExports(QMenu &menu);
    /// The plot with what is written over it.
    [[nodiscard]] virtual ChartPicture picture() = 0;
    /// The numbers shown at every step within the window, as CSV.
    [[nodiscard]] virtual QByteArray table() = 0;
    [[nodiscard]] QSize sizeHint() const override { return {344, 240}; }

public slots:
    void zoomIn(); ///< about the moment shown
    void zoomOut();
    virtual void resetZoom() = 0;

signals:
    void seekRequested(double time); ///< s: a click or a drag in the plot
    void pinRequested();
    void curvePlayed(const std::vector<double> &values); ///< see Plot::played()
    void runRequested();                     ///< to go on, after a click that meant something else
    void failed(const cradle::Error &error); ///< a file could not be written

protected:
    PlotPane(const Simulation &simulation, Plot *plot, QWidget *parent);

    virtual void redraw() = 0;
    /// Sets all texts anew; called by the constructors of the panes and on a change of language.
    virtual void retranslate();
    virtual void setHeadingFont();
    /// The times that all curves take, s.
    [[nodiscard]] virtual TimeWindow::Span whole() const = 0;
    /// What is shown at the moment shown, in the units of the axes.
    [[nodiscard]] virtual QPointF placeShown() const = 0;
    /// Whether the student has zoomed the axes, besides the time that all share.
    [[nodiscard]] virtual bool isZoomed() const = 0;
    virtual void zoomBy(QPointF about, double factor, bool upOnly) = 0;

    void changeEvent(QEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

    /// Around heading and buttons, px.
    static constexpr QMargins headingMargins{14, 8, 8, 0};

    const Simulation &m_simulation;
    QLabel *m_heading;
    QHBoxLayout *m_header;
    QVBoxLayout *m_column; ///< header and plot
    QuietButton *m_moreButton;
    FrameThrottle *m_throttle;
    TimeWindow *m_window;         ///< its own, or shared
    PinnedRuns *m_pins = nullptr; ///< shared, if at all

private:
    /// The moment before a click, to which a double click goes back: it only ends the zoom.
    struct BeforeClick {
        double time = 0.0; ///< s
        bool ran = false;
    };
    void keepMoment();
    void resetByClick();

    Plot *m_base; ///< the plot
    std::optional<BeforeClick> m_beforeClick;
};

} // namespace cradle
