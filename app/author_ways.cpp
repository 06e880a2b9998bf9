// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_window.h"

#include "app/notice_bar.h"
#include "tasks/authoring/lab_edits.h"
#include "views/author/checks_tab.h"
#include "views/author/programs_tab.h"
#include "views/author/proof_tab.h"
#include "views/author/scene_tab.h"
#include "views/author/text_tab.h"

#include <QTabWidget>

namespace cradle {

// Ways from what was found to the place that it is about.

void AuthorWindow::wireProof()
{
    connect(m_proofTab, &ProofTab::programRequested, this, [this](const QString &program) {
        if (program == QLatin1String("solution-preset")) {
            showTab(Scene);
            m_sceneTab->openSolution();
            return;
        }
        showTab(Programs);
        m_programsTab->openProgram(program + QStringLiteral(".lua"));
    });
    connect(m_proofTab, &ProofTab::checkRequested, this, [this](const QString &id) {
        showTab(Checks);
        m_checksTab->showCheck(id);
    });
    connect(m_proofTab, &ProofTab::runRequested, this,
            [this](const SceneVisit &run, const QString &finding) {
                showTab(Scene);
                m_visited = finding;
                m_sceneTab->visit(run);
            });
    connect(m_sceneTab, &SceneTab::programRequested, this,
            [this](const QString &program, int line) {
                showTab(Programs);
                m_programsTab->openProgram(program, line);
            });
    connect(m_sceneTab, &SceneTab::visitingChanged, this, &AuthorWindow::showVisit);
    connect(m_tabs, &QTabWidget::currentChanged, this, &AuthorWindow::showVisit);
}

/// Says of the scene what run is to be seen there, and nothing of it in other tabs.
void AuthorWindow::showVisit()
{
    if (m_sceneTab->preset().isVisiting() && m_tabs->currentIndex() == Scene) {
        m_offer = Offer::Visit;
        m_notice->showNotice(
            tr("A scene of the proof, at the moment where it went wrong: %1").arg(m_visited));
    } else if (m_offer == Offer::Visit) {
        m_offer = Offer::None;
        m_notice->clearNotice();
    }
}

/// Opens the place that \p finding is about: the step, the tab, and there the program or field.
void AuthorWindow::goTo(const Error &finding)
{
    if (finding.file == QLatin1String("lab.json")) {
        editProperties();
        return;
    }
    const QString step = finding.file.section(QLatin1Char('/'), 0, 0);
    const QString file = finding.file.section(QLatin1Char('/'), 1);
    if (m_document.steps().contains(step))
        m_document.setStep(step);
    const QString part = finding.pointer.section(QLatin1Char('/'), 1, 1);
    const auto index = finding.pointer.section(QLatin1Char('/'), 2, 2).toUInt();
    const Result<TaskForm> form = taskForm(m_document.files(), m_document.step());
    if (file.startsWith(QLatin1String("checks/"))) {
        showTab(Checks);
        m_checksTab->showScript(file.section(QLatin1Char('/'), 1));
    } else if (file.endsWith(QLatin1String(".lua")) || file.endsWith(QLatin1String(".diff"))) {
        showTab(Programs);
        m_programsTab->openProgram(file.section(QLatin1Char('.'), 0, -2) + QStringLiteral(".lua"),
                                   finding.line);
    } else if (file.contains(QLatin1String("preset"))) {
        showTab(Scene);
        if (file.startsWith(QLatin1String("solution-preset")))
            m_sceneTab->openSolution();
        else
            m_sceneTab->openStart();
    } else if (part == QLatin1String("checks")) {
        showTab(Checks);
        if (form && index < form->checks.size())
            m_checksTab->showCheck(form->checks[index].id);
    } else if (part == QLatin1String("remarks")) {
        showTab(Programs);
        if (form && index < form->remarks.size())
            m_programsTab->openRemark(form->remarks[index].id);
    } else {
        showTab(Text);
        if (part == QLatin1String("prediction"))
            m_textTab->openPrediction();
        else if (part == QLatin1String("questions"))
            m_textTab->openQuestions();
    }
}

} // namespace cradle
