// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

QT_BEGIN_NAMESPACE
class QPlainTextEdit;
QT_END_NAMESPACE

namespace cradle {

class MarkdownView;

/// What the student notes about a step, in Markdown with TeX, and beside it how it will look in the
/// report.
class NotesPane final : public QWidget
{
    Q_OBJECT
public:
    explicit NotesPane(QWidget *parent = nullptr);

    /// \param editable  whether it may be changed
    void setText(const QString &text, bool editable);
    [[nodiscard]] QString text() const;
    [[nodiscard]] QSize sizeHint() const override { return {700, 264}; }

signals:
    void edited(); ///< by the student

private:
    void retranslate();

    QPlainTextEdit *m_editor;
    MarkdownView *m_view;
    bool m_loading = false;
};

} // namespace cradle
