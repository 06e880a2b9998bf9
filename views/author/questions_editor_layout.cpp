// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/questions_editor.h"

#include "views/author/form_rows.h"
#include "views/author/markdown_editor.h"
#include "views/author/question_bounds.h"
#include "views/author/rows_list.h"
#include "views/boxes.h"
#include "views/on_change.h"
#include "views/task_pane/questions_card.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

namespace cradle {

namespace {

constexpr int textHeight = 84;      ///< px
constexpr int answersHeight = 120;  ///< px
constexpr int questionsWidth = 200; ///< px

} // namespace

QuestionsEditor::QuestionsEditor(FormulaRenderer *renderer, QWidget *parent)
    : QWidget(parent)
{
    layOutSideBySide(this, {makeList(), scrolled(makeForm()), scrolled(makeCard(renderer))},
                     {questionsWidth, 400, 400});
    retranslate();
    wire();
    showQuestions({}, {}, {}, false);
    onChange(this, {QEvent::LanguageChange}, [this] {
        retranslate();
        showCurrent();
    });
}

QWidget *QuestionsEditor::makeList()
{
    auto *side = new QWidget;
    m_heading = makeHeading(side);
    m_list = new RowsList(QStringLiteral("questions"), side,
                          {RowsList::Add, RowsList::Remove, RowsList::Up, RowsList::Down});
    m_list->wrapRows();
    side->setLayout(m_list->underHeading(m_heading));
    return side;
}

QWidget *QuestionsEditor::makeForm()
{
    auto *side = new QWidget;
    m_empty = makeMutedText(side);
    m_form = new QWidget(side);
    m_kind = new QComboBox(m_form);
    m_kind->setObjectName(QStringLiteral("questionKind"));
    const char *const names[] = {"questionTitle",  "questionId",        "questionPoints",
                                 "questionNumber", "questionTolerance", "questionUnit"};
    for (int i = 0; i < LineCount; ++i) {
        m_lines[i] = new QLineEdit(m_form);
        m_lines[i]->setObjectName(QLatin1String(names[i]));
    }
    m_lines[Title]->setMaxLength(200); // as in task.schema.json
    m_lines[Points]->setPlaceholderText(QStringLiteral("1"));
    m_lines[Tolerance]->setPlaceholderText(QStringLiteral("0"));
    m_text = makeTextField(QStringLiteral("questionText"), textHeight, m_form);
    QFormLayout *rows = makeFormRows();
    for (QWidget *field : std::initializer_list<QWidget *>{
             m_kind, m_lines[Title], m_text, m_lines[Number], m_lines[Unit], m_lines[Tolerance]})
        addField(rows, field);
    auto *column = layOutColumn(m_form, {}, 8, {rows, makeAnswers()});
    auto *foot = makeFormRows();
    addField(foot, m_lines[Points]);
    addField(foot, m_lines[Id]);
    column->addLayout(foot);
    column->addWidget(makeRefusal(m_texts, m_form));
    layOutColumn(side, {12, 8, 12, 8}, -1, {m_empty, m_form, BoxPart::rest()});
    return side;
}

QWidget *QuestionsEditor::makeAnswers()
{
    m_answersPart = new QWidget(m_form);
    m_answersCaption = makeMutedText(m_answersPart);
    m_answers = new RowsList(QStringLiteral("questionAnswers"), m_answersPart,
                             {RowsList::Add, RowsList::Remove, RowsList::Up, RowsList::Down});
    m_answers->setFixedHeight(answersHeight);
    m_answers->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed
                               | QAbstractItemView::AnyKeyPressed);
    auto *top = new QHBoxLayout;
    top->addWidget(m_answersCaption, 1);
    for (const auto each : {RowsList::Up, RowsList::Down, RowsList::Add, RowsList::Remove})
        top->addWidget(m_answers->button(each), 0, Qt::AlignBottom);
    layOutColumn(m_answersPart, {}, 4, {top, m_answers});
    return m_answersPart;
}

QWidget *QuestionsEditor::makeCard(FormulaRenderer *renderer)
{
    auto *side = new QWidget;
    m_cardCaption = makeMutedText(side);
    m_card = new QuestionsCard(renderer, side);
    m_card->setEnabled(false); // to be looked at
    layOutColumn(side, {12, 8, 12, 8}, 8, {m_cardCaption, m_card, BoxPart::rest()});
    return side;
}

void QuestionsEditor::retranslate()
{
    m_heading->setText(tr("Questions · %1").arg(m_list->count()));
    m_list->setAccessibleName(tr("Questions of the step"));
    m_list->nameButton(RowsList::Add, tr("Add a question"));
    m_list->nameButton(RowsList::Remove, tr("Remove the question"));
    m_list->nameButton(RowsList::Up, tr("Move the question up"));
    m_list->nameButton(RowsList::Down, tr("Move the question down"));
    m_empty->setText(tr("This step asks no question that counts. Add one with the plus: a number "
                        "with its unit, a choice, an order, or a text that you read yourself."));
    const QString names[] = {tr("A number"), tr("One choice"), tr("Several choices"),
                             tr("An order"), tr("A text for the teacher")};
    const int kind = m_kind->currentIndex();
    m_kind->clear();
    for (std::size_t i = 0; i < std::size(questions::kinds); ++i)
        m_kind->addItem(names[i], nameOf(questions::kinds[i]));
    m_kind->setCurrentIndex(kind);
    nameField(m_kind, tr("Kind"), {}, tr("Kind of the question"));
    nameField(m_lines[Title], tr("Title"), tr("Reports name the question by it"));
    nameField(m_lines[Id], tr("Id"));
    nameField(m_lines[Points], tr("Points"),
              tr("What a right answer is worth; of a text, what you may give"));
    nameField(m_lines[Number], tr("Right number"), tr("A number, or an expression like 2*9.81*5"));
    nameField(m_lines[Tolerance], tr("Tolerance"), tr("How far off is still right, in the unit"));
    nameField(m_lines[Unit], tr("Unit"),
              tr("Such as m/s, kg m/s, N s, J, ° or %; answers in other units of the same kind "
                 "are converted"));
    nameField(m_text, tr("What is asked"));
    m_answers->setAccessibleName(tr("Answers"));
    m_answers->nameButton(RowsList::Add, tr("Add an answer"));
    m_answers->nameButton(RowsList::Remove, tr("Remove the answer"));
    m_answers->nameButton(RowsList::Up, tr("Move the answer up"));
    m_answers->nameButton(RowsList::Down, tr("Move the answer down"));
    m_cardCaption->setText(tr("What the student sees, answered rightly"));
}

} // namespace cradle
