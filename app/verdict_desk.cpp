// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verdict_desk.h"

#include "app/announcer.h"
#include "app/code_desk.h"
#include "app/panes.h"
#include "tasks/lab_report/lab_report.h"
#include "views/task_pane/result_cards.h"
#include "views/task_pane/task_pane.h"
#include "views/timeline.h"
#include "views/transport_bar.h"

#include <algorithm>

namespace cradle {

VerdictDesk::VerdictDesk(Workbench &workbench, Panes &panes, CodeDesk &code)
    : m_workbench(workbench)
    , m_panes(panes)
    , m_code(code)
{
    Workbench *bench = &workbench;
    WorkCheck *check = &workbench.check();
    connect(panes.transport, &TransportBar::checkRequested, check, &WorkCheck::start);
    connect(panes.transport, &TransportBar::checkCancelled, check, &WorkCheck::cancel);
    connect(check, &WorkCheck::started, this, [this] {
        m_panes.transport->setChecking(true);
        m_panes.task->setChecking(true);
    });
    connect(check, &WorkCheck::progressed, this, [this](int done, int total) {
        m_panes.transport->setCheckProgress(total > 0 ? double(done) / total : 0.0);
        m_panes.task->setChecking(true, done, total);
    });
    connect(check, &WorkCheck::cancelled, this, [this] {
        m_panes.transport->setChecking(false);
        m_panes.task->setReport(m_workbench.check().report());
    });
    connect(check, &WorkCheck::reported, this, [this] {
        m_panes.transport->setChecking(false);
        showReport();
        announce();
    });
    connect(bench, &Workbench::taskChanged, this, &VerdictDesk::showReport);
    connect(bench, &Workbench::modeChanged, this, &VerdictDesk::showReport);
    connect(check, &WorkCheck::stale, panes.task, &TaskPane::setStale);
    connect(panes.task, &TaskPane::showMoment, &bench->moment(), &FaultMoment::show);
    connect(panes.task, &TaskPane::lineRequested, this,
            [this](int line) { m_panes.showCode(line); });
    connect(panes.task, &TaskPane::solutionRequested, panes.code, &CodePane::solutionRequested);
}

void VerdictDesk::showReport()
{
    m_panes.task->setReport(m_workbench.check().report());
    m_code.showReport();
    std::vector<Timeline::Mark> marks;
    const Preset &own = m_workbench.document().own();
    if (m_workbench.check().report()) {
        for (const CheckOutcome &check : m_workbench.check().report()->checks) {
            if (!check.passed && check.scene == own && !check.pinned)
                marks.push_back({.time = static_cast<double>(check.step) * own.timestep,
                                 .label = tr("Not yet: %1").arg(check.title)});
        }
    }
    m_panes.timeline->setMarks(marks);
}

/// In the words of the result's first line.
void VerdictDesk::announce()
{
    const std::optional<CheckReport> &report = m_workbench.check().report();
    if (!report)
        return;
    const Finding *found = report->diagnosis();
    const auto failed = std::find_if(report->checks.begin(), report->checks.end(),
                                     [](const CheckOutcome &check) { return !check.passed; });
    if (report->passed)
        m_panes.announcer->say(tr("Check passed."));
    else if (report->error)
        m_panes.announcer->say(describeError(*report->error).headline);
    else if (found)
        m_panes.announcer->say(tr("Not yet: %1").arg(headlineOf(found->message)));
    else if (failed != report->checks.end())
        m_panes.announcer->say(tr("Not yet: %1").arg(failed->title));
}

} // namespace cradle
