// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/author_exports.h"
#include "app/author_files.h"
#include "app/author_notices.h"
#include "app/author_panes.h"
#include "app/author_ways.h"
#include "views/author/author_document.h"

#include <QMainWindow>

class QSettings;

namespace cradle {

class Menu;

/// The window in which a lab is written: its steps on the left, and of the open step the scene,
/// the texts, the checks, the programs and the proof that they work.
class AuthorWindow final : public QMainWindow
{
    Q_OBJECT
public:
    using enum AuthorPanes::Tab;

    /// \param settings  where the size of the window is kept
    explicit AuthorWindow(QSettings &settings);
    ~AuthorWindow() override;

    [[nodiscard]] AuthorDocument &document() { return m_document; }
    [[nodiscard]] AuthorPanes &panes() { return m_panes; }
    [[nodiscard]] AuthorWays &ways() { return m_ways; }
    [[nodiscard]] AuthorFiles &files() { return m_files; }
    [[nodiscard]] AuthorExports &exports() { return m_exports; }
    [[nodiscard]] SceneTab &sceneTab() { return *m_panes.scene; }
    [[nodiscard]] TextTab &textTab() { return *m_panes.text; }
    [[nodiscard]] ChecksTab &checksTab() { return *m_panes.checks; }
    [[nodiscard]] ProgramsTab &programsTab() { return *m_panes.programs; }
    [[nodiscard]] ProofTab &proofTab() { return *m_panes.proof; }
    [[nodiscard]] StepsPanel &steps() { return *m_panes.steps; }
    [[nodiscard]] NoticeBar &notice() { return *m_panes.notice; }
    [[nodiscard]] QTabWidget &tabs() { return *m_panes.tabs; }

public slots:
    void openAsStudent();
    void editProperties(); ///< of the lab: title, version, id
    void insertFigure();   ///< the scene as it is shown

signals:
    /// To open that lab as a student, at the step with that id; empty if it cannot be read.
    void studentRequested(const QString &folder, const QString &task);

protected:
    void changeEvent(QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void wire();
    void retranslate();
    void showState();

    QSettings &m_settings;
    AuthorDocument m_document;
    AuthorPanes m_panes;
    AuthorNotices m_notices;
    AuthorWays m_ways;
    AuthorFiles m_files;
    AuthorExports m_exports;
    Menu *m_stepMenu = nullptr; ///< above the list of steps, too
};

} // namespace cradle
