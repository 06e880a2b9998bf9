// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

QT_BEGIN_NAMESPACE
class QLabel;
class QToolButton;
QT_END_NAMESPACE

namespace cradle {

class CodeEditor;

/// The reference solution beside the student's program, to be read.
class SolutionView final : public QWidget
{
    Q_OBJECT
public:
    explicit SolutionView(QWidget *parent = nullptr);

    void setText(const QString &text);
    [[nodiscard]] CodeEditor &editor() { return *m_editor; }

signals:
    void closeRequested();

private:
    void retranslate();

    QLabel *m_heading;
    QToolButton *m_close;
    CodeEditor *m_editor;
};

} // namespace cradle
