// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/lab_edits.h"
#include "views/author/author_document.h"
#include "views/author/refused_texts.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QLabel;
class QPlainTextEdit;
QT_END_NAMESPACE

namespace cradle {

/// A scene of the open step as the text of its file, in which numbers may be expressions with the
/// named values of the lab. What cannot be read stays there, with the reason, until it is mended;
/// the lab keeps what it had.
class SceneText final : public QWidget
{
    Q_OBJECT
public:
    explicit SceneText(AuthorDocument &document, QWidget *parent = nullptr);

    /// Shows the file of that scene as it is now, or what was typed of it and cannot be read.
    void showScene(StepPreset which);
    /// The files of which something is typed that cannot be read.
    [[nodiscard]] QStringList refused() const { return m_texts.subjects(); }

private:
    void takeText();
    void retranslate();

    AuthorDocument &m_document;
    StepPreset m_which = StepPreset::Start;
    QString m_path;       ///< of the file that is shown
    RefusedTexts m_texts; ///< by the paths of files
    QLabel *m_note = nullptr;
    QPlainTextEdit *m_text = nullptr;
};

} // namespace cradle
