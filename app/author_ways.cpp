// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_ways.h"

#include "app/author_notices.h"
#include "app/author_panes.h"
#include "tasks/authoring/lab_edits.h"
#include "views/author/author_document.h"
#include "views/author/checks_tab.h"
#include "views/author/find_panel.h"
#include "views/author/programs_tab.h"
#include "views/author/proof_tab.h"
#include "views/author/scene_tab.h"
#include "views/author/steps_panel.h"
#include "views/author/text_tab.h"

#include <QTabWidget>

namespace cradle {

namespace {

/// The language of a file with texts in another than the lab's own; empty for all others.
QString languageOf(const QString &file)
{
    const QStringList parts = file.section(QLatin1Char('/'), -1).split(QLatin1Char('.'));
    return parts.size() == 3 ? parts[1] : QString();
}

/// The id of one of a step's parts, which task.json counts and its translations name.
template <typename Part>
QString idAt(const std::vector<Part> &parts, const QString &which)
{
    bool isNumber = false;
    const std::size_t index = which.toUInt(&isNumber);
    return !isNumber ? which : index < parts.size() ? parts[index].id : QString();
}

/// What of a file \p finding is about: "checks" of "/checks/3/tolerance".
QString partOf(const Error &finding)
{
    return finding.pointer.section(QLatin1Char('/'), 1, 1);
}

/// Which of those parts: "3", or a name.
QString whichOf(const Error &finding)
{
    return finding.pointer.section(QLatin1Char('/'), 2, 2);
}

} // namespace

AuthorWays::AuthorWays(AuthorDocument &document, AuthorPanes &panes, AuthorNotices &notices)
    : m_document(document)
    , m_panes(panes)
    , m_notices(notices)
{
    connect(panes.find, &FindPanel::chosen, this, &AuthorWays::goTo);
    connect(panes.steps, &StepsPanel::findingChosen, this, &AuthorWays::goTo);
    connect(panes.proof, &ProofTab::programRequested, this, [this](const QString &program) {
        if (program == QLatin1String("solution-preset"))
            openScene(true);
        else
            openProgram(program + QStringLiteral(".lua"), 0);
    });
    connect(panes.proof, &ProofTab::checkRequested, this, [this](const QString &id) {
        m_panes.showTab(AuthorPanes::Checks);
        m_panes.checks->showCheck(id);
    });
    connect(panes.proof, &ProofTab::runRequested, this,
            [this](const SceneVisit &run, const QString &finding) {
                m_panes.showTab(AuthorPanes::Scene);
                m_visited = finding;
                m_panes.scene->visit(run);
            });
    connect(panes.scene, &SceneTab::programRequested, this, &AuthorWays::openProgram);
    connect(panes.scene, &SceneTab::visitingChanged, this, &AuthorWays::showVisit);
    connect(panes.tabs, &QTabWidget::currentChanged, this, &AuthorWays::showVisit);
    connect(panes.tabs, &QTabWidget::currentChanged, this, [this](int tab) {
        if (tab == AuthorPanes::Checks)
            m_panes.checks->setProgram(m_panes.programs->program());
    });
}

/// Says of the scene what run is to be seen there, and nothing of it in other tabs.
void AuthorWays::showVisit()
{
    if (m_panes.scene->preset().isVisiting() && m_panes.tabs->currentIndex() == AuthorPanes::Scene)
        m_notices.sayVisit(m_visited);
    else
        m_notices.endVisit();
}

void AuthorWays::openValues()
{
    m_panes.showTab(AuthorPanes::Text);
    m_panes.text->open(TextTab::ValuesPart);
}

void AuthorWays::openScene(bool ofSolution)
{
    m_panes.showTab(AuthorPanes::Scene);
    if (ofSolution)
        m_panes.scene->openSolution();
    else
        m_panes.scene->openStart();
}

void AuthorWays::openProgram(const QString &path, int line)
{
    m_panes.showTab(AuthorPanes::Programs);
    m_panes.programs->openProgram(path, line);
}

void AuthorWays::goTo(const Error &finding)
{
    const bool isText = finding.file.endsWith(QLatin1String(".md"))
                        || finding.file.endsWith(QLatin1String(".json"));
    if (const QString language = languageOf(finding.file); isText && !language.isEmpty())
        m_document.setLanguage(language);
    else if (isText)
        m_document.setLanguage(languagesOf(m_document.files()).value(0));
    if (!finding.file.contains(QLatin1Char('/'))) {
        goToLab(finding);
        return;
    }
    const QString step = finding.file.section(QLatin1Char('/'), 0, 0);
    const QString file = finding.file.section(QLatin1Char('/'), 1);
    if (m_document.steps().contains(step))
        m_document.setStep(step);
    if (file.startsWith(QLatin1String("checks/"))) {
        m_panes.showTab(AuthorPanes::Checks);
        m_panes.checks->showScript(file.section(QLatin1Char('/'), 1));
    } else if (file.endsWith(QLatin1String(".lua")) || file.endsWith(QLatin1String(".diff"))) {
        openProgram(file.section(QLatin1Char('.'), 0, -2) + QStringLiteral(".lua"), finding.line);
    } else if (file.contains(QLatin1String("preset"))) {
        openScene(file.startsWith(QLatin1String("solution-preset")));
    } else {
        goToPart(finding);
    }
}

/// In lab.json or its translations.
void AuthorWays::goToLab(const Error &finding)
{
    if (partOf(finding) != QLatin1String("values")) {
        emit propertiesRequested();
        return;
    }
    m_panes.showTab(AuthorPanes::Text);
    m_panes.text->openValue({}, whichOf(finding));
}

/// In task.json, its translations or the instructions of the open step.
void AuthorWays::goToPart(const Error &finding)
{
    const QString part = partOf(finding);
    const Result<TaskForm> form = taskForm(m_document.files(), m_document.step());
    if (part == QLatin1String("checks")) {
        m_panes.showTab(AuthorPanes::Checks);
        if (form)
            m_panes.checks->showCheck(idAt(form->checks, whichOf(finding)));
    } else if (part == QLatin1String("remarks")) {
        m_panes.showTab(AuthorPanes::Programs);
        if (const QString id = form ? idAt(form->remarks, whichOf(finding)) : QString();
            !id.isEmpty())
            m_panes.programs->openRemark(id);
    } else if (part == QLatin1String("mistakes")) {
        openProgram(QStringLiteral("mistakes/%1.lua").arg(whichOf(finding)), 0);
    } else {
        goToText(finding);
    }
}

void AuthorWays::goToText(const Error &finding)
{
    const QString part = partOf(finding);
    const bool codeHints = part == QLatin1String("code_hints");
    m_panes.showTab(AuthorPanes::Text);
    if (part == QLatin1String("prediction"))
        m_panes.text->open(TextTab::PredictionPart);
    else if (part == QLatin1String("questions"))
        m_panes.text->open(TextTab::QuestionsPart);
    else if (part == QLatin1String("values"))
        m_panes.text->openValue(finding.file.section(QLatin1Char('/'), 0, 0), whichOf(finding));
    else if (codeHints || part == QLatin1String("hints"))
        m_panes.text->openHint(codeHints, whichOf(finding).toInt());
    else if (finding.file.endsWith(QLatin1String(".md")))
        m_panes.text->openLine(finding.line);
}

} // namespace cradle
