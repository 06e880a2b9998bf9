// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <vector>

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

/// A histogram of speeds with the curve of Maxwell and Boltzmann over it, axes and a legend. The
/// axis of shares reaches to twice the top of the curve; what is higher is cut off and says how
/// high it is. Down and up go from bar to bar, to faster and slower ones.
class SpeedPlot final : public QWidget
{
    Q_OBJECT
public:
    explicit SpeedPlot(QWidget *parent = nullptr);

    void showPicture(const SpeedPicture &picture);
    /// Shows \p text instead.
    void showEmpty(const QString &text);

    [[nodiscard]] bool isEmpty() const { return m_picture.shares.empty(); }
    [[nodiscard]] const SpeedPicture &picture() const { return m_picture; }
    [[nodiscard]] const QString &emptyText() const { return m_emptyText; }
    /// The bar that the keys are at, with its bounds, share and that of the curve; empty if none
    /// is.
    [[nodiscard]] QString toldBar() const;
    [[nodiscard]] QSize sizeHint() const override { return {344, 180}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 80}; }

signals:
    void barTold(); ///< toldBar() is of another bar
    /// Return was pressed: the shares are to be heard, from slow to fast.
    void barsPlayed(const std::vector<double> &shares);

protected:
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    void layOut();
    void drawAxes(QPainter &painter) const;
    void drawBars(QPainter &painter) const;
    void drawCurve(QPainter &painter) const;
    void drawLegend(QPainter &painter) const;
    [[nodiscard]] double xOf(double speed) const; ///< px
    [[nodiscard]] double yOf(double share) const; ///< px
    [[nodiscard]] double lastSpeed() const;       ///< m/s, at the right end

    SpeedPicture m_picture;
    QString m_emptyText;
    QRectF m_area;           ///< px
    int m_told = -1;         ///< index of a bar
    double m_highest = 1.0;  ///< share at the top of the plot
    double m_tickStep = 1.0; ///< of the shares
};

} // namespace cradle
