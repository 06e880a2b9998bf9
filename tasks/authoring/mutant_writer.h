// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/mutations.h"
#include "tasks/script/program_tokens.h"

#include <QSet>
#include <QStringList>

namespace cradle {

/// What kind of mistake it is, and what a student is asked who made it.
struct Mistake {
    const char *name; ///< begins the name of the file
    QString headline;
    QString question;
};

/// A solution as those read it who change it: by tokens and by lines.
class MutantWriter
{
public:
    explicit MutantWriter(const QString &solution);

    [[nodiscard]] const QString &source() const { return m_source; }
    [[nodiscard]] const std::vector<ProgramToken> &tokens() const { return m_tokens; }
    [[nodiscard]] const QStringList &lines() const { return m_lines; }
    /// Null behind the last.
    [[nodiscard]] const ProgramToken *at(std::size_t i) const;
    [[nodiscard]] bool isAt(std::size_t i, const char *word) const;
    /// Whether the line belongs to on_load: what stands there are the values of the scene.
    [[nodiscard]] bool isInStart(int line) const
    {
        return line >= m_startFrom && line <= m_startTo;
    }
    /// The token after the operand that begins at \p i: a name with its fields and calls, a number
    /// or a group in parentheses; \p i itself if none does.
    [[nodiscard]] std::size_t afterOperand(std::size_t i) const;
    /// The token after the parenthesis or bracket that closes the one at \p i.
    [[nodiscard]] std::size_t afterGroup(std::size_t i) const;
    /// Whether a line is one whole statement that assigns or calls.
    [[nodiscard]] bool isStatement(int line) const;
    /// Where a line begins in the source.
    [[nodiscard]] qsizetype startOf(int line) const;

    /// Keeps the program in which the letters from \p from up to \p to became \p text, if it can
    /// be read and is another.
    void add(const Mistake &mistake, int line, qsizetype from, qsizetype to, const QString &text);
    [[nodiscard]] std::vector<Mutant> take() { return std::move(m_mutants); }

private:
    void findStart();

    const QString &m_source;
    std::vector<ProgramToken> m_tokens;
    QStringList m_lines;
    QSet<QString> m_used{}; ///< names of mutants
    int m_startFrom = 0;    ///< lines of on_load
    int m_startTo = -1;
    std::vector<Mutant> m_mutants{};
};

} // namespace cradle
