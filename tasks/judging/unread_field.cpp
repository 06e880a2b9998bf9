// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/unread_field.h"

#include "tasks/judging/program_statements.h"

#include <algorithm>

namespace cradle {

namespace {

constexpr const char *circleFields[] = {"position", "velocity", "radius", "density"};
constexpr qsizetype shortestAbbreviation = 3;

/// What \p name is short for; empty if it is the whole, or of nothing.
QString lengthened(const QString &name)
{
    for (const char *field : circleFields) {
        const auto whole = QLatin1String(field);
        if (name.size() >= shortestAbbreviation && name.size() < whole.size()
            && QString(whole).startsWith(name, Qt::CaseInsensitive))
            return whole;
    }
    return {};
}

} // namespace

std::optional<UnreadField> unreadField(const QString &program)
{
    const ProgramLines lines(program);
    const std::vector<ProgramAssignment> assignments = assignmentsOf(lines);
    const auto isTarget = [&](std::size_t token) {
        return std::any_of(
            assignments.begin(), assignments.end(),
            [token](const ProgramAssignment &each) { return each.isField && each.last == token; });
    };
    for (const ProgramAssignment &each : assignments) {
        const QString meant = each.isField ? lengthened(each.name) : QString();
        if (meant.isEmpty())
            continue;
        bool isRead = false;
        for (std::size_t i = 0; i < lines.tokens().size(); ++i)
            isRead |= lines.tokens()[i].text == each.name && !isTarget(i);
        if (!isRead)
            return UnreadField{each.line, each.name, meant};
    }
    return std::nullopt;
}

} // namespace cradle
