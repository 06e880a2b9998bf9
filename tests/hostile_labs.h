// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/lab_breakers.h"

namespace cradle::authoring {

/// A lab of two sound steps, of which the second is to be broken.
inline void makeLab(const QString &folder)
{
    LabFiles lab = newLab(text("two"), text("Two steps"), text("en"));
    TAKE(lab, withStepAdded(lab, text("S2"), text("Second")));
    // Not saved, which waits for the disk each time.
    for (auto it = lab.contents.begin(); it != lab.contents.end(); ++it)
        writeTo(folder + QLatin1Char('/') + it.key(), *it);
}

} // namespace cradle::authoring
