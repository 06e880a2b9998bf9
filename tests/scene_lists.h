// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/scene_builder.h"
#include "views/scene/scene_labels.h"

#include <QStringList>

#include <algorithm>
#include <vector>

namespace cradle::scenes {

/// Two steel circles of 0.2 m; the first comes with 2 m/s, the second rests 0.3 m lower.
inline Preset twoCircles()
{
    Preset preset;
    preset.laws = {WallLaw::Reflect, CircleLaw::SwapNormal, Timing::Discrete};
    preset.circles = {
        {.name = QStringLiteral("circle 1"),
         .body = {.position = {-2.0, 2.3}, .velocity = {2.0, 0.0}}},
        {.name = QStringLiteral("circle 2"),
         .body = {.position = {2.0, 2.0}},
         .colour = QStringLiteral("#e03131")},
    };
    return preset;
}

inline SceneLook lookAt(const Preset &preset, QSizeF viewport = {700.0, 700.0})
{
    SceneLook look;
    look.camera.fit(preset.halfWidth);
    look.camera.resize(viewport);
    return look;
}

inline QStringList texts(const DrawList &list)
{
    QStringList found;
    for (const DrawList::Label &label : list.labels)
        found << label.text;
    return found;
}

/// The arrow of \p colour, none if there is none; thin ones tell what was before a hit.
inline DrawList::Arrow arrowOf(const DrawList &list, const QColor &colour)
{
    const auto found = std::find_if(list.arrows.begin(), list.arrows.end(), [&](const auto &arrow) {
        return arrow.colour == colour && arrow.width > 1.25;
    });
    return found == list.arrows.end() ? DrawList::Arrow{} : *found;
}

inline bool near(Vec2 a, Vec2 b, double tolerance = 1e-9)
{
    return length(a - b) <= tolerance;
}

/// Whether labels cover each other.
inline bool textOverText(const DrawList &list, const Camera &camera, const QFont &font)
{
    std::vector<QRectF> rects;
    for (const DrawList::Label &label : list.labels)
        rects.push_back(labelRect(label, camera, QFontMetricsF(labelFont(font, label.strong))));
    for (std::size_t i = 0; i < rects.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (rects[i].intersects(rects[j]))
                return true;
        }
    }
    return false;
}

} // namespace cradle::scenes
