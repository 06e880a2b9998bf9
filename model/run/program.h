// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/world.h"

#include <QString>

#include <optional>
#include <vector>

namespace cradle {

/// A variable of a program and what it holds, as text.
struct ProgramValue {
    QString name;
    QString value;

    friend bool operator==(const ProgramValue &, const ProgramValue &) = default;
};

/// Why a program stopped, and where.
struct ProgramError {
    enum class Kind {
        Syntax,  ///< it cannot be read
        Runtime, ///< it did something that cannot be done
        Time,    ///< it took too many instructions, or in a live run too long
        Memory,  ///< it took too much memory
        Machine  ///< nothing of its own: the machine was too slow, so there is no verdict
    };

    QString message; ///< what is wrong and what would be right
    Kind kind = Kind::Runtime;
    int line = 0;                       ///< of the program, from 1; 0 if unknown
    qint64 step = 0;                    ///< the step that could not be made; 0 while loading
    double time = 0.0;                  ///< at the start of that step, s
    std::vector<ProgramValue> locals{}; ///< the local variables at that line

    friend bool operator==(const ProgramError &, const ProgramError &) = default;
};

/// A point of a curve that a program plots.
struct PlottedPoint {
    QString name;
    double value = 0.0;

    friend bool operator==(const PlottedPoint &, const PlottedPoint &) = default;
};

/// Something that a program draws over the scene for one step.
struct Drawing {
    enum class Kind { Arrow, Line, Point, Text };

    Kind kind = Kind::Point;
    Vec2 from{};      ///< m; the place of a point or a text
    Vec2 to{};        ///< m; the end of an arrow or a line
    QString colour{}; ///< a name or "#rrggbb"; empty for the text's colour
    QString text{};   ///< of a text, or the label of an arrow

    friend bool operator==(const Drawing &, const Drawing &) = default;
};

/// What a program shows in one step besides moving the circles.
struct ProgramOutput {
    QString text{}; ///< printed lines, each with its end
    std::vector<PlottedPoint> points{};
    std::vector<Drawing> drawings{};

    [[nodiscard]] bool isEmpty() const
    {
        return text.isEmpty() && points.empty() && drawings.empty();
    }
    friend bool operator==(const ProgramOutput &, const ProgramOutput &) = default;
};

/// A student's program, which moves the circles in place of a preset's laws.
class Program
{
public:
    virtual ~Program() = default;

    /// Begins a run anew in \p scene, which it may change: circles, gravity, restitution.
    /// \return why it cannot run
    virtual std::optional<ProgramError> begin(Preset &scene) = 0;

    /// Whether it moves the circles; if not, the laws of the scene do.
    [[nodiscard]] virtual bool moves() const = 0;

    /// Moves the circles of \p world, which stands at the start of a step, by \p dt s; its step
    /// and time are left to the caller. After an error its circles are as they were.
    virtual std::optional<ProgramError> advance(World &world, double dt) = 0;

    /// What it has worked in the run so far, in instructions or what counts as such; the same for
    /// the same run, on any machine. 0 where nobody counts.
    [[nodiscard]] virtual qint64 instructions() const { return 0; }

    /// What it has shown since this was last asked.
    [[nodiscard]] virtual ProgramOutput takeOutput() = 0;
};

} // namespace cradle
