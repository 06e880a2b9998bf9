// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"
#include "views/charts/curve_set.h"
#include "views/charts/exact_curves.h"

#include <map>

namespace cradle {

/// The curves of the run that goes on, which the charts share. Reads each recorded frame once,
/// keeps what the recording keeps within a bound of memory of its own, and begins anew with the
/// recording. Once a chart has told what it wants, only what is wanted is kept.
class RunCurves final : public QObject
{
    Q_OBJECT
public:
    explicit RunCurves(const Simulation &simulation, QObject *parent = nullptr,
                       qint64 maxBytes = Recording::defaultBytes);

    /// Reads the frames that are new; does nothing if there are none.
    void update();
    /// \p who needs \p groups from now on, and no longer what it wanted before.
    void want(const QObject *who, CurveGroups groups);
    /// All curves of the run, in at most \p maxBytes.
    [[nodiscard]] CurveSet whole(qint64 maxBytes) const;

    [[nodiscard]] const CurveSet &set() const { return m_set; }
    [[nodiscard]] const ExactCurves &exact() const { return m_exact; }

    [[nodiscard]] std::size_t circleCount() const { return m_set.circleCount(); }
    [[nodiscard]] const MotionCurves &circle(std::size_t index) const
    {
        return m_set.circle(index);
    }
    [[nodiscard]] const MotionCurves &sum() const { return m_set.sum(); }
    [[nodiscard]] const MinMaxPyramid &potential() const { return m_set.potential(); }
    [[nodiscard]] const MinMaxPyramid &total() const { return m_set.total(); }
    [[nodiscard]] const MinMaxPyramid &dissipated() const { return m_set.dissipated(); }
    [[nodiscard]] const MinMaxPyramid &made() const { return m_set.made(); }
    [[nodiscard]] double momentumScale() const { return m_set.momentumScale(); }
    [[nodiscard]] double energyScale() const { return m_set.energyScale(); }
    [[nodiscard]] qint64 bytes() const { return m_set.bytes(); } ///< memory held

private:
    void reset();

    const Simulation &m_simulation;
    qint64 m_maxBytes;
    CurveSet m_set;
    ExactCurves m_exact;
    qint64 m_nextFrame = 0;
    std::map<const QObject *, CurveGroups> m_wanted;
};

} // namespace cradle
