// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/program_functions.h"
#include "tasks/judging/ran_lines.h"

namespace cradle {

/// Where the push is worked out that a line only applies, such as c.velocity = c.velocity + p / m.
class PushOrigin
{
public:
    /// Both must live as long.
    PushOrigin(const ProgramLines &program, const RanLines &ran);

    /// Of a line in a function that is given the push.
    /// \param calls  the lines that called it, the innermost last
    /// \return nothing if the line is none such, 0 if where it is worked out is not known
    [[nodiscard]] std::optional<int> ofGiven(int line, const std::vector<int> &calls) const;
    /// Of a line that adds what was worked out in the same function, or puts a velocity together
    /// of it; 0 if it is none such.
    [[nodiscard]] int ofAdded(int line) const;
    /// Of a line that only adds one value, which another line takes from the other circle: where
    /// that is worked out, or what it is worked out by; 0 if it is none such.
    [[nodiscard]] int ofShared(int line, bool isSizeWrong) const;

    /// Of a line that takes values which functions work out, each alone: where the one with most
    /// work is returned; 0 if there is none, or the line works out more itself.
    [[nodiscard]] int ofCalled(int line) const;

private:
    /// What a line adds to a velocity, or puts in its place.
    struct Taken {
        QStringList names{};
        bool isAdded = false;
    };
    [[nodiscard]] Taken takenAt(int line) const;
    [[nodiscard]] const ProgramAssignment *assignmentOf(const QString &name, int above) const;
    /// In tokens \p from to \p to without \p to.
    [[nodiscard]] int workIn(std::size_t from, std::size_t to) const;
    [[nodiscard]] int workOf(const ProgramAssignment &each) const
    {
        return workIn(each.from, each.to);
    }
    /// Of the names' values, worked out above a line, the one with most work.
    [[nodiscard]] const ProgramAssignment *mostWorked(const QStringList &names, int above) const;
    /// The function of the program of which tokens \p from to \p to without \p to are one call.
    [[nodiscard]] const ProgramFunction *functionCalled(std::size_t from, std::size_t to) const;
    /// Its only line that returns something; 0 if it has none, or several, or there is no function.
    [[nodiscard]] int returnOf(const ProgramFunction *function) const;
    /// 1 / mass; of null it is none.
    [[nodiscard]] bool isInverse(const ProgramAssignment *each) const;
    /// The line of a push or, if it takes one mass for both circles, of that.
    [[nodiscard]] int lineOf(const ProgramAssignment &push) const;

    const ProgramLines &m_program;
    const RanLines &m_ran;
    std::vector<ProgramAssignment> m_assignments;
    std::vector<ProgramFunction> m_functions;
};

} // namespace cradle
