// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/preset_document.h"

#include <QWidget>

#include <array>

class QGridLayout;
class QLabel;

namespace cradle {

class NumberField;

/// The numbers of a preset that hold for the whole scene: gravity, restitution, timestep and the
/// size of the square.
class WorldGroup final : public QWidget
{
    Q_OBJECT
public:
    explicit WorldGroup(PresetDocument &document, QWidget *parent = nullptr);

    /// How the fields are laid out.
    enum Arrangement {
        OwnRows,   ///< one below the other
        OneColumn, ///< but the short ones at the end share a row
        TwoColumns
    };
    void arrange(Arrangement arrangement);
    /// Width that two columns need, px.
    [[nodiscard]] int twoColumnWidth() const;

signals:
    void notANumber(const QString &text);
    void reverted();

private:
    enum Field { GravityX, GravityY, Restitution, Timestep, HalfWidth, FieldCount };

    void retranslate();
    void reload();
    void showLocks();
    void propose(Field field, double value, bool spinning);
    [[nodiscard]] NumberField *at(Field field) const;

    PresetDocument &m_document;
    QLabel *m_heading = nullptr;
    std::array<NumberField *, FieldCount> m_fields{};
    std::array<QLabel *, 4> m_captions{}; ///< gravity, timestep, restitution, half width
    std::array<QWidget *, 4> m_cells{};   ///< their fields
    QLabel *m_seconds = nullptr;          ///< the timestep in decimals
    QGridLayout *m_grid = nullptr;
    int m_arrangement = -1;
};

} // namespace cradle
