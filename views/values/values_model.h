// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"
#include "model/world/measurements.h"

#include <QAbstractTableModel>
#include <QFont>

namespace cradle {

/// The numbers of every circle at the moment shown, and their sum in the last row. They are read
/// from the recording when they are painted. The columns from Offset on are there only where the
/// exact motion runs beside the run.
class ValuesModel final : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Column {
        X,
        Y,
        VelocityX,
        VelocityY,
        Speed,
        MomentumX,
        MomentumY,
        Kinetic,
        Mass,
        Offset,       ///< distance from the exact motion
        EnergyOffset, ///< total energy more than in the exact motion
        Count
    };
    /// Characters of a number of the columns up to the speed, and of those after it.
    static constexpr int narrowPlaces = 6;
    static constexpr int widePlaces = 7;
    static constexpr int unitRole = Qt::UserRole; ///< of a column's header

    explicit ValuesModel(const Simulation &simulation, QObject *parent = nullptr);

    /// The moment shown has changed.
    void refresh(int firstRow, int lastRow);
    /// The preset, the language, the colours or the columns have changed.
    void reload();

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;
    /// The number in a cell; nullopt where there is none (the position of all together).
    [[nodiscard]] std::optional<double> number(int row, int column) const;

private:
    [[nodiscard]] int circleCount() const;
    [[nodiscard]] QString text(double value, int column) const;
    [[nodiscard]] std::optional<double> sumOf(int column) const;
    [[nodiscard]] QVariant circleHeader(int row, int role) const;

    [[nodiscard]] std::optional<double> offsetOf(const Circle &circle, int row, int column) const;

    /// Of all circles at the moment shown.
    struct Sum {
        Totals totals{};
        double mass = 0.0;                    ///< kg
        std::optional<double> energyOffset{}; ///< J
    };

    const Simulation &m_simulation;
    QFont m_font;                     ///< of the cells
    mutable std::optional<Sum> m_sum; ///< made when it is asked for
};

} // namespace cradle
