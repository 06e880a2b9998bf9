// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/code_pane.h"

#include "views/code/code_actions.h"
#include "views/code/code_editor.h"
#include "views/code/code_header.h"
#include "views/code/find_bar.h"
#include "views/code/locals_table.h"
#include "views/code/solution_view.h"
#include "views/on_change.h"

#include <QAction>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>

namespace cradle {

namespace {

constexpr double localsShare = 0.42; ///< of the pane, at most

} // namespace

CodePane::CodePane(QWidget *parent)
    : QWidget(parent)
    , m_actions(new CodeActions(this))
    , m_header(new CodeHeader(*m_actions))
    , m_splitter(new QSplitter(Qt::Horizontal))
    , m_editor(new CodeEditor)
    , m_findBar(new FindBar(*m_editor))
    , m_solution(new SolutionView)
    , m_locals(new LocalsTable)
{
    for (QWidget *part : {static_cast<QWidget *>(m_editor), static_cast<QWidget *>(m_solution),
                          static_cast<QWidget *>(m_locals)})
        m_splitter->addWidget(part);
    m_splitter->setChildrenCollapsible(false);
    m_solution->hide();
    m_locals->hide();
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_header);
    column->addWidget(m_splitter, 1);
    column->addWidget(m_findBar);
    setFocusProxy(m_editor);
    m_header->setTitle(QStringLiteral("lab.lua"));
    m_header->atOnce().setChecked(true);
    wire();
    keepTranslated(this, &CodePane::retranslate);
}

void CodePane::wire()
{
    const auto on = [this](QAction *action, auto slot) {
        connect(action, &QAction::triggered, this, slot);
    };
    on(m_actions->run, &CodePane::applyRequested);
    on(m_actions->stepLine, &CodePane::lineStepRequested);
    on(m_actions->finishStep, &CodePane::finishStepRequested);
    on(m_actions->afresh, &CodePane::afreshRequested);
    on(m_actions->solution, [this] {
        if (isSolutionShown())
            hideSolution();
        else
            emit solutionRequested();
    });
    on(m_actions->help, [this] { emit helpRequested(m_editor->wordUnderCursor()); });
    on(m_actions->find, &CodePane::find);
    on(m_actions->replace, &CodePane::replace);
    on(m_actions->findNext, [this] { m_findBar->findNext(true); });
    on(m_actions->findPrevious, [this] { m_findBar->findNext(false); });
    on(m_actions->zoomIn, [this] { m_editor->zoomIn(); });
    on(m_actions->zoomOut, [this] { m_editor->zoomOut(); });
    on(m_actions->zoomReset, [this] { m_editor->resetZoom(); });
    connect(&m_header->atOnce(), &QPushButton::clicked, this, &CodePane::appliesAtOnceChanged);
    connect(m_editor, &CodeEditor::textEdited, this, &CodePane::textEdited);
    connect(m_editor, &CodeEditor::helpRequested, this, &CodePane::helpRequested);
    connect(m_editor, &CodeEditor::escapePressed, this, [this] {
        if (m_findBar->isVisible())
            m_findBar->close();
    });
    connect(m_editor, &CodeEditor::zoomChanged, &m_solution->editor(), &CodeEditor::setZoom);
    connect(&m_solution->editor(), &CodeEditor::zoomChanged, m_editor, &CodeEditor::setZoom);
    connect(&m_solution->editor(), &CodeEditor::helpRequested, this, &CodePane::helpRequested);
    connect(m_solution, &SolutionView::closeRequested, this, &CodePane::hideSolution);
}

void CodePane::setTitle(const QString &title)
{
    m_header->setTitle(title);
}

void CodePane::setState(CodeState state)
{
    m_state = state;
    m_header->setState(textOf(state), state == CodeState::Broken || state == CodeState::NeverRan);
}

QString CodePane::textOf(CodeState state)
{
    switch (state) {
    case CodeState::Saved:
        return tr("saved");
    case CodeState::Unsaved:
        return tr("not saved");
    case CodeState::ReadOnly:
        return tr("read only");
    case CodeState::Broken:
        return tr("cannot be read: the last good version runs");
    case CodeState::NeverRan:
        break;
    }
    return tr("cannot be read: nothing runs");
}

void CodePane::setAppliesAtOnce(bool atOnce)
{
    m_header->atOnce().setChecked(atOnce);
}

bool CodePane::appliesAtOnce() const
{
    return m_header->atOnce().isChecked();
}

void CodePane::setStepping(bool stepping)
{
    m_actions->stepLine->setEnabled(stepping);
    m_actions->finishStep->setEnabled(stepping);
    if (!stepping)
        setExecuting(0);
}

void CodePane::setExecuting(int line)
{
    m_editor->setExecuting(line);
    if (line < 1)
        hideLocals();
}

void CodePane::showLocals(const std::vector<ProgramValue> &locals)
{
    m_locals->setLocals(locals);
    if (m_locals->isHidden()) {
        m_locals->show();
        share();
    }
}

void CodePane::hideLocals()
{
    m_locals->hide();
}

void CodePane::setSolutionAvailable(bool available)
{
    m_actions->setSolutionAvailable(available);
    if (!available)
        hideSolution();
}

void CodePane::showSolution(const QString &text)
{
    m_solution->setText(text);
    m_solution->show();
    m_actions->setSolutionShown(true);
    share();
}

void CodePane::hideSolution()
{
    if (m_solution->isHidden())
        return;
    const bool focused = m_solution->isAncestorOf(focusWidget());
    m_solution->hide();
    m_actions->setSolutionShown(false);
    if (focused)
        m_editor->setFocus();
}

bool CodePane::isSolutionShown() const
{
    return !m_solution->isHidden();
}

/// Equal widths for both programs; the locals need no more than their share.
void CodePane::share()
{
    const int whole = m_splitter->width();
    const int locals = m_locals->isHidden() ? 0
                                            : std::min(m_locals->sizeHint().width(),
                                                       static_cast<int>(localsShare * whole));
    const int solution = m_solution->isHidden() ? 0 : (whole - locals) / 2;
    m_splitter->setSizes({whole - locals - solution, solution, locals});
}

void CodePane::find()
{
    m_findBar->open(false);
}

void CodePane::replace()
{
    m_findBar->open(true);
}

void CodePane::retranslate()
{
    setAccessibleName(tr("Program"));
    m_actions->retranslate();
    m_header->retranslate();
    m_header->setStates({textOf(CodeState::Saved), textOf(CodeState::Unsaved),
                         textOf(CodeState::ReadOnly), textOf(CodeState::Broken),
                         textOf(CodeState::NeverRan)});
    setState(m_state);
}

} // namespace cradle
