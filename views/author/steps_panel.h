// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/author/author_document.h"

#include <QByteArrayList>
#include <QWidget>

QT_BEGIN_NAMESPACE
class QLabel;
class QListWidgetItem;
class QToolButton;
QT_END_NAMESPACE

namespace cradle {

class FindingsList;
class RowsList;

/// The steps of the lab that is written: add, duplicate, remove, rename in place, reorder by drag
/// or Alt+Up and Alt+Down. Below them, what is wrong with the lab's files; a click goes there.
class StepsPanel final : public QWidget
{
    Q_OBJECT
public:
    explicit StepsPanel(AuthorDocument &document, QWidget *parent = nullptr);

public slots:
    void addStep();
    void duplicateStep();
    void removeStep();
    void renameStep(); ///< begins to edit its title in the list
    void moveUp();
    void moveDown();

signals:
    void said(const QString &text); ///< what the author should know of an edit
    /// At a place of the screen: what can be done with the step there.
    void menuRequested(const QPoint &place);
    void findingChosen(const cradle::Error &finding);
    void propertiesRequested(); ///< of the lab

private:
    enum Role { FolderRole = Qt::UserRole, TitleRole }; ///< of a row: the step's folder and title

    void makeLayout();
    void retranslate();
    void reload();
    void reloadIfNew();
    void showCurrent();
    void markFindings();
    void move(int from, int to);
    void takeOrder();                      ///< of the list, after a drag
    void takeTitle(QListWidgetItem *item); ///< after it was edited in place
    void setTitle(const QString &step, const QString &title);
    void enableButtons();

    AuthorDocument &m_document;
    QLabel *m_title = nullptr; ///< of the lab
    QToolButton *m_properties = nullptr;
    RowsList *m_list = nullptr;
    FindingsList *m_findings = nullptr;
    QByteArrayList m_shown; ///< what the rows were made of
    bool m_loading = false;
};

} // namespace cradle
