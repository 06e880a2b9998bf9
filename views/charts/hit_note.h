// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/recording.h"

#include <QColor>
#include <QPainter>

#include <functional>
#include <optional>

namespace cradle {

/// What became of one quantity in a hit: a small table of each circle and of both together.
struct HitNote {
    struct Row {
        QString name;
        QColor colour;
        double before = 0.0;
        double after = 0.0;

        friend bool operator==(const Row &, const Row &) = default;
    };

    QString title; ///< which hit, and when
    QString unit;
    std::vector<Row> rows{};

    /// The greatest number in it, without its sign: what is below its rounding noise is zero.
    [[nodiscard]] double scale() const;
    /// "Hit 1 · 1.868 s: circle 1 before 522.8, after 261.4, change −261.4 kg m/s; …".
    [[nodiscard]] QString sentence() const;
    friend bool operator==(const HitNote &, const HitNote &) = default;
};

/// The first hit that begins at frame \p index, with how many more do; an index into
/// recording.encounters().
struct HitsShown {
    std::size_t first = 0;
    std::size_t count = 0;
};
[[nodiscard]] std::optional<HitsShown> hitsShownAt(const Recording &recording, qint64 index);

/// What a chart shows of a circle that moves at \p velocity (m/s), given its mass (kg), or of
/// several together: the masses and velocities of each.
using HitMeasure = std::function<double(std::span<const std::pair<double, Vec2>> bodies)>;

/// The note on the first hit that shows at frame \p index of \p recording; nullopt if none does, or
/// so many that one of them says nothing about the chart.
/// Names and colours are left empty.
[[nodiscard]] std::optional<HitNote> noteOn(const Recording &recording, qint64 index,
                                            const HitMeasure &measure);

/// The circles of the rows of such a note: one or two indices, the row of both has none.
[[nodiscard]] std::vector<std::size_t> circlesOf(const Hit &hit);

/// Whole with its title and the changes, or, where there is little room, the numbers before and
/// after alone.
enum class NoteForm { Whole, Short };

/// How large a note is in \p font, px.
[[nodiscard]] QSizeF sizeOf(const HitNote &note, NoteForm form, const QFont &font);
/// Draws it in the painter's font with its frame.
void drawNote(QPainter &painter, const HitNote &note, NoteForm form, const QRectF &rect);

} // namespace cradle
