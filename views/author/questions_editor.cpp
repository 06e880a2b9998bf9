// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/questions_editor.h"

#include "tasks/questions/answers.h"
#include "tasks/questions/question_json.h"
#include "tasks/values/put_values.h"
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
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>

namespace cradle {

using namespace questions;

namespace {

constexpr int textHeight = 84;      ///< px
constexpr int answersHeight = 120;  ///< px
constexpr int questionsWidth = 200; ///< px

/// As the student with those values finds it.
Question withValuesPut(const Question &question, const Values &values)
{
    const Result<QJsonObject> put = taskWithNumbers(jsonFrom(question), values);
    return put ? questionFrom(*put) : question;
}

} // namespace

const FormLine<Question> QuestionsEditor::lines[LineCount] = {
    {"questionTitle", &Question::title},
    {"questionId", &Question::id},
    {"questionPoints", nullptr, &Question::points, 1.0},
    {"questionNumber", &Question::expression, &Question::number},
    {"questionTolerance", &Question::toleranceExpression, &Question::tolerance, 0.0},
    {"questionUnit", &Question::unit}};

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
    m_list = new RowsList(QStringLiteral("questions"), side,
                          {RowsList::Add, RowsList::Remove, RowsList::Up, RowsList::Down});
    m_list->wrapRows();
    side->setLayout(m_list->underHeading());
    return side;
}

QWidget *QuestionsEditor::makeForm()
{
    auto *side = new QWidget;
    m_empty = makeMutedText(side);
    m_form = new QWidget(side);
    m_kind = new QComboBox(m_form);
    m_kind->setObjectName(QStringLiteral("questionKind"));
    makeLines(lines, m_lines, m_form);
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
    m_list->setTexts(tr("Questions of the step"),
                     {{RowsList::Add, tr("Add a question")},
                      {RowsList::Remove, tr("Remove the question")},
                      {RowsList::Up, tr("Move the question up")},
                      {RowsList::Down, tr("Move the question down")}},
                     tr("Questions · %1"));
    m_empty->setText(tr("This step asks no question that counts. Add one with the plus: a number "
                        "with its unit, a choice, an order, or a text that you read yourself."));
    const QString names[] = {tr("A number"), tr("One choice"), tr("Several choices"),
                             tr("An order"), tr("A text for the teacher")};
    const int kind = m_kind->currentIndex();
    m_kind->clear();
    for (std::size_t i = 0; i < std::size(kinds); ++i)
        m_kind->addItem(names[i], nameOf(kinds[i]));
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
    m_answers->setTexts(tr("Answers"), {{RowsList::Add, tr("Add an answer")},
                                        {RowsList::Remove, tr("Remove the answer")},
                                        {RowsList::Up, tr("Move the answer up")},
                                        {RowsList::Down, tr("Move the answer down")}});
    m_cardCaption->setText(tr("What the student sees, answered rightly"));
}

void QuestionsEditor::wire()
{
    connect(m_list, &RowsList::currentRowChanged, this, &QuestionsEditor::showCurrent);
    connect(m_list, &RowsList::addRequested, this, &QuestionsEditor::add);
    connect(m_list, &RowsList::removeRequested, this, &QuestionsEditor::remove);
    connect(m_list, &RowsList::moveRequested, this, &QuestionsEditor::move);
    connect(m_kind, &QComboBox::activated, this, &QuestionsEditor::takeKind);
    connect(m_text, &MarkdownEditor::edited, this, [this](const QString &text) {
        if (at() < 0)
            return;
        current().text = text;
        tell(QStringLiteral("text"));
    });
    for (int i = 0; i < LineCount; ++i)
        connect(m_lines[i], &QLineEdit::textEdited, this,
                [this, i] { takeLine(static_cast<Line>(i)); });
    connect(m_answers, &RowsList::itemChanged, this, &QuestionsEditor::takeAnswers);
    connect(m_answers, &RowsList::addRequested, this, &QuestionsEditor::addAnswer);
    connect(m_answers, &RowsList::removeRequested, this, &QuestionsEditor::removeAnswer);
    connect(m_answers, &RowsList::moveRequested, this, &QuestionsEditor::moveAnswer);
}

int QuestionsEditor::at() const
{
    return m_list->currentRow();
}

void QuestionsEditor::showQuestions(const std::vector<Question> &questions, const QString &step,
                                    const Values &values, bool readOnly)
{
    m_readOnly = readOnly;
    m_values = values;
    const int before = step == m_step ? at() : 0;
    m_questions = questions;
    m_step = step;
    QStringList titles;
    std::vector<Question> shown;
    for (const Question &question : questions) {
        titles.append(question.title);
        shown.push_back(withValuesPut(question, values));
    }
    m_list->showRows(titles, before);
    m_card->setQuestions(shown, {});
    m_card->setAnswers(rightAnswers(shown));
    m_cardCaption->setVisible(!questions.empty());
    showCurrent();
}

void QuestionsEditor::showCurrent()
{
    m_empty->setVisible(at() < 0);
    m_form->setVisible(at() >= 0);
    if (at() >= 0) {
        m_texts.setSubject(m_step + QLatin1Char('/') + current().id);
        m_kind->setCurrentIndex(m_kind->findData(nameOf(current().kind)));
        m_text->showText(current().text);
        showLines();
        showAnswers();
    }
    enableFields();
}

bool QuestionsEditor::isShown(Line line) const
{
    const bool ofNumbers = line == Number || line == Tolerance || line == Unit;
    return !ofNumbers || current().kind == Question::Kind::Number;
}

void QuestionsEditor::showLines()
{
    for (int i = 0; i < LineCount; ++i) {
        m_texts.show(m_lines[i], lines[i].textIn(current()), lines[i].number);
        showField(m_lines[i], isShown(static_cast<Line>(i)));
    }
}

void QuestionsEditor::showAnswers()
{
    const QSignalBlocker blocker(m_answers);
    const Question &question = current();
    m_answersPart->setVisible(hasAnswers(question.kind));
    m_answersCaption->setText(question.kind == Question::Kind::Order
                                  ? tr("Answers in the right order; students find them in another")
                              : question.kind == Question::Kind::One
                                  ? tr("Answers; mark the right one")
                                  : tr("Answers; mark all that are right"));
    m_answers->showRows(question.answers, m_answers->currentRow());
    for (int i = 0; i < m_answers->count(); ++i) {
        QListWidgetItem *item = m_answers->item(i);
        Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled;
        if (!m_readOnly)
            flags |= Qt::ItemIsEditable;
        if (!m_readOnly && question.kind != Question::Kind::Order)
            flags |= Qt::ItemIsUserCheckable;
        item->setFlags(flags);
        if (question.kind == Question::Kind::Order)
            item->setData(Qt::CheckStateRole, {});
        else
            item->setCheckState(isChosen(question, i) ? Qt::Checked : Qt::Unchecked);
    }
}

void QuestionsEditor::enableFields()
{
    m_list->enableButtons(!m_readOnly, 0, m_step.isEmpty() ? 0 : mostQuestions);
    m_answers->enableButtons(!m_readOnly, fewestAnswers, mostAnswers);
    m_kind->setEnabled(!m_readOnly);
    m_text->setReadOnly(m_readOnly);
    for (QLineEdit *line : m_lines)
        line->setReadOnly(m_readOnly);
}

/// The window answers with showQuestions().
void QuestionsEditor::tell(const QString &field)
{
    const std::vector<Question> questions = m_questions;
    emit edited(questions,
                field.isEmpty() ? QString() : QStringLiteral("%1:%2").arg(at()).arg(field));
}

} // namespace cradle
