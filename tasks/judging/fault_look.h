// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"

#include <QHash>

#include <optional>
#include <vector>

namespace cradle {

/// How well a program does what the reference does.
enum class Sight { Wrong, Once, Twice };

/// Looks whether programs do at a moment, and in a scene that differs a little from it, what the
/// reference does there: soon done, and so for hundreds of programs.
class FaultLook
{
public:
    /// \param program, reference, moment  must live as long
    /// \param isHit  of a wall or another circle: it may come a step later
    /// \param isAnyMethod  any integrator is right in free flight, not the reference's alone
    FaultLook(const QString &program, const QString &reference, const Moment &moment, bool isHit,
              bool isQuestion, bool isAnyMethod = false);

    /// Whether the program itself is told from the reference.
    [[nodiscard]] bool showsFault();
    /// The circles that are wrong do what is asked; the others may go on as they did. Several
    /// changes may lead to one program: it is looked at once.
    [[nodiscard]] Sight of(const QString &program);

private:
    /// What there is in the end.
    struct Ends {
        std::vector<Circle> wanted{};
        std::vector<Circle> was{}; ///< of the program itself
    };
    struct Scene {
        Stage stage{};
        qint64 steps = 0;
        Ends whole{};
        std::optional<World>
            start{};         ///< in the midst of the reference's run, if one may begin there
        Ends late{};         ///< of runs that begin there
        bool isWhole = true; ///< whether what comes before the fault is told, too
        double slack = 0.0;  ///< m
        double near = 0.0;   ///< of velocities, relative
    };

    [[nodiscard]] std::optional<Scene> sceneOf(const Stage &stage, qint64 steps) const;
    [[nodiscard]] Stage otherStage() const;
    [[nodiscard]] Sight sightOf(const QString &program) const;
    [[nodiscard]] bool isRightIn(const Scene &scene, const QString &program) const;
    /// \param steps  that were made under the method of \p made
    [[nodiscard]] bool isNear(const std::vector<Circle> &made, const Ends &ends, double tolerance,
                              const Scene &scene, qint64 steps) const;
    /// By how much the velocities of the circles that are wrong differ in the end.
    [[nodiscard]] double offOf(const Ends &ends) const;
    /// Whether the program itself is told from the reference in \p scene; a little fault by less.
    [[nodiscard]] bool isTold(Scene &scene) const;
    [[nodiscard]] double slackIn(const Stage &stage) const;

    const QString &m_program;
    const QString &m_reference;
    const Moment &m_moment;
    bool m_isHit;
    bool m_isQuestion;
    bool m_isAnyMethod;
    std::optional<Scene> m_first{};  ///< the moment; nothing if the program is right there
    std::optional<Scene> m_second{}; ///< a scene like it, if the two do not do the same there
    QHash<QString, Sight> m_seen{};  ///< of the programs that were looked at
};

} // namespace cradle
