// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/contacts/collision_detection.h"

#include <QMetaType>

namespace cradle {

inline constexpr double never = -1.0; ///< stands for "no contact" in tables of times

} // namespace cradle
