// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/repair_list.h"

#include <algorithm>

namespace cradle {

namespace {

/// Lines between two that are built alike.
constexpr int likeLines = 6;
/// Tokens that two lines share at least, and those at most that the one has in place of the
/// other's.
constexpr std::size_t leastShared = 4;
constexpr std::size_t mostOther = 5;

/// Where two lines differ: all tokens but those between are the same, or names.
struct Difference {
    std::size_t before = 0; ///< tokens
    std::size_t behind = 0;
};

bool isSame(const ProgramToken &a, const ProgramToken &b)
{
    return a.kind == b.kind && (a.kind == ProgramToken::Kind::Name || a.text == b.text);
}

Difference differenceOf(const ProgramLines &program, const std::vector<std::size_t> &own,
                        const std::vector<std::size_t> &other)
{
    const std::size_t most = std::min(own.size(), other.size());
    const auto &tokens = program.tokens();
    Difference found;
    while (found.before < most && isSame(tokens[own[found.before]], tokens[other[found.before]]))
        ++found.before;
    while (found.before + found.behind < most
           && isSame(tokens[own[own.size() - 1 - found.behind]],
                     tokens[other[other.size() - 1 - found.behind]]))
        ++found.behind;
    return found;
}

/// What the other line has in that place.
QString otherText(const ProgramLines &program, const std::vector<std::size_t> &other,
                  const Difference &difference)
{
    const std::size_t end = other.size() - difference.behind;
    if (difference.before == end)
        return {};
    const qsizetype from = program.tokens()[other[difference.before]].start;
    return program.source().mid(from, program.tokens()[other[end - 1]].end() - from);
}

} // namespace

void repairLikes(RepairList &repairs, int line)
{
    const ProgramLines &program = repairs.program();
    const std::vector<std::size_t> &own = program.tokensOf(line);
    for (int at = std::max(1, line - likeLines); at <= std::min(program.count(), line + likeLines);
         ++at) {
        const std::vector<std::size_t> &other = program.tokensOf(at);
        const Difference found = differenceOf(program, own, other);
        const std::size_t shared = found.before + found.behind;
        const std::size_t longer = std::max(own.size(), other.size());
        if (found.before == 0 || shared < leastShared || shared == longer
            || longer - shared > mostOther || 2 * shared < longer)
            continue;
        const std::size_t end = own.size() - found.behind;
        const bool isMissing = found.before == end;
        const qsizetype from = isMissing ? program.tokens()[own[found.before - 1]].end()
                                         : program.tokens()[own[found.before]].start;
        const qsizetype to = isMissing ? from : program.tokens()[own[end - 1]].end();
        repairs.replaceTelling(line, from, to,
                               (isMissing ? QStringLiteral(" ") : QString())
                                   + otherText(program, other, found));
    }
}

} // namespace cradle
