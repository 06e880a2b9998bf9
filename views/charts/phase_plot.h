// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/charts/plot.h"

namespace cradle {

/// What a PhasePlot draws.
struct PhasePicture {
    std::vector<PlotLine> curves{};    ///< the lowest first
    std::optional<QPointF> moment{};   ///< that is shown
    std::optional<ValueSpan> across{}; ///< the horizontal axis; else as fits
    std::optional<ValueSpan> up{};     ///< the vertical axis; else as fits
    bool isEqual = false;              ///< both axes have the same scale
    QString acrossText{};              ///< with the unit
    QString upText{};
    QColor momentColour{};
    QString told{}; ///< both values at the moment, in words, where the keys act
};

/// Curves of one quantity over another, with a dot at the moment shown.
class PhasePlot final : public Plot
{
    Q_OBJECT
public:
    explicit PhasePlot(QWidget *parent = nullptr);

    void showPicture(const PhasePicture &picture);
    /// The axes are to fit anew.
    void forgetRanges();

    [[nodiscard]] const PhasePicture &picture() const { return m_picture; }
    [[nodiscard]] QString told() const override { return m_picture.told; }

signals:
    void playRequested(); ///< Return was pressed: the curve is to be heard

protected:
    void drawOver(QPainter &painter) const override;
    void playTold() override { emit playRequested(); }

private:
    PhasePicture m_picture;
    SteadyRange m_acrossRange;
    SteadyRange m_upRange;
};

} // namespace cradle
