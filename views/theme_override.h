// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/theme.h"

namespace cradle {

/// While it lives, theme() is another one: for a picture that is drawn for print. Widgets must not
/// be painted meanwhile.
class ThemeOverride
{
public:
    explicit ThemeOverride(const Theme &other);
    ~ThemeOverride();
    ThemeOverride(const ThemeOverride &) = delete;
    ThemeOverride &operator=(const ThemeOverride &) = delete;

private:
    const Theme *m_before;
};

} // namespace cradle
