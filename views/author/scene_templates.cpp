// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/scene_templates.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct TemplateText {
    Q_DECLARE_TR_FUNCTIONS(SceneTemplates)
};

PresetCircle circle(const QString &name, Vec2 position, Vec2 velocity, const QString &colour)
{
    PresetCircle made;
    made.name = name;
    made.body.position = position;
    made.body.velocity = velocity;
    made.colour = colour;
    return made;
}

const QString blue = QStringLiteral("#1e90ff");
const QString red = QStringLiteral("#e03131");

Preset empty(SceneTemplate scene)
{
    Preset preset;
    preset.name = titleOf(scene);
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Discrete};
    return preset;
}

} // namespace

QString titleOf(SceneTemplate scene)
{
    switch (scene) {
    case SceneTemplate::HeadOn:
        return TemplateText::tr("Head-on collision");
    case SceneTemplate::Glancing:
        return TemplateText::tr("Glancing collision");
    case SceneTemplate::Cradle:
        return TemplateText::tr("Newton's cradle");
    case SceneTemplate::Gas:
        return TemplateText::tr("Gas");
    case SceneTemplate::Drop:
        break;
    }
    return TemplateText::tr("Drop");
}

Preset presetOf(SceneTemplate scene)
{
    Preset preset = empty(scene);
    const auto name = [](int index) { return QStringLiteral("circle %1").arg(index); };
    switch (scene) {
    case SceneTemplate::HeadOn:
        preset.circles = {circle(name(1), {-2.0, 0.0}, {2.0, 0.0}, blue),
                          circle(name(2), {2.0, 0.0}, {}, red)};
        break;
    case SceneTemplate::Glancing:
        preset.circles = {circle(name(1), {-2.0, 0.2}, {2.0, 0.0}, blue),
                          circle(name(2), {2.0, 0.0}, {}, red)};
        break;
    case SceneTemplate::Cradle:
        preset.laws.timing = Timing::Continuous;
        preset.circles = {circle(name(1), {-2.0, 0.0}, {2.0, 0.0}, blue)};
        for (int i = 0; i < 4; ++i)
            preset.circles.push_back(circle(name(i + 2), {0.4 * i, 0.0}, {}, red));
        break;
    case SceneTemplate::Gas: {
        preset.laws.timing = Timing::Continuous;
        preset.fill = CircleFill{.count = 100, .radius = 0.1, .rmsSpeed = 2.0, .density = 1.0};
        if (const auto circles = makeCircles(*preset.fill, preset.halfWidth))
            preset.circles = *circles;
        break;
    }
    case SceneTemplate::Drop:
        preset.gravity = {0.0, -9.81};
        preset.circles = {circle(name(1), {0.0, 2.0}, {}, blue)};
        break;
    }
    return preset;
}

} // namespace cradle
