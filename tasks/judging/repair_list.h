// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/program_functions.h"
#include "tasks/judging/repairs.h"

#include <utility>

namespace cradle {

/// What names of the first and of the second circle end with.
inline constexpr std::pair<char, char> circleEnds[] = {{'1', '2'}, {'a', 'b'}, {'p', 'q'}};

/// Collects changed programs, each also with the same change in all lines that say the same of
/// another circle, wall or part.
class RepairList
{
public:
    /// \param rebounds  whether e is of the step: else it is 1, and that is tried as such
    /// \param most  repairs that are taken
    RepairList(const ProgramLines &program, bool rebounds, std::size_t most)
        : m_program(program)
        , m_rebounds(rebounds)
        , m_most(most)
        , m_assignments(assignmentsOf(program))
        , m_functions(functionsOf(program))
        , m_declared(pairsOf(program, m_assignments))
    {
    }

    [[nodiscard]] const ProgramLines &program() const { return m_program; }
    [[nodiscard]] const std::vector<ProgramToken> &tokens() const { return m_program.tokens(); }
    [[nodiscard]] bool is(std::size_t i, const char *word) const { return m_program.is(i, word); }
    /// The same, of a token behind which a sign joins two.
    [[nodiscard]] bool endsOperand(std::size_t i) const
    {
        return i < tokens().size() && tokens()[i].endsOperand();
    }
    /// \return 0 beyond the program
    [[nodiscard]] int lineOf(std::size_t i) const
    {
        return i < tokens().size() ? tokens()[i].line : 0;
    }
    [[nodiscard]] const std::vector<ProgramAssignment> &assignments() const
    {
        return m_assignments;
    }
    [[nodiscard]] const std::vector<ProgramFunction> &functions() const { return m_functions; }

    /// What stands for the same of the other circle or side: m2 for m1 or for m, b for a, yours
    /// where `local mine, yours = a.velocity, b.velocity`; empty if the program names none.
    [[nodiscard]] QString partnerOf(const QString &name) const;

    /// \param from, to  places in the source, of \p line
    void replace(int line, qsizetype from, qsizetype to, const QString &text);
    /// Where other lines tell what is meant.
    void replaceTelling(int line, qsizetype from, qsizetype to, const QString &text);
    void replace(const ProgramToken &token, const QString &text)
    {
        replace(token.line, token.start, token.end(), text);
    }
    void insertAfter(const ProgramToken &token, const QString &text)
    {
        replace(token.line, token.end(), token.end(), text);
    }

    /// Those in one place first: few faults are made in several places alike.
    [[nodiscard]] std::vector<Repair> take();

private:
    [[nodiscard]] static QHash<QString, QString>
    pairsOf(const ProgramLines &program, const std::vector<ProgramAssignment> &assignments);
    /// Once, also where several ways lead to it.
    void add(const QString &source, int line, bool alone);
    [[nodiscard]] std::size_t roomForTwins() const { return m_most / 4; }
    using Place = std::pair<qsizetype, qsizetype>;
    [[nodiscard]] QString inTwin(const QString &text, int line, int twin, Place place,
                                 qsizetype start) const;
    /// The same in all brackets of the line that are alike.
    void replaceInLike(int line, qsizetype from, qsizetype to, const QString &text);
    void replaceInTwins(int line, qsizetype from, qsizetype to, const QString &text);

    const ProgramLines &m_program;
    bool m_rebounds;
    std::size_t m_most;
    std::vector<ProgramAssignment> m_assignments;
    std::vector<ProgramFunction> m_functions;
    QHash<QString, QString> m_declared; ///< partners by what they are given
    std::vector<Repair> m_repairs{};
    std::vector<Repair> m_twins{}; ///< in several lines alike
    QSet<QString> m_known{};
};

/// A number or a sign for another, at token \p i.
void repairWords(RepairList &repairs, std::size_t i);
/// A name for another, of a circle, a coordinate, an index, a function, at token \p i.
void repairNames(RepairList &repairs, std::size_t i);
/// A factor, a term or a bracket too many or at a wrong place, at token \p i.
void repairTerms(RepairList &repairs, std::size_t i);
/// A factor or a term too few, at token \p i.
void repairOmissions(RepairList &repairs, std::size_t i);
/// A condition, a whole right side or a statement, at token \p i.
void repairStatements(RepairList &repairs, std::size_t i);
/// What is given, twice as much or upside down, at token \p i.
void repairScales(RepairList &repairs, std::size_t i);
/// What is meant for another circle, part or direction, at token \p i.
void repairExchanges(RepairList &repairs, std::size_t i);
/// What stands in a list at a place where another of it belongs, behind token \p i.
void repairElements(RepairList &repairs, std::size_t i);
/// Several factors or a term too many, a bracket or a count that is wrong, a factor that
/// stands elsewhere in the program, at token \p i.
void repairFactors(RepairList &repairs, std::size_t i);
/// One coordinate where a sum over both belongs: dx ^ 2, v.x * n.x, at token \p i.
void addCoordinate(RepairList &repairs, std::size_t i);
/// A term of a sum, twice or with e, at token \p i.
void scaleTerm(RepairList &repairs, std::size_t i);
/// What the line says of two, said the other way round or at once; a way out, not taken.
void repairOrder(RepairList &repairs, int line);
/// What lines say, as others nearby or their own other halves say it of the other circle or
/// coordinate.
void repairMirrors(RepairList &repairs, const std::vector<int> &lines);
/// What the line says in one place, as others nearby that are built alike say it: kick(c, dt)
/// beside kick(c, dt / 2).
void repairLikes(RepairList &repairs, int line);
/// What follows from two that are alike, at token \p i: their product for what they share, the sum
/// of their squares for the square of their sum, the whole step for a part of it.
void repairPairs(RepairList &repairs, std::size_t i);
/// A value, wherever the line takes it, twice.
void scaleValue(RepairList &repairs, int line);
/// The line left out.
void dropLine(RepairList &repairs, int line);
/// The line put behind the next, or said of another circle.
void repairLine(RepairList &repairs, int line);

} // namespace cradle
