// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/questions/answers.h"

#include <QFrame>
#include <QUrl>

#include <vector>

class QLabel;
class QVBoxLayout;

namespace cradle {

class FormulaRenderer;
class QuestionField;

/// The questions of a step that the check counts, and where they are answered. Hidden if there are
/// none.
class QuestionsCard final : public QFrame
{
    Q_OBJECT
public:
    /// \param renderer  sets formulas; outlives the card
    explicit QuestionsCard(FormulaRenderer *renderer, QWidget *parent = nullptr);

    /// \param folder  of the pictures that the texts show
    void setQuestions(const std::vector<Question> &questions, const QUrl &folder);
    void setAnswers(const Answers &answers); ///< after setQuestions()

signals:
    /// \param answer  see Answers; empty: taken back
    void answered(const QString &question, const QJsonValue &answer);

private:
    void makeFields();
    void addQuestion(QVBoxLayout *column, const Question &question);

    FormulaRenderer *m_renderer;
    std::vector<Question> m_questions;
    std::vector<QuestionField *> m_fields; ///< one for each
    Answers m_answers;
    QUrl m_folder;
    QLabel *m_title = nullptr;
    QLabel *m_status = nullptr;
    QWidget *m_body = nullptr; ///< made anew for other questions
};

} // namespace cradle
