// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <set>
#include <utility>

namespace cradle {

/// Where a program asks whether a field is there that it sets somewhere, as in `c.mass or f(c)`,
/// `if not c.mass then` and `c.mass == nil`: read there before it is set, the field is nil. A name
/// that is set nowhere is a slip.
class AskedFields
{
public:
    AskedFields() = default;
    /// \param source  a program that can be read
    explicit AskedFields(const QString &source);

    [[nodiscard]] bool contains(int line, const QString &name) const
    {
        return m_asked.contains({line, name});
    }

private:
    std::set<std::pair<int, QString>> m_asked{};
};

} // namespace cradle
