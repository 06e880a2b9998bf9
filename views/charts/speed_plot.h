// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/charts/plot.h"

namespace cradle {

/// What a SpeedPlot draws.
struct SpeedPicture {
    double binWidth = 1.0;        ///< m/s
    std::vector<double> shares{}; ///< of the circles in each bin, 0 to 1
    double shareBeyond = 0.0;     ///< faster than the last bin
    double spread = 0.0;          ///< σ of the curve, m/s
    QString barsText{};           ///< of the legend
    QString curveText{};          ///< of the legend

    friend bool operator==(const SpeedPicture &, const SpeedPicture &) = default;
};

/// A histogram of speeds with the curve of Maxwell and Boltzmann over it and a legend. The axis of
/// shares reaches to twice the top of the curve; what is higher is cut off and says how high it is.
/// Down and up go from bar to bar, to faster and slower ones.
class SpeedPlot final : public Plot
{
    Q_OBJECT
public:
    explicit SpeedPlot(QWidget *parent = nullptr);

    void showPicture(const SpeedPicture &picture);

    [[nodiscard]] const SpeedPicture &picture() const { return m_picture; }
    /// A bar with its bounds, share and that of the curve.
    [[nodiscard]] QString told() const override;

protected:
    void drawUnder(QPainter &painter) const override;
    void drawOver(QPainter &painter) const override;
    bool tellNext(int direction) override;
    void playTold() override { emit played(m_picture.shares); }

private:
    [[nodiscard]] PlotLine curve() const;
    [[nodiscard]] double lastSpeed() const; ///< m/s, at the right end

    SpeedPicture m_picture;
    int m_told = -1; ///< index of a bar
};

} // namespace cradle
