// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"

#include <QAbstractTableModel>
#include <QFont>

namespace cradle {

/// The momentum of the circles of a hit, kg m/s.
struct HitMomentum {
    Vec2 before{};
    Vec2 after{};

    [[nodiscard]] Vec2 change() const { return after - before; }
};

/// Of both circles, or of the one that met a wall.
[[nodiscard]] HitMomentum momentumOf(const Hit &hit, std::span<const Circle> circles);

/// "left wall". \param wall  a Wall as an int
[[nodiscard]] QString wallName(int wall);

/// "Hit 1 at 1.868 s: momentum before 522.8, after 522.8, change 0 kg m/s." Of a momentum along x
/// only x is told, with its sign, of any other both parts.
[[nodiscard]] QString describeHit(qint64 number, const Hit &hit, std::span<const Circle> circles);

/// "Hit 1, circle 1 on the floor: in contact from 1.868 s to 2.1 s." \param until in s
[[nodiscard]] QString describeEncounter(qint64 number, const Hit &first, double until);

/// The last hits of the recording, oldest first: when, who with whom, and what became of their
/// momentum. A contact that lasts is one, with its beginning and its end.
class HitsModel final : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Column { Time, Who, Impulse, Before, After, Change, Count };
    static constexpr int unitRole = Qt::UserRole; ///< of a column's header
    static constexpr qint64 mostRows = 1000;

    explicit HitsModel(const Simulation &simulation, QObject *parent = nullptr);

    /// Takes over the hits that are new.
    void update();
    void reload();

    [[nodiscard]] qint64 hitCount() const { return m_first + m_count; } ///< since the start
    [[nodiscard]] const Hit &hit(int row) const;
    /// The row of the last hit that shows at \p step or before.
    [[nodiscard]] std::optional<int> rowAt(qint64 step) const;

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

private:
    [[nodiscard]] const Encounter &contact(int row) const;
    [[nodiscard]] QString text(const Encounter &contact, int column) const;

    const Simulation &m_simulation;
    QFont m_font;       ///< of the cells
    qint64 m_first = 0; ///< of all hits ever, the one in the first row
    qint64 m_count = 0;
};

} // namespace cradle
