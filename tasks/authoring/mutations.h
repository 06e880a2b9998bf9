// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/judgement.h"

#include <vector>

namespace cradle {

/// A program with one mistake that students make, made from a solution.
struct Mutant {
    QString name;     ///< of a file: "sign-line-12"
    QString source;   ///< the whole program, with \c message as its first comment block
    QString message;  ///< CommonMark: a headline, then what was changed and where
    int line = 0;     ///< of the solution, from 1
    QString change{}; ///< what stands there now
};

/// All mutants of \p solution that can be read as programs: the sign of a term; a factor dropped
/// (timestep, mass, e); the old velocity moves the circle; masses, circles or coordinates
/// exchanged; a normal left at its length; a part of a condition missing or turned round; a
/// statement missing or made twice.
[[nodiscard]] std::vector<Mutant> mutantsOf(const QString &solution);

/// What became of a mutant that tells the author something.
struct Suggestion {
    enum class Kind {
        Passes,       ///< it does something else than the solution, and every check accepts it:
                      ///< a check is missing
        NotDiagnosed, ///< it fails by \c check, and nothing is said of why
        ToldByLaw     ///< it fails by \c check; no mistake of the step is it, but a law that was
                      ///< measured says why
    };

    Kind kind = Kind::NotDiagnosed;
    Mutant mutant{};
    QString check{};   ///< id of the first check that it fails
    QString finding{}; ///< what that check said; of ToldByLaw the headline of what is told
};

/// What the mutants of a solution tell.
struct Suggestions {
    std::vector<Suggestion> list{}; ///< in the order of their kinds
    QStringList alone{};            ///< ids of checks that some mutant fails by no other
};

/// Judges the mutants of the solution of \p task. Of those that do the same in all its scenes only
/// the first is kept; those that do what the solution does, stop with an error or are a mistake of
/// the step are left out.
/// \param hooks  called from other threads, never two at once
/// \return nothing if it was cancelled
[[nodiscard]] Suggestions suggestMistakes(const Lab &lab, const Task &task,
                                          const JudgeHooks &hooks = {});

} // namespace cradle
