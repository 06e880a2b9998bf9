// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/circle_marks.h"

#include "model/run/simulation.h"
#include "views/circle_name.h"
#include "views/scene/handles.h"
#include "views/scene/leaving_arrow.h"
#include "views/scene/scene_labels.h"
#include "views/theme.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct SceneText {
    Q_DECLARE_TR_FUNCTIONS(Scene)
};

// The radius of a disc that figures fit into, as a part of the height of their font.
constexpr double numberedDisc = 0.66; ///< two figures
constexpr double figureDisc = 0.54;   ///< one

/// A number in a disc has to stand out from its fill.
QColor textOn(const QColor &fill)
{
    // On a ground that is too light for white, black has more.
    constexpr double least = 4.5; // WCAG 2.1, 1.4.3
    return contrast(Qt::white, fill) >= least ? QColor(Qt::white) : QColor(Qt::black);
}

/// Arrows lie on their own disc, so they are a shade off its colour.
QColor arrowColour(const QColor &colour)
{
    return theme().dark ? colour.lighter(125) : colour.darker(120);
}

} // namespace

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

} // namespace cradle
