// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"
#include "views/charts/chart_export.h"
#include "views/charts/chart_plot.h"
#include "views/charts/pinned_runs.h"
#include "views/charts/run_curves.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QHBoxLayout;
class QLabel;
class QMenu;
QT_END_NAMESPACE

namespace cradle {

class FrameThrottle;
class PinLegend;
class QuietButton;

/// A chart of a run with its heading and small selectors; the base of the charts of one quantity.
class ChartPane : public QWidget
{
    Q_OBJECT
public:
    /// Lets this chart share the time that is shown, and runs that are kept, with others. They are
    /// borrowed.
    void share(TimeWindow &window, PinnedRuns &pins);
    [[nodiscard]] TimeWindow &timeWindow() const { return *m_window; }
    [[nodiscard]] const ChartPlot &plot() const { return *m_plot; }
    [[nodiscard]] const PinLegend &legend() const { return *m_legend; }
    /// The heading as text, with the unit.
    [[nodiscard]] QString title() const;
    /// What it is of: "Momentum".
    [[nodiscard]] const QString &name() const { return m_name; }
    [[nodiscard]] const QString &unit() const { return m_unit; }
    /// What can be done with the chart, anew for each time that it is shown.
    void fillMenu(QMenu &menu);
    /// The part of that menu which copies and writes.
    void addExports(QMenu &menu);

    /// The heading, what the pale curves are, and the plot.
    [[nodiscard]] ChartPicture picture();
    /// The numbers of the curves shown at every step within the window, as CSV.
    [[nodiscard]] QByteArray table();
    [[nodiscard]] const Simulation &simulation() const { return m_simulation; }
    [[nodiscard]] QSize sizeHint() const override { return {344, 240}; }

public slots:
    void zoomIn(); ///< the time, about the moment shown
    void zoomOut();
    void resetZoom();

signals:
    void seekRequested(double time); ///< s: a click or a drag in the chart
    void pinRequested();
    void curvePlayed(const std::vector<double> &values); ///< see Plot::played()
    void runRequested();                     ///< to go on, after a click that meant something else
    void failed(const cradle::Error &error); ///< a file could not be written

protected:
    /// \param curves  shared by the charts; outlives this one
    ChartPane(const Simulation &simulation, RunCurves &curves, QWidget *parent);

    /// What it draws of the run that goes on, besides the total energy.
    [[nodiscard]] virtual CurveGroups wanted() const { return {}; }
    /// Reads what is new of the run. \return whether there is something to draw
    [[nodiscard]] virtual bool readRun();
    /// What is drawn at this moment, the most important first.
    [[nodiscard]] virtual std::vector<ChartCurve> curves() const = 0;
    /// The same of a run that is kept; none where that makes no sense.
    [[nodiscard]] virtual std::vector<ChartCurve> curvesOf(const PinnedRun &run) const;
    /// What the chart shows of circles in a hit; null where it has no such quantity.
    [[nodiscard]] virtual HitMeasure hitMeasure() const { return {}; }
    /// The name of that, with its unit.
    [[nodiscard]] virtual QString hitQuantity() const { return m_unit; }
    /// The scale of the run, in the unit of the chart.
    [[nodiscard]] virtual double scale() const = 0;
    /// Sets all texts anew; called by the constructors of the charts and on a change of language.
    virtual void retranslate();
    /// \param unit  empty where there is none
    /// \param empty  what to do where there is nothing to draw
    void setTexts(const QString &heading, const QString &unit, const QString &empty);
    /// Puts \p selector on the line of the heading, left of the window's buttons.
    void addSelector(QWidget *selector);
    /// Other curves are asked for: the values' range begins anew.
    void selectionChanged();
    void changeEvent(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;

    [[nodiscard]] const RunCurves &runCurves() const { return m_curves; }
    /// The colour and the name of a circle, as the preset has them.
    [[nodiscard]] QColor colourOf(std::size_t circle) const;
    [[nodiscard]] QString nameOf(std::size_t circle) const;

private:
    void wirePlot();
    void followWindow();
    void redraw();
    void setHeadingFont();
    void fitHeading();
    void addPinned(std::vector<ChartCurve> &shown) const;
    void showLegend();
    void paintPicture(QPainter &painter, QSizeF size) const;
    void fitRange(const std::vector<ChartCurve> &shown, ChartMoment &moment);
    void describe();
    [[nodiscard]] std::optional<HitNote> hitNote() const;
    [[nodiscard]] double end() const; ///< of all curves, s
    [[nodiscard]] TimeWindow::Span whole() const;
    void zoomTo(const std::optional<ValueSpan> &values);

    /// The moment before a click, to which a double click goes back: it only ends the zoom.
    struct BeforeClick {
        double time = 0.0; ///< s
        bool ran = false;
    };
    void keepMoment();
    void resetByClick();

    const Simulation &m_simulation;
    std::optional<BeforeClick> m_beforeClick;
    RunCurves &m_curves;
    QLabel *m_heading;
    QHBoxLayout *m_header;
    QuietButton *m_lastButton;
    QuietButton *m_allButton;
    QuietButton *m_moreButton;
    PinLegend *m_legend;
    ChartPlot *m_plot;
    FrameThrottle *m_throttle;
    QString m_name;
    QString m_title; ///< the name in capitals, and the unit
    QString m_unit;
    QString m_emptyText;
    SteadyRange m_range;
    TimeWindow *m_window;         ///< its own, or shared
    PinnedRuns *m_pins = nullptr; ///< shared, if at all
    std::optional<ValueSpan> m_valueZoom;
};

} // namespace cradle
