// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

QT_BEGIN_NAMESPACE
class QLabel;
class QLineEdit;
class QListWidget;
QT_END_NAMESPACE

namespace cradle {

class FormulaRenderer;
class MarkdownView;

/// The reference of the student's Lua, with its headings beside it and a field to search it.
/// A widget for a dock, or a window of its own.
class ApiPage final : public QWidget
{
    Q_OBJECT
public:
    /// \param renderer  shared with other views and outliving this one; nullptr: one of its own
    explicit ApiPage(QWidget *parent = nullptr, FormulaRenderer *renderer = nullptr);

    /// Scrolls to the entry of \p word: "circle1", "vec:length", "length", "math.sqrt" …
    /// \return whether there is one; if not, the page is searched for the word
    bool showWord(const QString &word);
    /// The heading that was gone to last; empty before.
    [[nodiscard]] QString currentHeading() const;

    /// Wide enough for the programs of the page.
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makeLayout();
    void retranslate();
    void listHeadings();
    void filter(const QString &text);
    void goTo(int row);
    void scrollTo(int heading);
    void searchOn(bool forward);

    QLineEdit *m_search;
    QListWidget *m_headings;
    QLabel *m_nothing;
    MarkdownView *m_view;
    bool m_filtering = false;
};

} // namespace cradle
