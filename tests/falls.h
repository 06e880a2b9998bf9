// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/scenes.h"

#include <QTest>

namespace cradle::scenes {

/// A row for every integrator, restitution and height from which a circle comes to rest on the
/// floor.
inline void addFalls()
{
    QTest::addColumn<Integrator>("integrator");
    QTest::addColumn<double>("restitution");
    QTest::addColumn<double>("height"); // of the rim above the floor at the start, m
    for (const Integrator integrator : allIntegrators) {
        for (const double e : {0.0, 0.5, 0.9}) {
            for (const double height : {0.0, 3.8}) {
                QTest::addRow("%s, e = %g, from %g m", shortName(integrator), e, height)
                    << integrator << e << height;
            }
        }
    }
}

} // namespace cradle::scenes
