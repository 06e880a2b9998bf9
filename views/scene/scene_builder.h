// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/program.h"
#include "model/run/recording.h"
#include "views/scene/camera.h"
#include "views/scene/draw_list.h"

#include <QFont>
#include <QRectF>

#include <span>
#include <vector>

namespace cradle {

class Simulation;

/// What the scene shows besides circles and square.
struct SceneOptions {
    bool velocities = true;      ///< an arrow at each circle
    bool trails = true;          ///< the way of the last 1.5 s, fading
    bool grid = true;            ///< lines 1 m apart
    bool names = true;           ///< a number or a name at each circle
    bool hitParts = true;        ///< at a hit: the normal, velocities before and after, the parts
    bool programDrawings = true; ///< what the program draws in the step
    bool momenta = true;         ///< an inset with all momenta tip to tail; not in the DrawList
    bool centreOfMass = false;   ///< of all circles, with its way
    bool loupe = true;           ///< at a hit, its place enlarged in a corner; not in the DrawList

    friend bool operator==(const SceneOptions &, const SceneOptions &) = default;
};

/// The moment that is drawn; borrows.
struct SceneMoment {
    const Preset &preset;
    const Recording &recording;
    qint64 current; ///< index into the recording
    bool running;   ///< hits then fade instead of staying while their step is shown
    std::span<const Drawing> drawings{}; ///< of a program, in this step
    std::span<const Circle> exact{};     ///< where the exact motion has the circles; empty: none
    std::vector<Circle> ghost{};         ///< where another run has them; empty: none
    QString ghostLabel{};                ///< a word for what that run is

    SceneMoment(const Preset &scene, const Recording &run, qint64 index, bool isRunning);
    explicit SceneMoment(const Simulation &simulation);
};

/// How it is looked at.
struct SceneLook {
    Camera camera{};
    QFont font{};      ///< of the widget; labels are a little smaller
    int selected = -1; ///< index of a circle, -1: none
    int hovered = -1;
    bool grips = false;             ///< velocities of selected and hovered can be dragged
    std::vector<Circle> refused{};  ///< where a drag wants circles that cannot be there
    std::vector<QRectF> reserved{}; ///< px: covered by chips, so labels stay clear of them
    std::vector<int> selection{};   ///< all circles that are marked as selected
};

/// With more circles than this, only the selected and the hovered one have labels, arrows and
/// trails.
inline constexpr std::size_t crowdSize = 50;

/// s that a trail reaches back, and that a hit fades while running
inline constexpr double trailSeconds = 1.5;
inline constexpr double hitSeconds = 0.4;

/// Everything that one frame of the scene shows, in the colours of theme().
[[nodiscard]] DrawList buildScene(const SceneMoment &moment, const SceneOptions &options,
                                  const SceneLook &look);

} // namespace cradle
