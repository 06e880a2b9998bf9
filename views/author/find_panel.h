// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/lab_search.h"
#include "views/author/author_document.h"

#include <QTimer>
#include <QWidget>

QT_BEGIN_NAMESPACE
class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QToolButton;
QT_END_NAMESPACE

namespace cradle {

class ChoiceBox;
class RowsList;

/// Finds and replaces over the whole lab: below the tabs, hidden until it is asked for. A place is
/// opened by choosing it; replacing all of them is one edit.
class FindPanel final : public QWidget
{
    Q_OBJECT
public:
    explicit FindPanel(AuthorDocument &document, QWidget *parent = nullptr);

    /// Shows the panel, with the keyboard in what is looked for. \param text  that; empty: as it is
    void open(const QString &text = {});

signals:
    void chosen(const cradle::Error &place); ///< its file below the lab's folder
    void said(const QString &text);

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void makeLayout();
    void wire();
    void retranslate();
    void find();
    void showCount();
    void goTo(int row);
    void replaceAll();
    [[nodiscard]] LabSearch search() const;

    AuthorDocument &m_document;
    std::vector<LabHit> m_hits;
    QTimer m_soon; ///< while more may be typed
    QLineEdit *m_find = nullptr;
    QLineEdit *m_with = nullptr;
    QCheckBox *m_case = nullptr;
    QCheckBox *m_words = nullptr;
    ChoiceBox *m_where = nullptr;
    QLabel *m_count = nullptr;
    QPushButton *m_replace = nullptr;
    QToolButton *m_close = nullptr;
    RowsList *m_list = nullptr;
};

} // namespace cradle
