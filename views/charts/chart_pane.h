// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/charts/chart_plot.h"
#include "views/charts/run_curves.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QHBoxLayout;
class QLabel;
QT_END_NAMESPACE

namespace cradle {

class FrameThrottle;
class QuietButton;

/// A chart of a run with its heading and small selectors; the base of the charts of one quantity.
class ChartPane : public QWidget
{
    Q_OBJECT
public:
    /// How much of the run is shown.
    enum class Window { LastSeconds, All };
    static constexpr double lastSeconds = 10.0;

    void setWindow(Window window);
    [[nodiscard]] Window window() const { return m_window; }
    [[nodiscard]] const ChartPlot &plot() const { return *m_plot; }
    [[nodiscard]] QSize sizeHint() const override { return {344, 240}; }

signals:
    void seekRequested(double time); ///< s: a click or a drag in the chart

protected:
    /// \param curves  shared by the charts; outlives this one
    ChartPane(const Simulation &simulation, RunCurves &curves, QWidget *parent);

    /// Reads what is new of the run. \return whether there is something to draw
    [[nodiscard]] virtual bool readRun();
    /// What is drawn at this moment, the most important first.
    [[nodiscard]] virtual std::vector<ChartCurve> curves() const = 0;
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

    [[nodiscard]] const Simulation &simulation() const { return m_simulation; }
    [[nodiscard]] const RunCurves &runCurves() const { return m_curves; }
    /// The colour and the name of a circle, as the preset has them.
    [[nodiscard]] QColor colourOf(std::size_t circle) const;
    [[nodiscard]] QString nameOf(std::size_t circle) const;

private:
    void redraw();
    void setHeadingFont();
    void fitRange(const std::vector<ChartCurve> &shown, ChartMoment &moment);
    void chooseWindow(double first, double last, ChartMoment &moment);

    const Simulation &m_simulation;
    RunCurves &m_curves;
    QLabel *m_heading;
    QHBoxLayout *m_header;
    QuietButton *m_lastButton;
    QuietButton *m_allButton;
    ChartPlot *m_plot;
    FrameThrottle *m_throttle;
    QString m_emptyText;
    SteadyRange m_range;
    Window m_window = Window::All;
    double m_windowStart = 0.0; ///< of Window::LastSeconds, s
};

} // namespace cradle
