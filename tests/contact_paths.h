// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/contacts/collision_detection.h"

#include <QMetaType>

Q_DECLARE_METATYPE(cradle::Vec2)
Q_DECLARE_METATYPE(cradle::Path)

namespace cradle {

inline constexpr double never = -1.0; ///< stands for "no contact" in tables of times

} // namespace cradle
