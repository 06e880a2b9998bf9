// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"
#include "views/charts/speed_distribution.h"

#include <QElapsedTimer>
#include <QWidget>

QT_BEGIN_NAMESPACE
class QLabel;
QT_END_NAMESPACE

namespace cradle {

class FrameThrottle;
class SentenceLabel;
class SpeedPlot;

/// How fast the circles are, beside how fast those of a gas in equilibrium would be; and how far
/// one is from the other. The bars are a mean over the last second of the run, the distance is of
/// the moment shown. Its window title is the title of its tab, in the language.
class SpeedHistogram final : public QWidget
{
    Q_OBJECT
public:
    /// Fewer circles tell nothing of a distribution.
    static constexpr std::size_t fewestCircles = 20;
    /// The bars are a mean over so long, s.
    static constexpr double meanSeconds = 1.0;

    explicit SpeedHistogram(const Simulation &simulation, QWidget *parent = nullptr);

    [[nodiscard]] const SpeedPlot &plot() const { return *m_plot; }
    [[nodiscard]] QString sentence() const; ///< how far, and whether that may be chance
    [[nodiscard]] QSize sizeHint() const override { return {344, 240}; }

signals:
    void curvePlayed(const std::vector<double> &shares); ///< see Plot::played()

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void redraw();
    void describe();
    void retranslate();
    void setHeadingFont();
    void showDistribution(const GasState &gas);
    [[nodiscard]] SpeedBins binsOf(const GasState &gas) const;
    [[nodiscard]] std::span<const Circle> circles() const; ///< at the moment shown

    const Simulation &m_simulation;
    QLabel *m_heading;
    SpeedPlot *m_plot;
    SentenceLabel *m_sentence;
    FrameThrottle *m_throttle;
    QElapsedTimer m_sinceSentence; ///< it was last told
};

} // namespace cradle
