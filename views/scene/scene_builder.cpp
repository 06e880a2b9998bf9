// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/scene_builder.h"

#include "model/run/simulation.h"
#include "views/circle_name.h"
#include "views/scene/ghost.h"
#include "views/scene/handles.h"
#include "views/scene/hit_parts.h"
#include "views/scene/leaving_arrow.h"
#include "views/scene/lost_circle.h"
#include "views/scene/program_drawings.h"
#include "views/scene/scene_labels.h"
#include "views/scene/trails.h"
#include "views/theme.h"

#include <QCoreApplication>
#include <QHash>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cradle {

namespace {

struct SceneText {
    Q_DECLARE_TR_FUNCTIONS(Scene)
};

constexpr double wallWidth = 2.0;       ///< px
constexpr double closestGridLines = 14; ///< px; closer ones are thinned out
constexpr double onePlace = 5.0;        ///< px that two centres are apart at most
// The radius of a disc that figures fit into, as a part of the height of their font.
constexpr double numberedDisc = 0.66; ///< two figures
constexpr double figureDisc = 0.54;   ///< one

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

/// A number in a disc has to stand out from its fill.
QColor textOn(const QColor &fill)
{
    // On a ground that is too light for white, black has more.
    constexpr double least = 4.5; // WCAG 2.1, 1.4.3
    return contrast(Qt::white, fill) >= least ? QColor(Qt::white) : QColor(Qt::black);
}

/// The name that a circle was given, or its number where it has none or only "circle N".
QString shortName(const Preset &preset, int index)
{
    const QString &name = preset.circles[static_cast<std::size_t>(index)].name;
    const auto number = static_cast<std::size_t>(index) + 1;
    const bool plain = name.isEmpty() || name == plainCircleName(number);
    return plain ? QString::number(number) : shownCircleName(name);
}

void addName(SceneDraft &draft, const SceneMoment &moment, const Circle &circle, int index,
             const QColor &colour, const SceneLook &look)
{
    const QString text = shortName(moment.preset, index);
    const double radius = circle.radius * look.camera.pixelsPerMetre();
    const int figure = labelFont(look.font, true).pixelSize();
    const bool inside =
        text.size() <= 2 && radius >= figure * (text.size() == 1 ? figureDisc : numberedDisc);
    draft.wishes.push_back({.label = {.anchor = circle.position,
                                      .text = text,
                                      .colour = inside ? textOn(colour) : theme().text,
                                      .strong = inside,
                                      .plate = !inside},
                            .direction = {0.0, -1.0},
                            .clearance = radius + 3.0,
                            .atAnchor = inside});
}

/// Arrows lie on their own disc, so they are a shade off its colour.
QColor arrowColour(const QColor &colour)
{
    return theme().dark ? colour.lighter(125) : colour.darker(120);
}

void addVelocity(SceneDraft &draft, const SceneMoment &moment, const Circle &circle,
                 const QColor &colour, bool labelled, const Camera &camera)
{
    if (circle.velocity == Vec2{})
        return;
    const Vec2 tip = arrowTip(circle.position, circle.velocity, moment.preset);
    addArrow(draft.list,
             {.from = circle.position, .to = tip, .colour = arrowColour(colour), .width = 2.5},
             camera);
    if (!labelled)
        return;
    const QString speed = QString::number(length(circle.velocity), 'f', 2);
    draft.wishes.push_back({.label = {.anchor = visiblePart({circle.position, tip}, camera).to,
                                      .text = SceneText::tr("%1 m/s").arg(speed),
                                      .colour = theme().text},
                            .direction = circle.velocity,
                            .clearance = 11.0});
}

void addRing(DrawList &list, const Circle &circle, const Camera &camera, const QColor &colour)
{
    const double radius = circle.radius + 4.0 / camera.pixelsPerMetre();
    list.discs.push_back({circle.position, radius, {}, colour, 2.0});
}

void addMarks(DrawList &list, const Circle &circle, const SceneMoment &moment,
              const SceneLook &look, bool selected)
{
    const double scale = look.camera.pixelsPerMetre();
    const QColor ring = selected ? theme().accent : faded(theme().accent, 0.5);
    addRing(list, circle, look.camera, ring);
    if (look.grips) {
        const Vec2 grip = gripPosition(circle, moment.preset, scale);
        list.discs.push_back({grip, 6.0 / scale, theme().panel, ring, 1.5});
    }
}

void addRefused(DrawList &list, const Circle &circle, const SceneMoment &moment)
{
    list.discs.push_back(
        {circle.position, circle.radius, faded(theme().warning, 0.25), theme().warning, 2.0});
    if (circle.velocity != Vec2{})
        list.arrows.push_back({.from = circle.position,
                               .to = arrowTip(circle.position, circle.velocity, moment.preset),
                               .colour = theme().warning});
}

/// Where discs lie on one another, only the topmost could show its number, and none of the others:
/// beside them stand the numbers of all.
void joinNumbers(std::vector<LabelWish> &wishes, const Camera &camera)
{
    // Numbers stand on their discs, without a plate; what programs write has one.
    const auto isNumber = [](const LabelWish &wish) { return wish.atAnchor && !wish.label.plate; };
    for (std::size_t i = 0; i < wishes.size(); ++i) {
        if (!isNumber(wishes[i]))
            continue;
        bool joined = false;
        for (std::size_t j = i + 1; j < wishes.size(); ++j) {
            const QPointF apart =
                camera.toPixels(wishes[i].label.anchor) - camera.toPixels(wishes[j].label.anchor);
            if (!isNumber(wishes[j]) || QPointF::dotProduct(apart, apart) > onePlace * onePlace)
                continue;
            joined = true;
            wishes[i].label.text += QStringLiteral(", ") + wishes[j].label.text;
            wishes[i].clearance = std::max(wishes[i].clearance, wishes[j].clearance);
            wishes.erase(wishes.begin() + static_cast<std::ptrdiff_t>(j--));
        }
        if (!joined)
            continue;
        wishes[i].label.colour = theme().text;
        wishes[i].label.plate = true;
        wishes[i].atAnchor = false;
    }
}

/// Turns the wishes of \p draft into labels.
void placeLabels(SceneDraft &draft, const SceneLook &look)
{
    SceneLabels layout(draft.list, look.camera, look.font, look.reserved);
    joinNumbers(draft.wishes, look.camera);
    // Numbers in discs first: they have only one good place.
    std::vector<LabelWish> open;
    for (LabelWish &wish : draft.wishes) {
        if (wish.atAnchor && layout.placeThere(wish.label))
            continue;
        if (wish.atAnchor && !wish.label.plate) {
            wish.label.colour = theme().text;
            wish.label.plate = true;
        }
        open.push_back(std::move(wish));
    }
    std::stable_sort(open.begin(), open.end(),
                     [](const LabelWish &x, const LabelWish &y) { return x.rank < y.rank; });
    for (const LabelWish &wish : open)
        layout.placeBeside(wish);
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
