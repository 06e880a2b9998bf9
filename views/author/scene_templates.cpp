// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/scene_templates.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct TemplateText {
    Q_DECLARE_TR_FUNCTIONS(SceneTemplates)
};

/// The first comes at 2 m/s from the left, those behind it rest.
Preset striking(const QString &name, Timing timing, const std::vector<Vec2> &places)
{
    Preset preset;
    preset.name = name;
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, timing};
    for (const Vec2 place : places) {
        const bool isFirst = preset.circles.empty();
        PresetCircle circle;
        circle.name = QStringLiteral("circle %1").arg(preset.circles.size() + 1);
        circle.body.position = place;
        circle.body.velocity = isFirst ? Vec2{2.0, 0.0} : Vec2{};
        circle.colour = isFirst ? QStringLiteral("#1e90ff") : QStringLiteral("#e03131");
        preset.circles.push_back(circle);
    }
    return preset;
}

Preset gas()
{
    Preset preset = striking(TemplateText::tr("Gas"), Timing::Continuous, {});
    preset.fill = CircleFill{.count = 100, .radius = 0.1, .rmsSpeed = 2.0, .density = 1.0};
    if (const auto circles = makeCircles(*preset.fill, preset.halfWidth))
        preset.circles = *circles;
    return preset;
}

Preset drop()
{
    Preset preset = striking(TemplateText::tr("Drop"), Timing::Discrete, {{0.0, 2.0}});
    preset.circles.front().body.velocity = {};
    preset.gravity = {0.0, -9.81};
    return preset;
}

} // namespace

std::vector<Preset> sceneTemplates()
{
    return {striking(TemplateText::tr("Head-on collision"), Timing::Discrete,
                     {{-2.0, 0.0}, {2.0, 0.0}}),
            striking(TemplateText::tr("Glancing collision"), Timing::Discrete,
                     {{-2.0, 0.2}, {2.0, 0.0}}),
            striking(TemplateText::tr("Newton's cradle"), Timing::Continuous,
                     {{-2.0, 0.0}, {0.0, 0.0}, {0.4, 0.0}, {0.4 * 2, 0.0}, {0.4 * 3, 0.0}}),
            gas(), drop()};
}

} // namespace cradle
