// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/question.h"
#include "views/author/author_document.h"
#include "views/author/preview_folder.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QPushButton;
class QSplitter;
QT_END_NAMESPACE

namespace cradle {

class ChoiceBox;
class FormulaRenderer;
class HintsList;
class InstructionsPane;
class MarkdownEditor;
class MarkdownView;
class PredictionEditor;
class QuestionsEditor;
class StepFields;
class ValuesEditor;

/// The texts of a step: instructions and hints in CommonMark and TeX beside what the student will
/// see, in every language of the lab; the commit message and the id.
class TextTab final : public QWidget
{
    Q_OBJECT
public:
    /// Which text is written.
    enum Part { Instructions, Hints, CodeHints, PredictionPart, QuestionsPart, ValuesPart };

    explicit TextTab(AuthorDocument &document, QWidget *parent = nullptr);
    ~TextTab() override;

    [[nodiscard]] MarkdownEditor &editor() { return *m_editor; }
    /// The instructions as a student sees them.
    [[nodiscard]] InstructionsPane &student() { return *m_student; }
    /// Writes the figure \p name of the step's folder into the text, where the cursor is.
    void insertFigure(const QString &name, const QString &description);
    void open(Part part);
    void openHint(bool ofProgram, int hint);
    void openLine(int line); ///< of the instructions, from 1; 0: none of them
    /// The values, at one of \p step, or of the lab if that is empty.
    void openValue(const QString &step, const QString &name);
    /// Values and questions of which a field holds what is none.
    [[nodiscard]] QStringList refused() const;

signals:
    void figureRequested(); ///< the author wants the scene as a figure

private:
    void makeLayout();
    QWidget *makeEditorColumn();
    void wire();
    void retranslate();
    void reload();
    void reloadForm();
    void reloadText();
    void showPreview();
    void showUnknown();
    void followNames();
    void takeText(const QString &text);
    void takeHints(const QStringList &hints, int current);
    void editHints(const QString &text, const QStringList &hints, const QString &mergeKey);
    void takePrediction(const std::optional<Prediction> &prediction, const QString &field);
    void takeQuestions(const std::vector<Question> &questions, const QString &field);
    [[nodiscard]] Part part() const;
    [[nodiscard]] QString path() const; ///< of the instructions, in the language

    AuthorDocument &m_document;
    PreviewFolder m_pictures;
    FormulaRenderer *m_renderer; ///< of all texts of the tab
    QTimer m_previewTimer;
    ChoiceBox *m_part = nullptr;
    ChoiceBox *m_mode = nullptr; ///< for whom the preview is
    QPushButton *m_figure = nullptr;
    QSplitter *m_splitter = nullptr;
    HintsList *m_hints = nullptr;
    MarkdownEditor *m_editor = nullptr;
    QPushButton *m_unknown = nullptr;      ///< names that nothing is called
    InstructionsPane *m_student = nullptr; ///< the instructions with what stands among them
    MarkdownView *m_preview = nullptr;     ///< of a hint
    PredictionEditor *m_prediction = nullptr;
    QuestionsEditor *m_questions = nullptr;
    ValuesEditor *m_values = nullptr;
    StepFields *m_fields = nullptr;
    QStringList m_shownHints;
    QString m_previewed; ///< the step in the preview
    bool m_loading = false;
};

} // namespace cradle
