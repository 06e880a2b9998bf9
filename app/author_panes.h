// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QStringList>

QT_BEGIN_NAMESPACE
class QMainWindow;
class QTabWidget;
QT_END_NAMESPACE

namespace cradle {

class AuthorDocument;
class ChecksTab;
class FindPanel;
class NoticeBar;
class ProgramsTab;
class ProofTab;
class SceneTab;
class StepsPanel;
class TextTab;

/// Every part of an author's window, by its name. All show the document, and go before it.
struct AuthorPanes {
    Q_DECLARE_TR_FUNCTIONS(AuthorPanes)
    Q_DISABLE_COPY_MOVE(AuthorPanes)
public:
    /// The tabs, from the left.
    enum Tab { Scene, Text, Checks, Programs, Proof };

    /// Fills \p window, which outlives them, as \p document does.
    AuthorPanes(QMainWindow &window, AuthorDocument &document);
    ~AuthorPanes();

    /// Titles of the tabs, in the language in force.
    void retranslate();
    void showTab(int tab);
    /// Checks, values, questions, remarks and scenes in whose fields something is typed that is no
    /// value, and so not in the lab.
    [[nodiscard]] QStringList refused() const;

    QMainWindow &window;
    NoticeBar *notice;
    StepsPanel *steps;
    QTabWidget *tabs; ///< in their place may stand a file that must be mended first
    SceneTab *scene;
    TextTab *text;
    ChecksTab *checks;
    ProgramsTab *programs;
    ProofTab *proof;
    FindPanel *find;

private:
    [[nodiscard]] QWidget *makeLeftAndMiddle(QWidget *centre, AuthorDocument &document);
    void makeTabs(AuthorDocument &document);

    const AuthorDocument &m_document;
};

} // namespace cradle
