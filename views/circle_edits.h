// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"

#include <QStringList>

#include <optional>
#include <vector>

namespace cradle {

/// Colours (six hexadecimal digits behind a \#) that colour-blind people can tell apart, as far as
/// eight can be.
[[nodiscard]] const QStringList &circleColours();

/// \p preset with one more circle: like the last one, at rest, with the next free name and
/// colour, at the free place nearest to \p at or to the middle. The result may have a fault, if
/// there is no free place.
[[nodiscard]] Preset withAddedCircle(const Preset &preset, std::optional<Vec2> at = std::nullopt);

/// \p preset with a copy of circle \p index at its end: at the same place while circles pass
/// through each other, else beside it.
[[nodiscard]] Preset withDuplicate(const Preset &preset, int index);

/// The same for all of \p indices: the copies lie to each other as the originals do, if there is
/// room for that.
[[nodiscard]] Preset withDuplicates(const Preset &preset, const std::vector<int> &indices);

/// \p preset with \p circles at its end, moved alike to the nearest free places. Names and colours
/// that are taken are changed. The result may have a fault, if there is no free place.
[[nodiscard]] Preset withPasted(const Preset &preset, std::vector<PresetCircle> circles);

/// \p preset without circle \p index.
[[nodiscard]] Preset withoutCircle(const Preset &preset, int index);
[[nodiscard]] Preset withoutCircles(const Preset &preset, const std::vector<int> &indices);

/// How far the circles \p indices can be moved alike of \p by (m): where walls reflect, only until
/// the first of them touches one.
[[nodiscard]] Vec2 withinReach(const Preset &preset, const std::vector<int> &indices, Vec2 by);

} // namespace cradle
