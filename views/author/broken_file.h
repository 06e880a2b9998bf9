// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/author/author_document.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QLabel;
class QPlainTextEdit;
QT_END_NAMESPACE

namespace cradle {

/// In place of the tabs of a step whose JSON cannot be read: what is wrong, and the file as text,
/// to be mended right here. The other steps go on as they are.
class BrokenFile final : public QWidget
{
    Q_OBJECT
public:
    explicit BrokenFile(AuthorDocument &document, QWidget *parent = nullptr);

    /// Shows the file of the open step that cannot be read. \return whether there is one
    bool follow();

private:
    void takeText();
    void retranslate();

    AuthorDocument &m_document;
    Error m_fault{};
    QLabel *m_heading = nullptr;
    QLabel *m_reason = nullptr;
    QLabel *m_note = nullptr;
    QPlainTextEdit *m_text = nullptr;
};

} // namespace cradle
