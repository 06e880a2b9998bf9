// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/camera.h"
#include "views/scene/draw_list.h"

class QFont;
class QPainter;

namespace cradle {

/// Draws lines, discs and arrows of \p list on its background, as GlPainter does.
void paintShapes(QPainter &painter, const DrawList &list, const Camera &camera);

/// Draws the labels of \p list; \p font is that of the widget. Both painters use it.
void paintLabels(QPainter &painter, const DrawList &list, const Camera &camera, const QFont &font);

} // namespace cradle
