// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/scene_builder.h"

#include "model/run/simulation.h"
#include "views/scene/circle_marks.h"
#include "views/scene/ghost.h"
#include "views/scene/hit_parts.h"
#include "views/scene/label_places.h"
#include "views/scene/lost_circle.h"
#include "views/scene/program_drawings.h"
#include "views/scene/trails.h"
#include "views/theme.h"

#include <QHash>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr double wallWidth = 2.0;       ///< px
constexpr double closestGridLines = 14; ///< px; closer ones are thinned out
bool isCrowd(const SceneMoment &moment)
{
    return moment.preset.circles.size() > crowdSize;
}

void addGrid(DrawList &list, const Camera &camera)
{
    double spacing = 1.0; // m
    for (int i = 0; spacing * camera.pixelsPerMetre() < closestGridLines; ++i)
        spacing *= i % 2 == 0 ? 5.0 : 2.0;
    const Vec2 low = camera.toMetres({0.0, camera.viewport().height()});
    const Vec2 high = camera.toMetres({camera.viewport().width(), 0.0});
    for (double x = std::ceil(low.x / spacing) * spacing; x <= high.x; x += spacing)
        list.lines.push_back({{x, low.y}, {x, high.y}, theme().grid, 1.0, {}});
    for (double y = std::ceil(low.y / spacing) * spacing; y <= high.y; y += spacing)
        list.lines.push_back({{low.x, y}, {high.x, y}, theme().grid, 1.0, {}});
}

void addSquare(DrawList &list, const SceneMoment &moment, const Camera &camera)
{
    const double h = moment.preset.halfWidth;
    const double corner = h + wallWidth / 2 / camera.pixelsPerMetre(); // closes the corners
    for (const double side : {-h, h}) {
        list.lines.push_back({{-corner, side}, {corner, side}, theme().square, wallWidth, {}});
        list.lines.push_back({{side, -corner}, {side, corner}, theme().square, wallWidth, {}});
    }
}

/// The colour of each circle; circles of a crowd share a few.
std::vector<QColor> circleColours(const Preset &preset)
{
    QHash<QString, QColor> known;
    std::vector<QColor> colours;
    colours.reserve(preset.circles.size());
    for (const PresetCircle &circle : preset.circles) {
        auto found = known.constFind(circle.colour);
        if (found == known.constEnd())
            found = known.insert(circle.colour, circleColour(circle.colour));
        colours.push_back(*found);
    }
    return colours;
}

} // namespace

SceneMoment::SceneMoment(const Preset &scene, const Recording &run, qint64 index, bool isRunning)
    : preset(scene)
    , recording(run)
    , current(index)
    , running(isRunning)
{
}

SceneMoment::SceneMoment(const Simulation &simulation)
    : SceneMoment(simulation.preset(), simulation.recording(), simulation.current(),
                  simulation.isRunning())
{
    drawings = simulation.notes().drawings(recording.step(current));
}

DrawList buildScene(const SceneMoment &moment, const SceneOptions &options, const SceneLook &look)
{
    SceneDraft draft;
    DrawList &list = draft.list;
    list.background = theme().scene;
    if (options.grid)
        addGrid(list, look.camera);
    addSquare(list, moment, look.camera);

    const std::vector<QColor> colours = circleColours(moment.preset);
    if (options.trails)
        addTrails(list, moment, colours, look);

    const auto circles = moment.recording.circles(moment.current);
    const std::vector<ShownHit> hits =
        options.hitParts ? shownHits(moment, look.selected) : std::vector<ShownHit>{};
    for (const ShownHit &hit : hits)
        addHitParts(draft, moment, hit, look.camera);
    // While a hit stands still, the arrows of what it did to the circles would lie on its own.
    const auto standsInHit = [&](int index) {
        return !moment.running
               && std::any_of(hits.begin(), hits.end(), [index](const ShownHit &shown) {
                      const Hit &hit = *shown.hit;
                      return hit.a == index || (hit.kind == Hit::Kind::Circle && hit.b == index);
                  });
    };
    for (int i = 0; i < static_cast<int>(circles.size()); ++i) {
        const auto at = static_cast<std::size_t>(i);
        const bool marked = i == look.selected || i == look.hovered;
        list.discs.push_back(
            {circles[at].position, circles[at].radius, colours[at], theme().scene, 1.0});
        const bool told = marked || !isCrowd(moment);
        if (told && isLost(circles[at], look.camera)) {
            addPointer(draft, circles[at], shortName(moment.preset, i), colours[at], look.camera);
            continue;
        }
        if (options.names && told)
            addName(draft, moment, circles[at], i, colours[at], look);
        if (options.velocities && told && !standsInHit(i))
            addVelocity(draft, moment, circles[at], colours[at], marked, look.camera);
    }
    for (LabelWish &wish : draft.wishes) {
        if (!hits.empty() && wish.rank == nameRank)
            wish.mostCost = crampedCost / 2;
    }
    const auto isSelected = [&](int i) {
        return i == look.selected
               || std::find(look.selection.begin(), look.selection.end(), i)
                      != look.selection.end();
    };
    for (const int i : look.selection) {
        if (i != look.selected && i != look.hovered)
            addRing(list, circles[static_cast<std::size_t>(i)], look.camera, theme().accent);
    }
    const int hovered = look.hovered == look.selected ? -1 : look.hovered;
    for (const int i : {hovered, look.selected}) {
        if (i >= 0 && i < static_cast<int>(circles.size()))
            addMarks(list, circles[static_cast<std::size_t>(i)], moment, look, isSelected(i));
    }
    for (const Circle &circle : look.refused)
        addRefused(list, circle, moment);
    if (options.centreOfMass)
        addCentreOfMass(draft, moment, look.camera.pixelsPerMetre());
    addGhosts(draft, moment, colours, look.camera);
    const auto drawings = options.programDrawings ? moment.drawings : std::span<const Drawing>{};
    addDrawnTexts(draft, drawings, look.camera);
    if (drawings.size() <= manyDrawings)
        addDrawnShapes(list, drawings, look.camera);
    placeLabels(draft, look);
    if (drawings.size() > manyDrawings)
        addDrawnShapes(list, drawings, look.camera);
    return list;
}

} // namespace cradle
