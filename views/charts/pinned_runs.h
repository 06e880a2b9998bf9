// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/charts/curve_set.h"
#include "views/charts/run_difference.h"

#include <QObject>

namespace cradle {

/// A run that is kept to be compared with later ones.
struct PinnedRun {
    int number = 0; ///< from 1
    RunSource source;
    /// The moment of it at which the later run starts, s; 0 where both start alike.
    double branch = 0.0;
    CurveSet curves;     ///< as recorded
    Recording recording; ///< its newest part, within a bound of memory

    /// What the run that goes on does otherwise, in one line.
    [[nodiscard]] QString text(const RunSource &now) const;
    /// All of it, a line each.
    [[nodiscard]] QString details(const RunSource &now) const;
    /// "pinned 1".
    [[nodiscard]] QString name() const;
};

/// The runs that are kept, at most three.
class PinnedRuns final : public QObject
{
    Q_OBJECT
public:
    static constexpr std::size_t most = 3;
    /// Memory that the curves of one may hold, and its recording.
    static constexpr qint64 curveBytes = 16 * 1024 * 1024;
    static constexpr qint64 recordingBytes = 16 * 1024 * 1024;

    using QObject::QObject;

    [[nodiscard]] const std::vector<PinnedRun> &runs() const { return m_runs; }
    [[nodiscard]] bool isFull() const { return m_runs.size() >= most; }
    /// When the last of them ends, as the charts draw it, s; 0 without any.
    [[nodiscard]] double end() const;

    /// What the run that goes on comes from.
    [[nodiscard]] const RunSource &now() const { return m_now; }
    void setNow(const RunSource &source);
    /// What is kept of a run; it has no number yet.
    [[nodiscard]] static PinnedRun keep(const CurveSet &curves, const Recording &recording,
                                        const RunSource &source, double branch = 0.0);
    /// Adds a run. Where there are as many as may be, the oldest goes.
    void add(PinnedRun run);
    void remove(int number);
    void clear();

signals:
    void changed();

private:
    [[nodiscard]] int freeNumber() const;

    std::vector<PinnedRun> m_runs;
    RunSource m_now;
};

/// The dash of all curves of pinned run \p number.
[[nodiscard]] Qt::PenStyle pinDash(int number);

/// The newest frames and hits of \p recording that \p maxBytes hold.
[[nodiscard]] Recording newestPart(const Recording &recording, qint64 maxBytes);

} // namespace cradle
