// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"
#include "views/scene/camera.h"

#include <QCoreApplication>

#include <span>
#include <vector>

namespace cradle {

/// What can be taken hold of in the scene.
struct Handle {
    enum class Kind {
        None,
        Circle,  ///< moves it
        Velocity ///< the tip of its arrow
    };

    Kind kind = Kind::None;
    int index = -1; ///< of the circle

    friend constexpr bool operator==(const Handle &, const Handle &) = default;
};

/// Metres that an arrow is long per m/s: 0.75 in the usual square of half width 4 m; with gravity
/// so much less that what has fallen through the whole square has an arrow of 1.5 half widths. It
/// does not depend on the circles, so that an arrow that is dragged stays under the pointer.
[[nodiscard]] double arrowScale(const Preset &scene);

/// The end of the arrow that stands for \p velocity at \p from: at most two half widths away.
[[nodiscard]] Vec2 arrowTip(Vec2 from, Vec2 velocity, const Preset &scene);

/// Where the velocity of \p circle is taken hold of: the tip of its arrow, but always outside
/// the circle, so that one at rest can be given a velocity.
[[nodiscard]] Vec2 gripPosition(const Circle &circle, const Preset &scene, double pixelsPerMetre);

/// The handle under \p pixel; \p velocities tells whether arrows can be taken hold of. The arrow
/// and the disc of \p selected come before others.
[[nodiscard]] Handle handleAt(QPointF pixel, std::span<const Circle> circles, const Preset &scene,
                              const Camera &camera, int selected, bool velocities);

/// "(−2.00, 2.30)", with a true minus sign.
[[nodiscard]] QString pairText(Vec2 value);

/// The name of circle \p index, or its number where it has none.
[[nodiscard]] QString circleName(const Preset &preset, int index);

/// Where circle \p index of \p preset can be at most: inside the square, touching a wall that it
/// would go through, if walls reflect; else where it is.
[[nodiscard]] Vec2 withinWalls(const Preset &preset, int index);

/// A handle on its way: what the preset would be with the pointer at a place.
class HandleDrag
{
    Q_DECLARE_TR_FUNCTIONS(HandleDrag)
public:
    static constexpr double snapStep = 0.1; ///< m or m/s

    /// \param pressed  where the pointer took hold, m
    /// \param together  circles that change along with the one that is taken hold of, by as much
    /// \param scale     arrowScale() of the scene that is seen
    HandleDrag(Handle handle, const Preset &start, Vec2 pressed, std::vector<int> together,
               double scale);

    [[nodiscard]] Handle handle() const { return m_handle; }
    [[nodiscard]] const Preset &start() const { return m_start; }
    /// The preset with the pointer at \p pointer (m); \p snap rounds to snapStep.
    [[nodiscard]] Preset candidate(Vec2 pointer, bool snap) const;
    /// Name of the edit for the undo menu.
    [[nodiscard]] QString editText() const;
    /// The same for all edits of this drag, and for no other drag.
    [[nodiscard]] QString mergeKey() const;
    /// The quantity that is dragged, with its unit.
    [[nodiscard]] QString valueText(const Preset &candidate) const;
    /// The circles that are dragged, as they are in \p candidate.
    [[nodiscard]] std::vector<Circle> dragged(const Preset &candidate) const;

private:
    void moveTo(Preset &changed, Vec2 target) const;

    Handle m_handle;
    std::vector<int> m_dragged; ///< circles
    Preset m_start;
    Vec2 m_pressed; ///< m
    double m_scale; ///< m of an arrow per m/s
    int m_serial;
};

} // namespace cradle
