// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/text_tab.h"

#include "tasks/authoring/lab_edits.h"
#include "views/author/form_rows.h"
#include "views/author/hints_list.h"
#include "views/author/markdown_editor.h"
#include "views/author/prediction_editor.h"
#include "views/author/questions_editor.h"
#include "views/author/step_fields.h"
#include "views/author/values_editor.h"
#include "views/boxes.h"
#include "views/choice_box.h"
#include "views/flow_layout.h"
#include "views/formula_renderer.h"
#include "views/markdown_view.h"
#include "views/on_change.h"
#include "views/task_pane/instructions_pane.h"
#include "views/theme.h"

#include <QComboBox>
#include <QPushButton>
#include <QSplitter>

namespace cradle {

namespace {

constexpr int previewDelay = 150; ///< ms after a key, while more may follow

} // namespace

TextTab::TextTab(AuthorDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_renderer(new FormulaRenderer(this))
{
    m_previewTimer.setSingleShot(true);
    m_previewTimer.setInterval(previewDelay);
    makeLayout();
    keepTranslated(this, &TextTab::retranslate);
    wire();
    reload();
}

TextTab::~TextTab()
{
    // The views before the renderer that they share.
    delete m_splitter;
    delete m_prediction;
    delete m_questions;
}

void TextTab::makeLayout()
{
    m_part = new ChoiceBox(this);
    m_mode = new ChoiceBox(this);
    m_figure = new QPushButton(this);
    m_part->setObjectName(QStringLiteral("textPart"));
    setKind(m_figure, "small");
    auto *top = new FlowLayout; // with large texts they are more than a row
    top->setSpacing(8);
    top->setContentsMargins(12, 8, 12, 8);
    top->addWidget(m_part);
    top->addWidget(m_figure);
    top->addWidget(m_mode);

    m_preview = new MarkdownView(this, m_renderer);
    m_student = new InstructionsPane(this, m_renderer);
    auto *previews = new QWidget(this);
    layOutColumn(previews, {}, -1, {m_student, m_preview});
    m_splitter = makeSplitter(Qt::Horizontal, {makeEditorColumn(), previews}, {500, 500});

    m_prediction = new PredictionEditor(m_renderer, this);
    m_questions = new QuestionsEditor(m_renderer, this);
    m_values = new ValuesEditor(m_document, this);
    m_fields = new StepFields(m_document, this);
    layOutColumn(
        this, {}, 0,
        {top, {m_splitter, 1}, {m_prediction, 1}, {m_questions, 1}, {m_values, 1}, m_fields});
}

QWidget *TextTab::makeEditorColumn()
{
    auto *side = new QWidget(this);
    m_hints = new HintsList(side);
    m_editor = new MarkdownEditor(side);
    m_editor->setObjectName(QStringLiteral("markdown"));
    m_unknown = new QPushButton(side);
    m_unknown->setObjectName(QStringLiteral("unknownNames"));
    setKind(m_unknown, "link");
    auto *foot = makeRow({8, 0, 8, 0}, -1, {{m_unknown, 0, Qt::AlignLeft}});
    layOutColumn(side, {}, 0, {m_hints, {m_editor, 1}, foot});
    return side;
}

void TextTab::wire()
{
    connect(&m_document, &AuthorDocument::changed, this, &TextTab::reload);
    connect(&m_document, &AuthorDocument::stepChanged, this, &TextTab::reload);
    connect(&m_document, &AuthorDocument::languageChanged, this, &TextTab::reload);
    connect(&m_document, &AuthorDocument::labRead, this, &TextTab::followNames);
    connect(&m_document, &AuthorDocument::stepChanged, this, &TextTab::followNames);
    connect(m_part, &QComboBox::currentIndexChanged, this, &TextTab::reload);
    connect(m_mode, &QComboBox::currentIndexChanged, this, &TextTab::showPreview);
    connect(m_hints, &HintsList::currentChanged, this, &TextTab::reloadText);
    connect(m_hints, &HintsList::edited, this, &TextTab::takeHints);
    connect(m_editor, &MarkdownEditor::edited, this, &TextTab::takeText);
    connect(m_editor, &MarkdownEditor::unknownChanged, this, &TextTab::showUnknown);
    connect(m_unknown, &QPushButton::clicked, this, [this] {
        if (!m_editor->unknown().empty())
            m_editor->goTo(m_editor->unknown().front());
    });
    connect(m_figure, &QPushButton::clicked, this, &TextTab::figureRequested);
    connect(m_student, &InstructionsPane::predicted, this,
            [this](int answer) { m_student->setGuess({.answer = answer, .watched = true}); });
    connect(m_student, &InstructionsPane::outcomeRequested, this, [this] {
        m_student->setGuess({.answer = Guess::notSure, .watched = true, .revealed = true});
    });
    connect(m_prediction, &PredictionEditor::edited, this, &TextTab::takePrediction);
    connect(m_questions, &QuestionsEditor::edited, this, &TextTab::takeQuestions);
    connect(&m_document, &AuthorDocument::opened, &m_questions->refusedTexts(),
            &RefusedTexts::clear);
    connect(&m_previewTimer, &QTimer::timeout, this, &TextTab::showPreview);
}

TextTab::Part TextTab::part() const
{
    return static_cast<Part>(std::max(m_part->currentIndex(), 0));
}

QString TextTab::path() const
{
    return instructionsPath(m_document.files(), m_document.step(), m_document.language());
}

void TextTab::reload()
{
    m_loading = true;
    setEnabled(!m_document.step().isEmpty());
    m_editor->setReadOnly(m_document.isReadOnly());
    m_figure->setEnabled(!m_document.isReadOnly());
    m_hints->setReadOnly(m_document.isReadOnly());
    const bool writes = part() == Instructions || part() == Hints || part() == CodeHints;
    m_splitter->setVisible(writes);
    m_prediction->setVisible(part() == PredictionPart);
    m_questions->setVisible(part() == QuestionsPart);
    m_values->setVisible(part() == ValuesPart);
    m_figure->setVisible(writes);
    m_mode->setVisible(writes);
    reloadForm();
    reloadText();
    m_loading = false;
}

void TextTab::reloadForm()
{
    const Result<TaskForm> form = m_document.form();
    m_hints->setVisible(form && part() != Instructions);
    m_values->reload();
    if (!form)
        return;
    const QStringList hints = part() == CodeHints ? form->codeHints : form->hints;
    m_prediction->showPrediction(form->prediction, m_document.isReadOnly());
    m_questions->showQuestions(form->questions, m_document.step(),
                               valuesOf(m_document.files(), m_document.step(), {}),
                               m_document.isReadOnly());
    if (hints != m_shownHints) {
        m_shownHints = hints;
        m_hints->showHints(hints);
    }
    m_fields->reload();
}

void TextTab::reloadText()
{
    if (part() == Instructions) {
        m_editor->setPlaceholderText(
            m_document.step().isEmpty()
                ? QString()
                : tr("No text in this language yet: students read it in the "
                     "lab's own."));
        m_editor->showText(textOf(m_document.files(), path()));
    } else {
        m_editor->setPlaceholderText(tr("No hint yet: add one with the plus above."));
        m_editor->showText(m_shownHints.value(m_hints->current()));
    }
    m_editor->setReadOnly(m_document.isReadOnly()
                          || (part() != Instructions && m_hints->current() < 0));
    m_previewTimer.start();
}

void TextTab::followNames()
{
    const Task *task = m_document.task();
    m_editor->setKnownNames(task ? textNames(*task) : TextNames());
}

void TextTab::showUnknown()
{
    const std::vector<UnknownName> &unknown = m_editor->unknown();
    m_unknown->setVisible(!unknown.empty());
    if (unknown.empty())
        return;
    const QString first = tr("Line %1: nothing here is called “%2”")
                              .arg(unknown.front().line)
                              .arg(unknown.front().name);
    const auto more = static_cast<int>(unknown.size()) - 1;
    m_unknown->setText(more == 0 ? first : tr("%1, and %2 more").arg(first).arg(more));
}

void TextTab::retranslate()
{
    m_part->setTexts({tr("Instructions"), tr("Hints without a program"), tr("Hints for a program"),
                      tr("Prediction"), tr("Questions that count"), tr("Values")});
    m_mode->setTexts({tr("As seen in Code mode"), tr("As seen in Explore mode")});
    m_part->setAccessibleName(tr("Which text"));
    m_mode->setAccessibleName(tr("Mode of the preview"));
    m_figure->setText(tr("Insert the scene as a figure"));
    m_figure->setToolTip(tr("Draws the moment that the Scene tab shows, with its arrows, as an SVG "
                            "in the step's folder"));
    m_editor->setAccessibleName(tr("Text in Markdown"));
    m_preview->setAccessibleName(tr("Preview"));
    m_unknown->setToolTip(tr("Names in backticks that neither the scene nor the programs have"));
    showUnknown();
    reloadText();
}

} // namespace cradle
