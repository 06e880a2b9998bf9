// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/code_desk.h"

#include "tasks/text/quantity_text.h"
#include "views/code/api_page.h"
#include "views/code/code_editor.h"

#include <QMessageBox>
#include <QSettings>

#include <algorithm>

namespace cradle {

namespace {

QString figure(double value)
{
    return QString::number(value, 'g', 7);
}

/// The circles as they are in the middle of an update, below the local variables.
std::vector<ProgramValue> valuesOf(const StudentScript::Pause &pause)
{
    std::vector<ProgramValue> values = pause.locals;
    int number = 0;
    for (const Circle &circle : pause.circles) {
        const QString name = QStringLiteral("circle%1.").arg(++number);
        const auto add = [&](const char *field, Vec2 v) {
            values.push_back({name + QLatin1String(field),
                              QStringLiteral("(%1, %2)").arg(figure(v.x), figure(v.y))});
        };
        add("position", circle.position);
        add("velocity", circle.velocity);
    }
    return values;
}

/// The line that the first finding names, which is none where it knows none; without findings that
/// of the first failed check; 0 if there is none.
int suspectLine(const CheckReport &report)
{
    if (report.error)
        return 0;
    if (const Finding *found = report.diagnosis())
        return found->line;
    const auto failed =
        std::find_if(report.checks.begin(), report.checks.end(),
                     [](const CheckOutcome &check) { return !check.passed && check.line > 0; });
    return failed != report.checks.end() ? failed->line : 0;
}

} // namespace

CodeDesk::CodeDesk(Workbench &workbench, CodePane &pane, QSettings &settings, QObject *parent)
    : QObject(parent)
    , m_workbench(workbench)
    , m_pane(pane)
    , m_settings(settings)
{
    const bool atOnce = settings.value(QStringLiteral("appliesAtOnce"), true).toBool();
    workbench.code().setAppliesAtOnce(atOnce);
    pane.setAppliesAtOnce(atOnce);
    pane.editor().setZoom(settings.value(QStringLiteral("codeZoom"), 0).toInt());
    connect(&pane.editor(), &CodeEditor::zoomChanged, this,
            [this](int steps) { m_settings.setValue(QStringLiteral("codeZoom"), steps); });
    wireEditor();
    wireSteps();
    wireSimulation();
    pane.editor().setText(workbench.code().text());
    showState();
}

void CodeDesk::wireEditor()
{
    CodeSession *code = &m_workbench.code();
    connect(&m_pane, &CodePane::textEdited, this, [this, code] {
        m_pane.editor().setSuspect(0);
        code->edit(m_pane.editor().text());
    });
    connect(&m_pane, &CodePane::applyRequested, code, [code] {
        code->apply();
        code->save();
    });
    connect(&m_pane, &CodePane::appliesAtOnceChanged, this, [this, code](bool atOnce) {
        m_settings.setValue(QStringLiteral("appliesAtOnce"), atOnce);
        code->setAppliesAtOnce(atOnce);
    });
    connect(code, &CodeSession::opened, this, [this, code](const QString &text) {
        m_pane.hideSolution();
        // Of a step that is opened again what was done in it can be undone.
        const QString work = code->workspace().folder() + QLatin1Char(' ') + m_workbench.lab().id;
        m_pane.editor().openDocument(work + QLatin1Char(' ') + code->taskId(), text);
    });
    connect(code, &CodeSession::textReplaced, this, [this](const QString &text) {
        m_pane.hideSolution();
        m_pane.editor().exchangeText(text);
        showState();
    });
    connect(code, &CodeSession::stateChanged, this, &CodeDesk::showState);
    connect(&m_pane, &CodePane::helpRequested, this, &CodeDesk::showReference);
    connect(&m_pane, &CodePane::afreshRequested, this, &CodeDesk::startAfresh);
    connect(&m_pane, &CodePane::solutionRequested, this, [this] {
        if (m_workbench.progress().mayShowSolution())
            m_pane.showSolution(m_workbench.task()->solution);
    });
    connect(&m_workbench.check(), &WorkCheck::countedLater, this, &CodeDesk::showSolutionButton);
    connect(&m_workbench.progress(), &KeptProgress::hintsChanged, this,
            &CodeDesk::showSolutionButton);
}

void CodeDesk::wireSteps()
{
    CodeRun *run = &m_workbench.code().run();
    connect(&m_pane, &CodePane::lineStepRequested, run, &CodeRun::stepLine);
    connect(&m_pane, &CodePane::finishStepRequested, run, &CodeRun::finishStep);
    connect(run, &CodeRun::paused, this, &CodeDesk::showPause);
    connect(run, &CodeRun::steppingEnded, this, [this] {
        m_pane.setExecuting(0);
        m_pane.hideLocals();
    });
}

void CodeDesk::wireSimulation()
{
    const Simulation *simulation = &m_workbench.simulation();
    connect(simulation, &Simulation::programFailed, this, [this](const ProgramError &error) {
        showError(error);
        // What already fails when it is loaded does so at every edit: who types is not taken away.
        if (error.step > 0)
            m_pane.editor().revealLine(error.line);
    });
    connect(simulation, &Simulation::restarted, this, [this, simulation] {
        if (!simulation->programError())
            clearError();
    });
    connect(&m_workbench, &Workbench::modeChanged, this, &CodeDesk::showState);
    // In the language of the lab's texts.
    connect(&m_workbench, &Workbench::labChanged, this, &CodeDesk::showState);
}

void CodeDesk::showState()
{
    const CodeSession &code = m_workbench.code();
    m_pane.setStepping(code.run().isActive());
    const bool fixed = code.isOpen() && !code.isEditable();
    if (fixed != m_pane.editor().isReadOnly())
        m_pane.editor().setReadOnly(fixed);
    if (code.run().fault()) {
        m_pane.setState(code.run().hasGoodVersion() ? CodeState::Broken : CodeState::NeverRan);
        m_pane.hideLocals();
        m_pane.editor().setError(code.run().fault()->line, code.run().fault()->message);
        return;
    }
    m_pane.setState(fixed            ? CodeState::ReadOnly
                    : code.isSaved() ? CodeState::Saved
                                     : CodeState::Unsaved);
    if (const auto &error = m_workbench.simulation().programError())
        showError(*error);
    else
        m_pane.editor().clearError();
}

void CodeDesk::showError(const ProgramError &error)
{
    if (m_workbench.code().run().fault())
        return;
    QString message = error.message;
    if (error.step > 0)
        message +=
            QLatin1Char('\n')
            + tr("in step %1, at %2 s").arg(error.step).arg(quantityText(error.time, 'g', 4));
    m_pane.editor().setError(error.line, message);
    m_pane.setExecuting(0);
    if (error.locals.empty())
        m_pane.hideLocals();
    else
        m_pane.showLocals(error.locals);
}

void CodeDesk::clearError()
{
    if (!m_workbench.code().run().fault())
        m_pane.editor().clearError();
    m_pane.hideLocals();
}

void CodeDesk::showPause(const StudentScript::Pause &pause)
{
    m_pane.setExecuting(pause.line);
    m_pane.showLocals(valuesOf(pause));
}

void CodeDesk::showReport()
{
    const auto &report = m_workbench.check().report();
    const int line = report ? suspectLine(*report) : 0;
    m_pane.editor().setSuspect(line);
    if (line > 0)
        m_pane.editor().revealLine(line);
    showSolutionButton();
}

void CodeDesk::showSolutionButton()
{
    m_pane.setSolutionAvailable(m_workbench.progress().mayShowSolution());
}

void CodeDesk::showReference(const QString &word)
{
    if (!m_reference) {
        m_reference = new ApiPage(&m_pane);
        m_reference->setWindowFlag(Qt::Window);
        m_reference->resize(m_reference->sizeHint().boundedTo(m_pane.window()->size()));
    }
    m_reference->setWindowTitle(tr("Reference of the lab's Lua"));
    m_reference->show();
    m_reference->raise();
    m_reference->activateWindow();
    m_reference->showWord(word);
}

void CodeDesk::startAfresh()
{
    const auto answer = QMessageBox::question(
        &m_pane, tr("Start this step afresh"),
        tr("Your program goes back to what this step started from. What you have written in this "
           "step stays among its versions. Go back?"),
        QMessageBox::Yes | QMessageBox::No, QMessageBox::No);
    if (answer == QMessageBox::Yes)
        m_workbench.waysBack().startAfresh();
}

} // namespace cradle
