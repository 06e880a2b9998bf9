// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/law_names.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct LawNames {
    Q_DECLARE_TR_FUNCTIONS(LawNames)
};

} // namespace

QString nameOf(WallLaw law)
{
    return law == WallLaw::None ? LawNames::tr("None", "law for walls") : LawNames::tr("Reflect");
}

QString nameOf(CircleLaw law)
{
    switch (law) {
    case CircleLaw::None:
        return LawNames::tr("None", "law for circles");
    case CircleLaw::Stop:
        return LawNames::tr("Stop");
    case CircleLaw::SwapVelocities:
        return LawNames::tr("Swap velocities");
    case CircleLaw::SwapNormal:
        return LawNames::tr("Swap normal parts");
    case CircleLaw::Impulse:
        break;
    }
    return LawNames::tr("Impulse");
}

QString nameOf(Timing timing)
{
    switch (timing) {
    case Timing::Discrete:
        return LawNames::tr("Discrete");
    case Timing::Continuous:
        return LawNames::tr("Continuous");
    case Timing::Exact:
        break;
    }
    return LawNames::tr("Exact");
}

QString nameOf(Integrator integrator)
{
    switch (integrator) {
    case Integrator::Euler:
        return LawNames::tr("Euler");
    case Integrator::SymplecticEuler:
        return LawNames::tr("Symplectic Euler");
    case Integrator::Verlet:
        return LawNames::tr("Velocity Verlet");
    case Integrator::RungeKutta4:
        break;
    }
    return LawNames::tr("Runge-Kutta 4");
}

QString briefNameOf(Integrator integrator)
{
    switch (integrator) {
    case Integrator::SymplecticEuler:
        return LawNames::tr("S. Euler", "short for Symplectic Euler");
    case Integrator::Verlet:
        return LawNames::tr("Verlet", "short for Velocity Verlet");
    case Integrator::RungeKutta4:
        return QStringLiteral("RK4");
    case Integrator::Euler:
        break;
    }
    return nameOf(integrator);
}

} // namespace cradle
