// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_window.h"

#include "app/notice_bar.h"
#include "tasks/authoring/lab_edits.h"
#include "views/author/checks_tab.h"
#include "views/author/find_panel.h"
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
    connect(m_tabs, &QTabWidget::currentChanged, this, [this](int tab) {
        if (tab == Checks)
            m_checksTab->setProgram(m_programsTab->program());
    });
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

void AuthorWindow::openValues()
{
    showTab(Text);
    m_textTab->openValues();
}

void AuthorWindow::openSearch()
{
    m_find->open();
}

/// The language of a file with texts in another than the lab's own; empty for all others.
static QString languageOf(const QString &file)
{
    const QStringList parts = file.section(QLatin1Char('/'), -1).split(QLatin1Char('.'));
    return parts.size() == 3 ? parts[1] : QString();
}

/// The id of one of a step's parts, which task.json counts and its translations name.
template <typename Part>
static QString idAt(const std::vector<Part> &parts, const QString &which)
{
    bool isNumber = false;
    const std::size_t index = which.toUInt(&isNumber);
    return !isNumber ? which : index < parts.size() ? parts[index].id : QString();
}

/// Opens the place that \p finding is about: the step, the tab, and there the program or field.
void AuthorWindow::goTo(const Error &finding)
{
    const bool isText = finding.file.endsWith(QLatin1String(".md"))
                        || finding.file.endsWith(QLatin1String(".json"));
    if (const QString language = languageOf(finding.file); isText && !language.isEmpty())
        m_document.setLanguage(language);
    else if (isText)
        m_document.setLanguage(languagesOf(m_document.files()).value(0));
    const QString part = finding.pointer.section(QLatin1Char('/'), 1, 1);
    const bool ofValue = part == QLatin1String("values");
    const QString which = finding.pointer.section(QLatin1Char('/'), 2, 2);
    if (!finding.file.contains(QLatin1Char('/'))) { // lab.json and its translations
        if (ofValue) {
            showTab(Text);
            m_textTab->openValue({}, which);
        } else {
            editProperties();
        }
        return;
    }
    const QString step = finding.file.section(QLatin1Char('/'), 0, 0);
    const QString file = finding.file.section(QLatin1Char('/'), 1);
    if (m_document.steps().contains(step))
        m_document.setStep(step);
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
        if (form)
            m_checksTab->showCheck(idAt(form->checks, which));
    } else if (part == QLatin1String("remarks")) {
        showTab(Programs);
        if (const QString id = form ? idAt(form->remarks, which) : QString(); !id.isEmpty())
            m_programsTab->openRemark(id);
    } else if (part == QLatin1String("mistakes")) {
        showTab(Programs);
        m_programsTab->openProgram(QStringLiteral("mistakes/%1.lua").arg(which), 0);
    } else {
        showTab(Text);
        if (part == QLatin1String("prediction"))
            m_textTab->openPrediction();
        else if (part == QLatin1String("questions"))
            m_textTab->openQuestions();
        else if (ofValue)
            m_textTab->openValue(step, which);
        else if (part == QLatin1String("hints") || part == QLatin1String("code_hints"))
            m_textTab->openHint(part == QLatin1String("code_hints"), which.toInt());
        else if (finding.file.endsWith(QLatin1String(".md")))
            m_textTab->openLine(finding.line);
    }
}

} // namespace cradle
