// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"

#include <QAbstractListModel>

namespace cradle {

/// The lines that a program has printed in its run, as far as they are kept.
class ConsoleModel final : public QAbstractListModel
{
    Q_OBJECT
public:
    static constexpr int stepRole = Qt::UserRole; ///< that printed it
    /// Of a line that is shown; the whole of it is copied.
    static constexpr qsizetype longestLine = 1000;

    explicit ConsoleModel(const Simulation &simulation, QObject *parent = nullptr);

    /// Takes over what is new, at a cost that does not grow with how much that is.
    /// \return how many rows at the top went
    int update();
    void reload(); ///< for a run that begins anew
    void clear();  ///< leaves out what is there

    /// Characters of the longest line since the last reload() or clear(), at most longestLine.
    [[nodiscard]] qsizetype width() const { return m_width; }
    [[nodiscard]] qint64 lastStep() const; ///< of all lines; 0 if there are none
    /// The last row that was printed at \p step or before, -1 if there is none.
    [[nodiscard]] int lastRowAt(qint64 step) const;
    /// The lines of \p rows, each with its end.
    [[nodiscard]] QString text(const QList<int> &rows) const;

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;

private:
    [[nodiscard]] const ProgramNotes &notes() const { return m_simulation.notes(); }
    [[nodiscard]] qint64 newest() const; ///< the number of the next line
    /// Null if the row's line is no longer kept: until the next update().
    [[nodiscard]] const ProgramNotes::Line *line(int row) const;
    [[nodiscard]] QString toolTip(const ProgramNotes::Line &line) const;
    void measure(qint64 from);

    const Simulation &m_simulation;
    qint64 m_first = 0; ///< the number of the line in the first row, of all lines ever
    qint64 m_end = 0;   ///< past the number of the one in the last
    qsizetype m_width = 0;
};

} // namespace cradle
