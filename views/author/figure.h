// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace cradle {

class SceneView;

/// What \p scene shows, as a square SVG in the light colours of print, without marks of selection
/// and pointer.
[[nodiscard]] QByteArray figureOf(const SceneView &scene);

} // namespace cradle
