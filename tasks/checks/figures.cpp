// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/figures.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <optional>

namespace cradle::motion {

namespace {

struct FigureText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

constexpr int enoughDigits = 4;
constexpr int mostDigits = 16; ///< where two numbers differ by no more than the last bits

QString figureOf(double value, int digits)
{
    // The rounding noise of a sum that should be zero is not worth a reader's time.
    const double size = std::abs(value);
    if (size < 1e-12)
        return QStringLiteral("0");
    // None that a circle's energy may have is written with an exponent.
    if (size < 1e6 && size >= std::pow(10.0, digits - 1))
        return QString::number(value, 'f', 0);
    return QString::number(value, 'g', digits);
}

/// With how many digits the two are not written alike; nothing if only noise of rounding is between
/// them.
std::optional<int> digitsThatTell(double value, double other)
{
    if (std::abs(value - other) <= 1e-9 * (1.0 + std::abs(other)))
        return std::nullopt;
    for (int digits = enoughDigits; digits < mostDigits; ++digits) {
        if (figureOf(value, digits) != figureOf(other, digits))
            return digits;
    }
    return std::nullopt;
}

} // namespace

QString wallName(Wall wall)
{
    switch (wall) {
    case Wall::Left:
        return FigureText::tr("left wall");
    case Wall::Right:
        return FigureText::tr("right wall");
    case Wall::Bottom:
        return FigureText::tr("floor");
    case Wall::Top:
        break;
    }
    return FigureText::tr("ceiling");
}

const char *integratorInEnglish(Integrator integrator)
{
    switch (integrator) {
    case Integrator::Euler:
        return QT_TRANSLATE_NOOP("Checks", "Euler");
    case Integrator::SymplecticEuler:
        return QT_TRANSLATE_NOOP("Checks", "symplectic Euler");
    case Integrator::Verlet:
        return QT_TRANSLATE_NOOP("Checks", "velocity Verlet");
    case Integrator::RungeKutta4:
        break;
    }
    return QT_TRANSLATE_NOOP("Checks", "Runge-Kutta 4");
}

QString integratorName(Integrator integrator)
{
    return FigureText::tr(integratorInEnglish(integrator));
}

QString figure(double value)
{
    return figureOf(value, enoughDigits);
}

QString figure(Vec2 value)
{
    return QStringLiteral("(%1, %2)").arg(figure(value.x), figure(value.y));
}

QString figureBeside(double value, double other)
{
    return figureOf(value, digitsThatTell(value, other).value_or(enoughDigits));
}

QString figureBeside(Vec2 value, Vec2 other)
{
    // As soon as one of them tells, the other has no need to.
    const int digits = std::min(digitsThatTell(value.x, other.x).value_or(mostDigits),
                                digitsThatTell(value.y, other.y).value_or(mostDigits));
    const int used = digits < mostDigits ? digits : enoughDigits;
    return QStringLiteral("(%1, %2)").arg(figureOf(value.x, used), figureOf(value.y, used));
}

} // namespace cradle::motion
