// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"

#include <QColor>
#include <QPointF>
#include <QString>

#include <vector>

namespace cradle {

/// One frame of the scene as a plain value: places in scene coordinates (m, y up), widths in
/// logical pixels. Painters draw lines, then discs, arrows and labels, each in the order given.
struct DrawList {
    struct Disc {
        Vec2 centre{};             ///< m
        double radius = 0.0;       ///< m
        QColor fill{};             ///< invalid: not filled
        QColor outline{};          ///< centred on the edge
        double outlineWidth = 0.0; ///< px; 0: none

        friend bool operator==(const Disc &, const Disc &) = default;
    };

    /// Pixels drawn and left out in turn, from the start of the line; {0, 0} is solid.
    struct Dash {
        double on = 0.0;
        double off = 0.0;

        friend bool operator==(const Dash &, const Dash &) = default;
    };

    struct Line {
        Vec2 from{}; ///< m
        Vec2 to{};   ///< m
        QColor colour{};
        double width = 1.0; ///< px
        Dash dash{};

        friend bool operator==(const Line &, const Line &) = default;
    };

    struct Arrow {
        Vec2 from{}; ///< m
        Vec2 to{};   ///< m, the tip
        QColor colour{};
        double width = 2.0; ///< of the shaft, px
        double head = 10.0; ///< length of the head, px; an arrow shorter than that is all head

        friend bool operator==(const Arrow &, const Arrow &) = default;
    };

    struct Label {
        Vec2 anchor{};    ///< m
        QPointF offset{}; ///< from the anchor, px, y down
        QString text{};
        QColor colour{};
        Qt::Alignment alignment = Qt::AlignCenter; ///< the part of the text that stands there
        bool strong = false;                       ///< semi-bold
        bool plate = true; ///< with a pale plate in the background's colour behind it

        friend bool operator==(const Label &, const Label &) = default;
    };

    QColor background{};
    std::vector<Line> lines{};
    std::vector<Disc> discs{};
    std::vector<Arrow> arrows{};
    std::vector<Label> labels{};

    friend bool operator==(const DrawList &, const DrawList &) = default;
};

/// Width of an arrow's head relative to its length.
inline constexpr double arrowHeadAspect = 0.8;

} // namespace cradle
