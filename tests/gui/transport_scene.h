// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/action_button.h"
#include "views/transport_bar.h"

namespace cradle {

/// A circle that meets a wall after a second.
inline Preset rolling()
{
    Preset preset;
    preset.laws.walls = WallLaw::Reflect;
    PresetCircle circle;
    circle.body = {.position = {2.8, 0.0}, .velocity = {1.0, 0.0}};
    preset.circles = {circle};
    return preset;
}

/// The button that screen readers call so; nullptr if there is none.
inline ActionButton *buttonOf(const TransportBar &bar, const QString &name)
{
    for (ActionButton *button : bar.findChildren<ActionButton *>()) {
        if (button->accessibleName() == name)
            return button;
    }
    return nullptr;
}

} // namespace cradle
