// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/program_drawings.h"

#include "views/scene/slab_clip.h"
#include "views/theme.h"

#include <optional>

namespace cradle {

namespace {

constexpr double lineWidth = 2.0;   ///< px
constexpr double pointRadius = 4.0; ///< px
constexpr double tipClearance = 11.0;
constexpr double textClearance = 4.0;
constexpr double beyond = 100.0;      ///< px outside the scene that are still drawn
constexpr qsizetype longestText = 60; ///< characters
constexpr int textRank = 1;           ///< what the student writes comes before names

/// The part of a line that can be seen.
struct Segment {
    Vec2 from{};
    Vec2 to{};
    bool wholeTip = true; ///< its end is not cut off
};

/// Painters cannot take places that are astronomically far off.
std::optional<Segment> visiblePart(Vec2 from, Vec2 to, const Camera &camera)
{
    const Vec2 low = camera.toMetres({-beyond, camera.viewport().height() + beyond});
    const Vec2 high = camera.toMetres({camera.viewport().width() + beyond, -beyond});
    const Vec2 along = to - from;
    const auto part = isFinite(along) ? partInside(from, along, low, high) : std::nullopt;
    if (!part)
        return std::nullopt;
    return Segment{part->enter > 0.0 ? from + part->enter * along : from,
                   part->leave < 1.0 ? from + part->leave * along : to, part->leave >= 1.0};
}

QString shownText(const QString &text)
{
    const QString line = text.left(4 * longestText).simplified();
    return line.size() > longestText ? line.left(longestText - 1) + QChar(0x2026) : line;
}

} // namespace

QColor drawingColour(const QString &name)
{
    // An unknown name would be told on the console at every frame.
    const QColor colour = QColor::isValidColorName(name) ? QColor(name) : QColor();
    return colour.isValid() && colour.alpha() > 0 ? circleColour(colour.name()) : theme().text;
}

void addLineAbove(DrawList &list, Vec2 from, Vec2 to, const QColor &colour, double width)
{
    list.arrows.push_back({.from = from, .to = to, .colour = colour, .width = width, .head = 0.0});
}

void addDrawnShapes(DrawList &list, std::span<const Drawing> drawings, const Camera &camera)
{
    for (const Drawing &drawing : drawings) {
        const QColor colour = drawingColour(drawing.colour);
        switch (drawing.kind) {
        case Drawing::Kind::Arrow:
        case Drawing::Kind::Line:
            if (const auto part = visiblePart(drawing.from, drawing.to, camera)) {
                addLineAbove(list, part->from, part->to, colour, lineWidth);
                if (drawing.kind == Drawing::Kind::Arrow && part->wholeTip)
                    list.arrows.back().head = DrawList::Arrow{}.head;
            }
            break;
        case Drawing::Kind::Point:
            list.discs.push_back(
                {drawing.from, pointRadius / camera.pixelsPerMetre(), colour, theme().scene, 1.0});
            break;
        case Drawing::Kind::Text:
            break;
        }
    }
}

void addDrawnTexts(SceneDraft &draft, std::span<const Drawing> drawings, const Camera &camera)
{
    const QRectF scene({}, camera.viewport());
    std::size_t count = 0;
    for (const Drawing &drawing : drawings) {
        const bool isArrow = drawing.kind == Drawing::Kind::Arrow;
        const Vec2 anchor = isArrow ? drawing.to : drawing.from;
        const QString text = shownText(drawing.text);
        if (text.isEmpty() || !scene.contains(camera.toPixels(anchor)))
            continue;
        if (++count > manyDrawings)
            return;
        const QColor colour = readableOn(drawingColour(drawing.colour), theme().scene);
        LabelWish wish{.label = {.anchor = anchor, .text = text, .colour = colour},
                       .direction = {0.0, 1.0},
                       .clearance = textClearance,
                       .atAnchor = true,
                       .rank = textRank};
        if (isArrow) {
            wish.direction = drawing.to - drawing.from;
            wish.clearance = tipClearance;
            wish.atAnchor = false;
            wish.elsewhere = 0.5 * (drawing.from + drawing.to);
        }
        draft.wishes.push_back(std::move(wish));
    }
}

} // namespace cradle
