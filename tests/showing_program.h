// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/program.h"

#include <functional>
#include <utility>

namespace cradle {

/// Stands in for a student's program: its circles move straight on, and in every step it shows
/// what it is told to.
class ShowingProgram final : public Program
{
public:
    /// Fills in what is shown in the step that starts in the given world.
    using Show = std::function<void(World &world, ProgramOutput &output)>;

    explicit ShowingProgram(Show show = {})
        : m_show(std::move(show))
    {
    }

    QString atLoad{}; ///< printed by begin()
    std::optional<ProgramError> loadError{};
    qint64 failsAt = -1; ///< the step that cannot be made
    int errorLine = 12;

    std::optional<ProgramError> begin(Preset &) override
    {
        m_output = {};
        m_output.text = atLoad;
        return loadError;
    }

    [[nodiscard]] bool moves() const override { return true; }

    std::optional<ProgramError> advance(World &world, double dt) override
    {
        if (m_show)
            m_show(world, m_output);
        if (world.step + 1 == failsAt)
            return ProgramError{.message = QStringLiteral("attempt to index a nil value"),
                                .line = errorLine,
                                .step = failsAt,
                                .time = world.time};
        for (Circle &circle : world.circles)
            circle.position += dt * circle.velocity;
        return std::nullopt;
    }

    [[nodiscard]] ProgramOutput takeOutput() override { return std::exchange(m_output, {}); }

private:
    Show m_show;
    ProgramOutput m_output;
};

} // namespace cradle
