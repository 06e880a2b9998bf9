// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/law_names.h"
#include "views/preset_document.h"

#include <QAbstractTableModel>

namespace cradle {

/// The circles of a preset as a table, one row each. Setting a cell is an undoable edit of the
/// preset; it fails if that would be an impossible scene.
class CircleTableModel final : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Column {
        Colour,
        Name,
        X,
        Y,
        VelocityX,
        VelocityY,
        Radius,
        Density,
        IntegratorColumn,
        Mass,
        ColumnCount
    };
    static constexpr int unitRole = Qt::UserRole;         ///< of a header: m/s
    static constexpr int spinningRole = Qt::UserRole + 1; ///< to set: one of a row of edits

    /// \param document  must outlive the model
    explicit CircleTableModel(PresetDocument &document, QObject *parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;
    /// Role Qt::EditRole or spinningRole; the value is a double, a name, a colour or the
    /// Integrator as an int.
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;

    /// Whether a column holds a number that can be edited.
    [[nodiscard]] static bool isNumber(int column) { return column >= X && column <= Density; }
    [[nodiscard]] QString unitOf(int column) const;
    /// What Up adds to a number of the column.
    [[nodiscard]] static double spinStep(int column);
    /// The column of a JSON pointer as /circles/3/velocity/1; Name if it is of the whole circle.
    [[nodiscard]] static int columnOf(const QString &pointer);
    /// What a cell shows of it.
    [[nodiscard]] QString integratorCell(Integrator integrator) const
    {
        return m_isBrief ? briefNameOf(integrator) : nameOf(integrator);
    }
    /// Lets cells and headers abbreviate what is long, where room is scarce.
    void setBrief(bool brief) { m_isBrief = brief; }
    [[nodiscard]] bool isBrief() const { return m_isBrief; }

    /// Marks the cell of a JSON pointer as the one at fault; an empty pointer marks none.
    void setFault(const QString &pointer);

public slots:
    void reload();      ///< the preset changed
    void retranslate(); ///< the language changed

private:
    [[nodiscard]] static QString symbolOf(int column);
    [[nodiscard]] QString whyLocked(const QModelIndex &index) const;
    [[nodiscard]] bool isFault(const QModelIndex &index) const;
    [[nodiscard]] QVariant text(const PresetCircle &circle, int column) const;
    [[nodiscard]] QVariant value(const PresetCircle &circle, int column) const;

    PresetDocument &m_document;
    int m_rows = 0;
    bool m_isBrief = false;
    int m_faultRow = -1;
    int m_faultColumn = -1;
};

} // namespace cradle
