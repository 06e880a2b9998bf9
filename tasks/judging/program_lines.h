// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/program_tokens.h"

#include <QHash>
#include <QSet>
#include <QStringList>

#include <map>
#include <optional>
#include <set>
#include <vector>

namespace cradle {

/// A program as lines of tokens, with the names that matter in it. Lines count from 1, tokens
/// from 0.
class ProgramLines
{
public:
    /// \param source  must live as long
    explicit ProgramLines(const QString &source);

    [[nodiscard]] const QString &source() const { return m_source; }
    [[nodiscard]] int count() const { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] const std::vector<ProgramToken> &tokens() const { return m_tokens; }
    /// \return false beyond the program, also before its first token: i - 1 may be asked of any
    [[nodiscard]] bool is(std::size_t i, const char *word) const
    {
        return i < m_tokens.size() && m_tokens[i].is(word);
    }
    [[nodiscard]] const QStringList &rows() const { return m_rows; }
    [[nodiscard]] const QString &row(int line) const { return m_rows[line - 1]; }
    [[nodiscard]] qsizetype startOf(int line) const
    {
        return m_starts[static_cast<std::size_t>(line - 1)];
    }
    /// The tokens of a line; none if there are none.
    [[nodiscard]] const std::vector<std::size_t> &tokensOf(int line) const;

    [[nodiscard]] bool hasName(const QString &name) const { return m_names.contains(name); }
    /// Whether something is read or written of it: v of v.x.
    [[nodiscard]] bool isOwner(const QString &name) const { return m_owners.contains(name); }
    /// The names that stand for the timestep, as they come; what is tried follows this order.
    [[nodiscard]] const QStringList &timesteps() const { return m_timesteps; }
    /// The numbers up to which its loops count.
    [[nodiscard]] QStringList countsOfLoops() const;
    /// At most three circles that are named in a line or in those around it, the nearest first.
    [[nodiscard]] QStringList bodiesNear(int line) const;

    /// The locals that are given a value in the lines before one and used nowhere.
    [[nodiscard]] QStringList forgotten(int line) const;

    /// Whether a line does nothing but call a function.
    [[nodiscard]] bool isCall(int line) const;
    /// Whether token \p i is a name that a local statement gives.
    [[nodiscard]] bool isNewName(std::size_t i) const;

    /// The token after the operand that begins at \p i; \p i if none begins there.
    [[nodiscard]] std::size_t afterOperand(std::size_t i) const;
    /// The token after the bracket that closes the one at \p i.
    [[nodiscard]] std::size_t afterGroup(std::size_t i) const;

    /// Lines near \p line with the same tokens but for names, numbers and plus for minus.
    [[nodiscard]] std::vector<int> twinsOf(int line) const;
    /// The place in \p twin that \p at is in \p line; nothing if it is within a token.
    [[nodiscard]] std::optional<qsizetype> placeIn(int line, int twin, qsizetype at) const;
    /// \p text with the names of \p twin in place of those of \p line.
    [[nodiscard]] QString inTwin(const QString &text, int line, int twin) const;

private:
    void note(std::size_t i);

    const QString &m_source;
    std::vector<ProgramToken> m_tokens;
    QStringList m_rows;
    std::vector<qsizetype> m_starts{};
    std::map<int, std::vector<std::size_t>> m_rowTokens{};
    QHash<QString, int> m_names{}; ///< how often each is named
    QSet<QString> m_owners{};
    QStringList m_timesteps{};
    std::map<int, std::set<QString>> m_bodies{}; ///< names of circles, by line
};

} // namespace cradle
