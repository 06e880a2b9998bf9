// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/runs/observation.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace cradle {

/// The moment of a run that tells most: the first hit of two circles, else of a wall, else one
/// second after the start.
struct TellingMoment {
    qint64 index = 0;  ///< of the frame
    double time = 0.0; ///< s
    enum class Kind { Circles, Wall, Time } kind = Kind::Time;
};
[[nodiscard]] TellingMoment tellingMoment(const Observation &run);

/// Σ p_x and Σ p_y over time; and kinetic, potential and total energy. Drawings of 420 × 150 px.
[[nodiscard]] QByteArray momentumSvg(const Observation &run);
[[nodiscard]] QByteArray energySvg(const Observation &run);

/// The energy of a run over time, relative to that at its start.
struct EnergyCurve {
    QString name;             ///< of the step
    std::vector<Vec2> points; ///< time in s, E / E₀
};
/// \return no points if there is no energy at the start, or it is not finite
[[nodiscard]] EnergyCurve energyCurve(const QString &name, const Observation &run);
/// All of them in one chart, 640 × 320 px.
[[nodiscard]] QByteArray energiesSvg(const std::vector<EnergyCurve> &curves);

} // namespace cradle
