// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace cradle::approved {

/// Draws that are the same everywhere.
class Draws
{
public:
    explicit Draws(unsigned seed)
        : m_engine(seed)
    {
    }
    [[nodiscard]] std::size_t below(std::size_t count) { return m_engine() % count; }
    [[nodiscard]] bool oneOf(std::size_t count) { return below(count) == 0; }
    /// From 1e-7 to 2, each order as often as any other, and of either sign.
    [[nodiscard]] double amount()
    {
        const double size = std::pow(10.0, -7.0 + 0.0073 * double(below(1000)));
        return oneOf(2) ? size : -size;
    }
    /// All members of all \p groups, those of one, or one of them.
    template <typename Member>
    [[nodiscard]] std::vector<Member> someOf(const std::vector<std::vector<Member>> &groups)
    {
        if (oneOf(2)) {
            std::vector<Member> all;
            for (const std::vector<Member> &group : groups)
                all.insert(all.end(), group.begin(), group.end());
            return all;
        }
        const std::vector<Member> &group = groups[below(groups.size())];
        return oneOf(2) ? group : std::vector{group[below(group.size())]};
    }

private:
    std::mt19937 m_engine;
};

} // namespace cradle::approved
