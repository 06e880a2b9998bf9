// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/code/search_term.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QLabel;
class QLineEdit;
class QPushButton;
class QToolButton;
QT_END_NAMESPACE

namespace cradle {

class CodeEditor;

/// The bar under an editor that finds and replaces in it; hidden until it is opened.
class FindBar final : public QWidget
{
    Q_OBJECT
public:
    /// \param editor  outlives this one
    explicit FindBar(CodeEditor &editor, QWidget *parent = nullptr);

    /// Shows the bar with what is selected in the editor, ready to type.
    void open(bool withReplace);
    void close();
    /// Goes to the next match of what was searched last, or opens the bar.
    void findNext(bool forward);

protected:
    void paintEvent(QPaintEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makeLayout();
    void retranslate();
    [[nodiscard]] SearchTerm term() const;
    void search();
    void replaceOne();
    void replaceAll();
    void refresh();
    void showPlace(SearchPlace place);

    CodeEditor &m_editor;
    QLineEdit *m_find;
    QLineEdit *m_replacement;
    QLabel *m_count;
    QToolButton *m_previous;
    QToolButton *m_next;
    QToolButton *m_matchCase;
    QToolButton *m_wholeWord;
    QToolButton *m_close;
    QPushButton *m_replaceOne;
    QPushButton *m_replaceAll;
    QWidget *m_replaceRow;
};

} // namespace cradle
