// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/author/text_names.h"

#include <QPlainTextEdit>

namespace cradle {

class MarkdownHighlighter;

/// Where an author writes CommonMark with TeX: plain text whose marks are coloured, with a wavy
/// line under names that nothing is called. Undo is the document's, not its own.
class MarkdownEditor final : public QPlainTextEdit
{
    Q_OBJECT
public:
    explicit MarkdownEditor(QWidget *parent = nullptr);
    ~MarkdownEditor() override;

    /// Shows \p text; the cursor stays where it was in what did not change.
    void showText(const QString &text);
    /// Puts \p text where the cursor is, as a paragraph of its own; the title stays above it.
    void insertParagraph(const QString &text);
    void setKnownNames(const TextNames &known);
    [[nodiscard]] const std::vector<UnknownName> &unknown() const { return m_unknown; }
    void goTo(const UnknownName &name); ///< selects it
    void goToLine(int line);            ///< from 1

signals:
    void edited(const QString &text); ///< by the author, not by showText()
    void unknownChanged();

protected:
    void changeEvent(QEvent *event) override;

private:
    void lookForNames();
    [[nodiscard]] QTextCursor selected(qsizetype start, qsizetype length) const;

    MarkdownHighlighter *m_highlighter; ///< child of the document
    TextNames m_known;
    std::vector<UnknownName> m_unknown;
    QString m_text; ///< as it was shown or edited last
    bool m_showing = false;
};

/// Such an editor as a field of a form, \p height px high. \param name  of the object
[[nodiscard]] MarkdownEditor *makeTextField(const QString &name, int height, QWidget *parent);

} // namespace cradle
