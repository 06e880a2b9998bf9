// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/text/formula_text.h"

#include <QTextBrowser>
#include <QTextCharFormat>
#include <QUrl>

#include <vector>

namespace cradle {

class FormulaRenderer;
class PictureObjects;

/// Shows instructions: CommonMark, TeX formulas and pictures.
///
/// Raw HTML shows as text. Pictures come from one folder and nothing else is ever loaded. Links
/// to http and https open in the web browser after a click; others do nothing but `step:ID`.
class MarkdownView final : public QTextBrowser
{
    Q_OBJECT
public:
    /// \param renderer  shared with other views and outliving this one; nullptr: one of its own
    explicit MarkdownView(QWidget *parent = nullptr, FormulaRenderer *renderer = nullptr);

    /// \param folder  where pictures may come from: a local folder, or a Qt resource as
    ///     `qrc:/labs/…` or QUrl::fromLocalFile(":/labs/…")
    void setMarkdown(const QString &text, const QUrl &folder);
    /// Inside a frame: without a margin and a background of its own.
    void setEmbedded(bool embedded);
    /// Whether every formula is set, or has said why it cannot be.
    [[nodiscard]] bool isComplete() const;
    /// What it shows as it is read aloud: formulas in words, pictures by what they are said to be.
    [[nodiscard]] QString spokenText() const;

signals:
    void stepRequested(const QString &id); ///< the student followed a link `step:ID`

protected:
    void changeEvent(QEvent *event) override;
    QMimeData *createMimeDataFromSelection() const override;
    QVariant loadResource(int, const QUrl &) override { return {}; }

private:
    struct Placed {
        FormulaSource source;
        QTextCharFormat format; ///< of the text that it stands in
    };

    void rebuild();
    void placeObjects();
    void isolate(QTextCursor &cursor);
    void placeFigure(QTextCursor &cursor);
    void showFormula(QTextCursor &cursor, int index);
    void replaceFormulas(const QString &tex, bool display);
    void followLink(const QUrl &link);

    FormulaRenderer *m_renderer;
    PictureObjects *m_pictures; ///< child
    QString m_markdown;
    QString m_folder;
    bool m_embedded = false;
    std::vector<Placed> m_formulas;
};

} // namespace cradle
