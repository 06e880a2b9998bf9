// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/label_places.h"

#include "views/scene/scene_labels.h"
#include "views/theme.h"

#include <algorithm>
#include <utility>

namespace cradle {

namespace {

constexpr double onePlace = 5.0; ///< px that two centres are apart at most

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

} // namespace

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

} // namespace cradle
