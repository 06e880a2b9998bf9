// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/questions_editor.h"

#include "model/files/expression.h"
#include "model/files/unit.h"
#include "model/world/shortest_number.h"
#include "tasks/authoring/free_name.h"
#include "tasks/questions/answers.h"
#include "views/author/form_rows.h"
#include "views/author/markdown_editor.h"
#include "views/author/tool_buttons.h"
#include "views/task_pane/questions_card.h"

#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>

namespace cradle {

namespace {

using Kind = Question::Kind;

// The bounds of task.schema.json.
constexpr int mostAnswers = 8;
constexpr int fewestAnswers = 2;
constexpr int longestAnswer = 200;
constexpr int mostQuestions = 20;
constexpr double mostPoints = 1000.0;

constexpr Kind kinds[] = {Kind::Number, Kind::One, Kind::Several, Kind::Order, Kind::Text};

bool hasAnswers(Kind kind)
{
    return kind == Kind::One || kind == Kind::Several || kind == Kind::Order;
}

bool isChosen(const Question &question, int answer)
{
    return std::find(question.chosen.begin(), question.chosen.end(), answer)
           != question.chosen.end();
}

/// Whether what is typed says the same in other words: "2." while it becomes "2.5".
bool isSame(const QString &typed, const QString &text, bool isNumber)
{
    if (typed.trimmed() == text.trimmed())
        return true;
    const Result<double> a = evaluated(typed);
    const Result<double> b = evaluated(text);
    return isNumber && a && b && *a == *b;
}

} // namespace

void QuestionsEditor::wire()
{
    connect(m_list, &QListWidget::currentRowChanged, this, [this] {
        if (!m_loading)
            showCurrent();
    });
    connect(m_add, &QToolButton::clicked, this, &QuestionsEditor::add);
    connect(m_remove, &QToolButton::clicked, this, &QuestionsEditor::remove);
    connect(m_up, &QToolButton::clicked, this, [this] { move(-1); });
    connect(m_down, &QToolButton::clicked, this, [this] { move(1); });
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
    connect(m_answers, &QListWidget::itemChanged, this, &QuestionsEditor::takeAnswers);
    connect(m_answers, &QListWidget::currentRowChanged, this, &QuestionsEditor::enableButtons);
    connect(m_addAnswer, &QToolButton::clicked, this, &QuestionsEditor::addAnswer);
    connect(m_removeAnswer, &QToolButton::clicked, this, &QuestionsEditor::removeAnswer);
    connect(m_answerUp, &QToolButton::clicked, this, [this] { moveAnswer(-1); });
    connect(m_answerDown, &QToolButton::clicked, this, [this] { moveAnswer(1); });
}

int QuestionsEditor::at() const
{
    return m_list->currentRow();
}

void QuestionsEditor::showQuestions(const std::vector<Question> &questions, const QString &step)
{
    const int before = step == m_step ? at() : 0;
    m_questions = questions;
    m_step = step;
    m_loading = true;
    while (m_list->count() > static_cast<int>(questions.size()))
        delete m_list->takeItem(m_list->count() - 1);
    for (int i = 0; i < static_cast<int>(questions.size()); ++i) {
        if (i >= m_list->count())
            m_list->addItem(QString());
        m_list->item(i)->setText(questions[static_cast<std::size_t>(i)].title);
    }
    m_list->doItemsLayout();
    const int last = m_list->count() - 1;
    m_list->setCurrentRow(std::clamp(before, std::min(0, last), last));
    m_loading = false;
    m_heading->setText(tr("Questions · %1").arg(m_list->count()));
    m_card->setQuestions(questions, {});
    m_card->setAnswers(rightAnswers(questions));
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
    enableButtons();
}

bool QuestionsEditor::isShown(Line line) const
{
    const bool ofNumbers = line == Number || line == Tolerance || line == Unit;
    return !ofNumbers || current().kind == Kind::Number;
}

QString QuestionsEditor::valueText(Line line) const
{
    const Question &question = current();
    switch (line) {
    case Title:
        return question.title;
    case Id:
        return question.id;
    case Points:
        return question.points == 1.0 ? QString() : fractionOrNumber(question.points);
    case Number:
        return question.expression.isEmpty() ? fractionOrNumber(question.number)
                                             : question.expression;
    case Tolerance:
        return question.tolerance == 0.0 ? QString() : fractionOrNumber(question.tolerance);
    case Unit:
        return question.unit;
    case LineCount:
        break;
    }
    return {};
}

void QuestionsEditor::showLines()
{
    for (int i = 0; i < LineCount; ++i) {
        const Line line = static_cast<Line>(i);
        QLineEdit *edit = m_lines[i];
        const QString value = valueText(line);
        const RefusedTexts::Text *refused = m_texts.find(edit->objectName(), value);
        const QString text = refused ? refused->typed : value;
        if (!isSame(edit->text(), text, line == Points || line == Number || line == Tolerance))
            edit->setText(text);
        markRefused(edit, refused != nullptr);
        m_captions[i]->setVisible(isShown(line));
        edit->setVisible(isShown(line));
    }
    showRefusal(m_refusal, m_texts.reason());
}

void QuestionsEditor::showAnswers()
{
    const QSignalBlocker blocker(m_answers);
    const Question &question = current();
    m_answersPart->setVisible(hasAnswers(question.kind));
    m_answersCaption->setText(question.kind == Kind::Order
                                  ? tr("Answers in the right order; students find them in another")
                              : question.kind == Kind::One
                                  ? tr("Answers; mark the right one")
                                  : tr("Answers; mark all that are right"));
    const int row = m_answers->currentRow();
    const auto count = static_cast<int>(question.answers.size());
    while (m_answers->count() > count)
        delete m_answers->takeItem(m_answers->count() - 1);
    while (m_answers->count() < count)
        m_answers->addItem(QString());
    for (int i = 0; i < count; ++i) {
        QListWidgetItem *item = m_answers->item(i);
        Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled;
        if (!m_readOnly)
            flags |= Qt::ItemIsEditable;
        if (!m_readOnly && question.kind != Kind::Order)
            flags |= Qt::ItemIsUserCheckable;
        item->setFlags(flags);
        item->setText(question.answers[i]);
        if (question.kind == Kind::Order)
            item->setData(Qt::CheckStateRole, {});
        else
            item->setCheckState(isChosen(question, i) ? Qt::Checked : Qt::Unchecked);
    }
    m_answers->setCurrentRow(std::clamp(row, std::min(0, count - 1), count - 1));
}

void QuestionsEditor::enableButtons()
{
    const bool writable = !m_readOnly;
    const bool any = at() >= 0;
    m_add->setEnabled(writable && !m_step.isEmpty() && m_list->count() < mostQuestions);
    m_remove->setEnabled(writable && any);
    m_up->setEnabled(writable && at() > 0);
    m_down->setEnabled(writable && any && at() + 1 < m_list->count());
    m_kind->setEnabled(writable);
    m_text->setReadOnly(m_readOnly);
    for (QLineEdit *line : m_lines)
        line->setReadOnly(m_readOnly);
    const int answer = m_answers->currentRow();
    m_addAnswer->setEnabled(writable && m_answers->count() < mostAnswers);
    m_removeAnswer->setEnabled(writable && answer >= 0 && m_answers->count() > fewestAnswers);
    m_answerUp->setEnabled(writable && answer > 0);
    m_answerDown->setEnabled(writable && answer >= 0 && answer + 1 < m_answers->count());
}

void QuestionsEditor::setReadOnly(bool readOnly)
{
    m_readOnly = readOnly;
    showCurrent();
}

/// The window answers with showQuestions().
void QuestionsEditor::tell(const QString &field)
{
    const std::vector<Question> questions = m_questions;
    emit edited(questions,
                field.isEmpty() ? QString() : QStringLiteral("%1:%2").arg(at()).arg(field));
}

void QuestionsEditor::add()
{
    Question question{.id = {}, .title = tr("A new question"), .text = tr("What is asked?")};
    question.id = freeName(QStringLiteral("question"), [this](const QString &id) {
        return std::any_of(m_questions.begin(), m_questions.end(),
                           [&](const Question &each) { return each.id == id; });
    });
    const int to = at() + 1;
    m_questions.insert(m_questions.begin() + to, question);
    tell({});
    m_list->setCurrentRow(to);
    m_lines[Title]->setFocus();
    m_lines[Title]->selectAll();
}

void QuestionsEditor::remove()
{
    if (at() < 0)
        return;
    m_questions.erase(m_questions.begin() + at());
    tell({});
}

void QuestionsEditor::move(int by)
{
    const int to = at() + by;
    if (m_readOnly || at() < 0 || to < 0 || to >= m_list->count())
        return;
    std::swap(m_questions[static_cast<std::size_t>(at())],
              m_questions[static_cast<std::size_t>(to)]);
    tell({});
    m_list->setCurrentRow(to);
}

/// A kind that needs answers begins with two.
void QuestionsEditor::takeKind()
{
    if (at() < 0)
        return;
    Question &question = current();
    question.kind = kinds[m_kind->currentIndex()];
    if (hasAnswers(question.kind) && question.answers.size() < fewestAnswers)
        question.answers = {tr("The first answer"), tr("The second answer")};
    if (!hasAnswers(question.kind))
        question.answers.clear();
    if (question.kind == Kind::One)
        question.chosen.resize(1, 0);
    else if (question.kind == Kind::Several && question.chosen.empty())
        question.chosen = {0};
    else if (question.kind != Kind::Several)
        question.chosen.clear();
    tell({});
}

/// Takes the text of a line into the question.
/// \return why it cannot be taken; empty if it was
QString QuestionsEditor::takeText(Line line, const QString &text)
{
    static const QRegularExpression idForm(QStringLiteral("^[A-Za-z0-9._-]{1,64}$"));
    Question &question = current();
    const Result<double> number = evaluated(text, {}, question.unit);
    switch (line) {
    case Title:
        if (text.isEmpty())
            return tr("A title of 1 to 200 characters is right");
        question.title = text;
        break;
    case Id:
        if (!idForm.match(text).hasMatch())
            return tr("An id of letters, digits, dots and dashes is right");
        if (std::any_of(m_questions.begin(), m_questions.end(), [&](const Question &each) {
                return &each != &question && each.id == text;
            }))
            return tr("Another question has this id already");
        question.id = text;
        break;
    case Points:
        if (!text.isEmpty() && (!number || *number < 0.0 || *number > mostPoints))
            return tr("Points: a number from 0 to 1000 is right");
        question.points = text.isEmpty() ? 1.0 : *number;
        break;
    case Number: {
        if (!number)
            return number.error().message;
        bool plain = false;
        (void)text.toDouble(&plain);
        question.number = *number;
        question.expression = plain ? QString() : text;
        break;
    }
    case Tolerance:
        if (!text.isEmpty() && (!number || *number < 0.0))
            return tr("Tolerance: a number from 0 is right");
        question.tolerance = text.isEmpty() ? 0.0 : *number;
        break;
    case Unit:
        if (!unitFrom(text))
            return tr("%1 is no unit; one like m/s, kg m/s, N s, J, ° or % is right").arg(text);
        question.unit = text;
        break;
    case LineCount:
        break;
    }
    return {};
}

void QuestionsEditor::takeLine(Line line)
{
    if (at() < 0)
        return;
    QLineEdit *edit = m_lines[line];
    const Question before = current();
    const QString value = valueText(line);
    const QString reason = takeText(line, edit->text().trimmed());
    if (!reason.isEmpty())
        m_texts.keep(edit->objectName(), {edit->text(), value, reason});
    else
        m_texts.drop(edit->objectName());
    if (line == Id && reason.isEmpty())
        m_texts.rename(m_step + QLatin1Char('/') + current().id);
    markRefused(edit, !reason.isEmpty());
    showRefusal(m_refusal, m_texts.reason());
    if (!(current() == before))
        tell(edit->objectName());
}

/// Marks and texts of the answers; one that is emptied stays as it was.
void QuestionsEditor::takeAnswers()
{
    if (at() < 0)
        return;
    Question &question = current();
    const Question before = question;
    std::vector<int> marked;
    for (int i = 0; i < m_answers->count(); ++i) {
        const QString text = m_answers->item(i)->text().trimmed().left(longestAnswer);
        if (!text.isEmpty())
            question.answers[i] = text;
        if (m_answers->item(i)->checkState() == Qt::Checked)
            marked.push_back(i);
    }
    if (question.kind == Kind::One) // the mark moves
        marked.erase(std::remove_if(marked.begin(), marked.end(),
                                    [&](int each) { return isChosen(before, each); }),
                     marked.end());
    if (!marked.empty() && question.kind != Kind::Order)
        question.chosen = marked;
    if (question == before)
        showAnswers();
    else
        tell(QStringLiteral("answers"));
}

void QuestionsEditor::addAnswer()
{
    current().answers.append(tr("Another answer"));
    tell({});
    m_answers->setCurrentRow(m_answers->count() - 1);
    m_answers->setFocus();
    m_answers->editItem(m_answers->currentItem());
}

void QuestionsEditor::removeAnswer()
{
    const int answer = m_answers->currentRow();
    Question &question = current();
    if (answer < 0 || question.answers.size() <= fewestAnswers)
        return;
    question.answers.removeAt(answer);
    std::vector<int> chosen;
    for (const int each : question.chosen) {
        if (each != answer)
            chosen.push_back(each > answer ? each - 1 : each);
    }
    if (chosen.empty() && question.kind != Kind::Order)
        chosen = {0};
    question.chosen = chosen;
    tell({});
}

void QuestionsEditor::moveAnswer(int by)
{
    const int answer = m_answers->currentRow();
    const int to = answer + by;
    if (m_readOnly || answer < 0 || to < 0 || to >= m_answers->count())
        return;
    Question &question = current();
    question.answers.swapItemsAt(answer, to);
    for (int &each : question.chosen)
        each = each == answer ? to : each == to ? answer : each;
    std::sort(question.chosen.begin(), question.chosen.end());
    tell({});
    m_answers->setCurrentRow(to);
}

void QuestionsEditor::retranslate()
{
    m_heading->setText(tr("Questions · %1").arg(m_list->count()));
    m_list->setAccessibleName(tr("Questions of the step"));
    nameButton(m_add, tr("Add a question"));
    nameButton(m_remove, tr("Remove the question"), tr("Delete"));
    nameButton(m_up, tr("Move the question up"), tr("Alt+Up"));
    nameButton(m_down, tr("Move the question down"), tr("Alt+Down"));
    m_empty->setText(tr("This step asks no question that counts. Add one with the plus: a number "
                        "with its unit, a choice, an order, or a text that you read yourself."));
    const QString names[] = {tr("A number"), tr("One choice"), tr("Several choices"),
                             tr("An order"), tr("A text for the teacher")};
    const int kind = m_kind->currentIndex();
    m_kind->clear();
    for (std::size_t i = 0; i < std::size(kinds); ++i)
        m_kind->addItem(names[i], nameOf(kinds[i]));
    m_kind->setCurrentIndex(kind);
    m_kindCaption->setText(tr("Kind"));
    m_kind->setAccessibleName(tr("Kind of the question"));
    const QString captions[] = {tr("Title"),        tr("Id"),        tr("Points"),
                                tr("Right number"), tr("Tolerance"), tr("Unit")};
    for (int i = 0; i < LineCount; ++i) {
        m_captions[i]->setText(captions[i]);
        m_lines[i]->setAccessibleName(captions[i]);
    }
    m_lines[Title]->setToolTip(tr("Reports name the question by it"));
    m_lines[Points]->setPlaceholderText(QStringLiteral("1"));
    m_lines[Points]->setToolTip(tr("What a right answer is worth; of a text, what you may give"));
    m_lines[Number]->setToolTip(tr("A number, or an expression like 2*9.81*5"));
    m_lines[Tolerance]->setPlaceholderText(QStringLiteral("0"));
    m_lines[Tolerance]->setToolTip(tr("How far off is still right, in the unit"));
    m_lines[Unit]->setToolTip(tr("Such as m/s, kg m/s, N s, J, ° or %; answers in other units of "
                                 "the same kind are converted"));
    m_textCaption->setText(tr("What is asked"));
    m_text->setAccessibleName(tr("What is asked"));
    m_answers->setAccessibleName(tr("Answers"));
    nameButton(m_addAnswer, tr("Add an answer"));
    nameButton(m_removeAnswer, tr("Remove the answer"), tr("Delete"));
    nameButton(m_answerUp, tr("Move the answer up"), tr("Alt+Up"));
    nameButton(m_answerDown, tr("Move the answer down"), tr("Alt+Down"));
    m_cardCaption->setText(tr("What the student sees, answered rightly"));
}

void QuestionsEditor::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        showCurrent();
    }
}

} // namespace cradle
