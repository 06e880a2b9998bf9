// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"
#include "tasks/judging/names_at_hand.h"
#include "tasks/judging/repairs.h"

#include <QHash>

#include <map>
#include <set>

namespace cradle {

/// What becomes of a value.
enum class ValueChange {
    Completed, ///< it gets what it lacks: gravity, a density, a wall that is asked for
    OfScene,   ///< a side of a question in a helper, by what the scene has
    Replaced,  ///< by what the aspect needs: a normal, a distance, the place where a wall turns
};

/// A program, of whose values it tells whether they are right up to a moment; each is asked once.
class SoundValues
{
public:
    /// \param source, moment  must outlive this
    SoundValues(const QString &source, const Moment &moment)
        : m_source(source)
        , m_moment(moment)
        , m_program(source)
        , m_assignments(assignmentsOf(m_program))
        , m_functions(functionsOf(m_program))
    {
    }

    [[nodiscard]] const ProgramLines &program() const { return m_program; }
    /// What is at hand in a line; it is found once.
    [[nodiscard]] const NamesAtHand &namesAt(int line);
    /// Whether what stands at \p from to \p to of the source is always the same of \p quantities.
    [[nodiscard]] bool has(qsizetype from, qsizetype to, const QStringList &quantities);

private:
    const QString &m_source;
    const Moment &m_moment;
    ProgramLines m_program;
    std::vector<ProgramAssignment> m_assignments;
    std::vector<ProgramFunction> m_functions;
    std::map<int, NamesAtHand> m_names{};
    QHash<QString, bool> m_known{}; ///< by the program that asks
};

/// Those of \p lines in which all that is given is right.
[[nodiscard]] std::set<int> soundLines(SoundValues &sound, const std::vector<int> &lines,
                                       Aspect aspect, Suspect suspect);

/// Programs that differ from that of \p sound in one whole value that a line gives, returns or
/// hands on. What is right is left as it is. \param lines  in which something may be changed; they
/// are tried as they stand in the program, of
///               masses from the last
/// \param now  the lines that run at the moment
[[nodiscard]] std::vector<Repair> valueRepairsOf(SoundValues &sound, const std::vector<int> &lines,
                                                 Aspect aspect, Suspect suspect,
                                                 const std::set<int> &now, ValueChange change);

} // namespace cradle
