// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/prediction.h"

#include <QWidget>

#include <optional>

QT_BEGIN_NAMESPACE
class QButtonGroup;
class QLabel;
class QLineEdit;
class QPushButton;
class QRadioButton;
class QToolButton;
QT_END_NAMESPACE

namespace cradle {

class FormulaRenderer;
class MarkdownEditor;
class PredictionCard;

/// What a step asks before it is watched, as a form, beside what the student sees of it before
/// and after.
class PredictionEditor final : public QWidget
{
    Q_OBJECT
public:
    /// \param renderer  sets formulas; outlives the editor
    explicit PredictionEditor(FormulaRenderer *renderer, QWidget *parent = nullptr);

    void showPrediction(const std::optional<Prediction> &prediction, bool readOnly);

signals:
    /// \param field  that was typed into; empty if answers, or the whole, came or went
    void edited(const std::optional<cradle::Prediction> &prediction, const QString &field);

private:
    static constexpr int mostAnswers = 4;
    struct AnswerRow {
        QWidget *widget = nullptr;
        QRadioButton *right = nullptr;
        QLineEdit *text = nullptr;
        QToolButton *remove = nullptr;
    };

    void makeLayout(FormulaRenderer *renderer);
    QWidget *makeNothing(QWidget *parent);
    QWidget *makeForm(QWidget *parent);
    void makeAnswer(int answer);
    QWidget *makeCards(FormulaRenderer *renderer);
    void wire();
    void retranslate();
    void setPrediction(const std::optional<Prediction> &prediction);
    void change(const std::optional<Prediction> &prediction); ///< and tells of it
    void showAnswers();
    void showCards();
    void enableFields();
    void begin();
    void addAnswer();
    void removeAnswer(int answer);
    void take(const QString &field);
    [[nodiscard]] QString faultOf(const Prediction &prediction);

    std::optional<Prediction> m_prediction;
    bool m_readOnly = false;
    QWidget *m_nothing = nullptr; ///< shown while there is no prediction
    QLabel *m_none = nullptr;
    QPushButton *m_begin = nullptr;
    QWidget *m_form = nullptr;
    MarkdownEditor *m_question = nullptr;
    QLabel *m_answersCaption = nullptr;
    QButtonGroup *m_right = nullptr;
    AnswerRow m_rows[mostAnswers]{};
    QPushButton *m_add = nullptr;
    MarkdownEditor *m_outcome = nullptr;
    QLabel *m_refusal = nullptr;
    QPushButton *m_removeAll = nullptr;
    QWidget *m_cardsPane = nullptr; ///< hidden while there is no prediction
    QWidget *m_cards = nullptr;
    QLabel *m_beforeCaption = nullptr;
    PredictionCard *m_before = nullptr;
    QLabel *m_afterCaption = nullptr;
    PredictionCard *m_after = nullptr;
};

} // namespace cradle
