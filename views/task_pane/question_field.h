// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/question.h"

#include <QJsonValue>
#include <QWidget>

#include <memory>

namespace cradle {

/// Where one question is answered.
class QuestionField : public QWidget
{
    Q_OBJECT
public:
    /// Shows an answer as it is kept, and tells nobody.
    virtual void showAnswer(const QJsonValue &answer) = 0;

signals:
    void answered(const QJsonValue &answer); ///< empty: taken back

protected:
    using QWidget::QWidget;
};

/// The field for a question of its kind.
[[nodiscard]] std::unique_ptr<QuestionField> makeQuestionField(const Question &question);

} // namespace cradle
