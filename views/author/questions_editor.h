// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/question.h"
#include "tasks/values/lab_values.h"
#include "views/author/form_line.h"
#include "views/author/refused_texts.h"

#include <QWidget>

#include <vector>

QT_BEGIN_NAMESPACE
class QComboBox;
class QLabel;
QT_END_NAMESPACE

namespace cradle {

class FormulaRenderer;
class MarkdownEditor;
class QuestionsCard;
class RowsList;

/// The questions that a step counts: a list, the chosen one as a form, and beside it what the
/// student sees of them.
class QuestionsEditor final : public QWidget
{
    Q_OBJECT
public:
    /// \param renderer  sets formulas; outlives the editor
    explicit QuestionsEditor(FormulaRenderer *renderer, QWidget *parent = nullptr);

    /// \param values  that expressions may name
    void showQuestions(const std::vector<Question> &questions, const QString &step,
                       const Values &values, bool readOnly);
    /// What was typed into questions, "STEP/ID", and is no value.
    [[nodiscard]] RefusedTexts &refusedTexts() { return m_texts; }

signals:
    /// \param field  that was typed into; empty if a question or an answer came, went or moved
    void edited(const std::vector<cradle::Question> &questions, const QString &field);

private:
    enum Line { Title, Id, Points, Number, Tolerance, Unit, LineCount };
    static const FormLine<Question> lines[LineCount];

    QWidget *makeList();
    QWidget *makeForm();
    QWidget *makeAnswers();
    QWidget *makeCard(FormulaRenderer *renderer);
    void wire();
    void retranslate();
    void showCurrent();
    void showLines();
    void showAnswers();
    void enableFields();
    void add();
    void remove();
    void move(int from, int to);
    void addAnswer();
    void removeAnswer();
    void moveAnswer(int from, int to);
    void takeKind();
    void takeLine(Line line);
    void takeAnswers();
    void tell(const QString &field);
    [[nodiscard]] bool isShown(Line line) const;
    [[nodiscard]] QString takeText(Line line, const QString &text);
    [[nodiscard]] int at() const;
    [[nodiscard]] Question &current() { return m_questions[static_cast<std::size_t>(at())]; }
    [[nodiscard]] const Question &current() const
    {
        return m_questions[static_cast<std::size_t>(at())];
    }

    std::vector<Question> m_questions;
    QString m_step;
    Values m_values;
    RefusedTexts m_texts;
    bool m_readOnly = false;
    RowsList *m_list = nullptr;
    QLabel *m_empty = nullptr;
    QWidget *m_form = nullptr;
    QComboBox *m_kind = nullptr;
    QLineEdit *m_lines[LineCount]{};
    MarkdownEditor *m_text = nullptr;
    QWidget *m_answersPart = nullptr;
    QLabel *m_answersCaption = nullptr;
    RowsList *m_answers = nullptr;
    QLabel *m_cardCaption = nullptr;
    QuestionsCard *m_card = nullptr;
};

} // namespace cradle
