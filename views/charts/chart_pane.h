// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/charts/chart_plot.h"
#include "views/charts/pinned_runs.h"
#include "views/charts/plot_pane.h"
#include "views/charts/run_curves.h"

QT_BEGIN_NAMESPACE
class QButtonGroup;
QT_END_NAMESPACE

namespace cradle {

class PinLegend;

/// A chart of a run over time with small selectors; the base of the charts of one quantity.
class ChartPane : public PlotPane
{
    Q_OBJECT
public:
    void share(TimeWindow &window, PinnedRuns &pins) override;
    [[nodiscard]] const ChartPlot &plot() const { return *m_plot; }
    [[nodiscard]] const PinLegend &legend() const { return *m_legend; }
    /// The heading as text, with the unit.
    [[nodiscard]] QString title() const;
    /// What it is of: "Momentum".
    [[nodiscard]] const QString &name() const { return m_name; }
    [[nodiscard]] const QString &unit() const { return m_unit; }
    /// The heading, what the pale curves are, and the plot.
    [[nodiscard]] ChartPicture picture() override;
    /// The numbers of the curves shown at every step within the window, as CSV.
    [[nodiscard]] QByteArray table() override;
    void resetZoom() override;

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
    void retranslate() override;
    /// \param unit  empty where there is none
    /// \param empty  what to do where there is nothing to draw
    void setTexts(const QString &heading, const QString &unit, const QString &empty);
    /// Puts \p selector on the line of the heading, left of the window's buttons.
    void addSelector(QWidget *selector);
    /// Other curves are asked for: the values' range begins anew.
    void selectionChanged();
    bool eventFilter(QObject *watched, QEvent *event) override;

    [[nodiscard]] const RunCurves &runCurves() const { return m_curves; }
    /// The colour and the name of a circle, as the preset has them.
    [[nodiscard]] QColor colourOf(std::size_t circle) const;
    [[nodiscard]] QString nameOf(std::size_t circle) const;

private:
    ChartPane(const Simulation &simulation, RunCurves &curves, ChartPlot *plot, QWidget *parent);
    QuietButton *addChoice(QButtonGroup *group);
    void wirePlot();
    void followWindow();
    void redraw() override;
    void setHeadingFont() override;
    void fitHeading();
    void putHeadingOver(bool over);
    void addPinned(std::vector<ChartCurve> &shown) const;
    void showLegend();
    void paintPicture(QPainter &painter, QSizeF size) const;
    void fitRange(const std::vector<ChartCurve> &shown, ChartMoment &moment);
    void describe();
    [[nodiscard]] std::optional<HitNote> hitNote() const;
    [[nodiscard]] double end() const; ///< of all curves, s
    [[nodiscard]] TimeWindow::Span whole() const override;
    [[nodiscard]] QPointF placeShown() const override { return {m_simulation.time(), 0.0}; }
    [[nodiscard]] bool isZoomed() const override;
    void zoomBy(QPointF about, double factor, bool upOnly) override;
    void zoomTo(const std::optional<ValueSpan> &values);

    RunCurves &m_curves;
    QuietButton *m_lastButton;
    QuietButton *m_allButton;
    PinLegend *m_legend;
    ChartPlot *m_plot;
    QString m_name;
    QString m_title; ///< the name in capitals, and the unit
    QString m_unit;
    bool m_isHeadingOver = false; ///< over the buttons
    QString m_emptyText;
    SteadyRange m_range;
    std::optional<ValueSpan> m_valueZoom;
};

} // namespace cradle
