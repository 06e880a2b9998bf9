// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"

#include <QJsonObject>

#include <optional>
#include <utility>

namespace cradle {

/// What a student hands in for a step: a scene with its laws, and in code mode a program,
/// and answers.
struct Submission {
    Submission() = default;
    Submission(Preset scene)
        : preset(std::move(scene))
    {
    }
    Submission(Preset scene, std::optional<QString> program)
        : preset(std::move(scene))
        , script(std::move(program))
    {
    }

    /// The program, or null where the laws of the scene are judged.
    [[nodiscard]] const QString *program() const { return script ? &*script : nullptr; }

    Preset preset{};
    std::optional<QString> script{};
    QJsonObject answers{}; ///< to the step's questions, see tasks/questions/answers.h

    friend bool operator==(const Submission &, const Submission &) = default;
};

} // namespace cradle
