// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/values_form.h"
#include "views/author/author_document.h"
#include "views/author/form_line.h"
#include "views/author/refused_texts.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QLabel;
QT_END_NAMESPACE

namespace cradle {

class ChoiceBox;
class RowsList;

/// The named values of the lab and of the open step: a list, the chosen one as a form, and beside
/// it what it comes to for students and where it is used.
class ValuesEditor final : public QWidget
{
    Q_OBJECT
public:
    explicit ValuesEditor(AuthorDocument &document, QWidget *parent = nullptr);

    void reload();
    /// Chooses a value of \p step, or of the lab if that is empty.
    void showValue(const QString &step, const QString &name);
    /// The values of which a field holds what is none, as "NAME" or "STEP/NAME".
    [[nodiscard]] QStringList refused() const;

private:
    enum Line { Name, Expression, From, To, Step, LineCount };
    static const FormLine<ValueForm> lines[LineCount];

    /// A value and where it stands.
    struct Row {
        QString step; ///< empty: of the whole lab
        ValueForm value;
    };

    QWidget *makeList();
    QWidget *makeForm();
    QWidget *makeFacts();
    void wire();
    void retranslate();
    void showCurrent();
    void showLines();
    void showFacts();
    void add();
    void writeName(); ///< puts the keyboard there
    void remove();
    void takeLines(Line changed);
    void takeKind();
    void takePlace();
    void takeDraw();
    void put(const Row &row, const QString &mergeKey);
    [[nodiscard]] QString rowText(const Row &row) const;
    [[nodiscard]] bool isShown(Line line) const;
    /// The value as it is typed, and what is wrong with which line.
    [[nodiscard]] ValueForm typed(QString (&reasons)[LineCount], Line changed) const;
    [[nodiscard]] Result<LabFiles> with(const Row &row) const;
    [[nodiscard]] QStringList taken(const QString &step) const; ///< names of others there
    [[nodiscard]] int at() const;
    [[nodiscard]] const Row &current() const { return m_rows[static_cast<std::size_t>(at())]; }
    [[nodiscard]] static QString subjectOf(const Row &row);

    AuthorDocument &m_document;
    std::vector<Row> m_rows;
    QString m_chosen; ///< subjectOf() the current row
    RefusedTexts m_texts;
    int m_typing = 0; ///< typing into one value is one undo step a line
    RowsList *m_list = nullptr;
    QLabel *m_empty = nullptr;
    QWidget *m_form = nullptr;
    ChoiceBox *m_kind = nullptr;
    ChoiceBox *m_place = nullptr;
    QLineEdit *m_lines[LineCount]{};
    QLabel *m_refusal = nullptr;
    QLabel *m_facts = nullptr;
    QLineEdit *m_student = nullptr;
    QLabel *m_drawn = nullptr; ///< what that student gets
    QLineEdit *m_draw = nullptr;
};

} // namespace cradle
