// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/finding_list.h"

#include "tasks/judging/last_assignment.h"
#include "tasks/judging/unread_field.h"

#include <algorithm>

namespace cradle {

namespace {

struct ListText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

} // namespace

bool FindingList::has(Aspect aspect) const
{
    return std::any_of(m_findings.begin(), m_findings.end(),
                       [aspect](const Finding &f) { return f.aspect == aspect; });
}

void FindingList::add(const LawDeviation &deviation, const QString &mistake, const QString &message)
{
    const CheckOutcome *failed = m_deviations.failedOf(deviation.aspect);
    Finding finding{.aspect = deviation.aspect,
                    .mistake = mistake,
                    .message = message,
                    .check = failed ? failed->id : QString()};
    markLastAssignment(finding, deviation.moment, m_task, m_submission);
    m_lines.point(finding, deviation, m_findings);
    pointToUnread(finding);
    m_findings.push_back(finding);
}

void FindingList::addToStart(const LawDeviation &deviation)
{
    const auto isLater = [](const Finding &f) { return f.aspect != Aspect::Start; };
    const auto at =
        std::find_if(m_findings.begin(), m_findings.end(), isLater) - m_findings.begin();
    add(deviation);
    std::rotate(m_findings.begin() + at, m_findings.end() - 1, m_findings.end());
}

void FindingList::addWritten(const LawDeviation &deviation)
{
    add(deviation);
    // Where the place is written the velocity is not; where one part of it is, the other is not.
    markLastAssignment(m_findings.back(), deviation.moment, m_task, m_submission);
}

void FindingList::tellMended(const LawDeviation &deviation)
{
    m_findings.back().message += QLatin1Char(' ')
                                 + ListText::tr("The same fault shows in this, too: %1.")
                                       .arg(deviation.message.section(QLatin1Char('\n'), 0, 0));
}

void FindingList::tellBehind(Aspect aspect, const QString &words)
{
    const auto at = std::find_if(m_findings.rbegin(), m_findings.rend(),
                                 [aspect](const Finding &f) { return f.aspect == aspect; });
    at->message += QStringLiteral("\n\n") + words;
}

/// A field that nothing reads, where no other line is known to be at fault.
void FindingList::pointToUnread(Finding &finding) const
{
    const auto field =
        finding.line == 0 && m_submission.script ? unreadField(*m_submission.script) : std::nullopt;
    if (!field)
        return;
    finding.line = field->line;
    finding.message += QLatin1Char(' ')
                       + ListText::tr("Line %1 sets a field `%2` of your own, which nothing "
                                      "reads: a circle has a `%3`.")
                             .arg(field->line)
                             .arg(field->name, field->meant);
}

} // namespace cradle
