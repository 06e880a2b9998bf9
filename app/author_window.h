// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/author/author_document.h"

#include <QMainWindow>
#include <QPointer>

QT_BEGIN_NAMESPACE
class QSplitter;
class QStackedWidget;
class QTabWidget;
QT_END_NAMESPACE

class QSettings;

namespace cradle {

class BrokenFile;
class NoticeBar;
class ChecksTab;
class FindPanel;
class Menu;
class ProgramsTab;
class ProofTab;
class SceneTab;
class StepsPanel;
class TextTab;

/// The window in which a lab is written: its steps on the left, and of the open step the scene,
/// the texts, the checks, the programs and the proof that they work.
class AuthorWindow final : public QMainWindow
{
    Q_OBJECT
public:
    /// The tabs, from the left.
    enum Tab { Scene, Text, Checks, Programs, Proof };

    /// \param settings  where the size of the window is kept
    explicit AuthorWindow(QSettings &settings);
    ~AuthorWindow() override;

    [[nodiscard]] AuthorDocument &document() { return m_document; }
    [[nodiscard]] SceneTab &sceneTab() { return *m_sceneTab; }
    [[nodiscard]] TextTab &textTab() { return *m_textTab; }
    [[nodiscard]] ChecksTab &checksTab() { return *m_checksTab; }
    [[nodiscard]] ProgramsTab &programsTab() { return *m_programsTab; }
    [[nodiscard]] ProofTab &proofTab() { return *m_proofTab; }
    [[nodiscard]] StepsPanel &steps() { return *m_steps; }
    [[nodiscard]] NoticeBar &notice() { return *m_notice; }
    [[nodiscard]] QTabWidget &tabs() { return *m_tabs; }

    /// Opens a lab's folder, or the lab that ships with the program, which stays as it is.
    std::optional<Error> open(const QString &folder);

public slots:
    void newLab();
    void openLab();     ///< a folder
    void openLabFile(); ///< NAME.cradle
    void openDropped(const QString &path);
    bool save();              ///< \return whether all is saved
    bool saveAs();            ///< also makes the copy of a lab that is read-only
    void exportLab();         ///< as one file
    void exportForStudents(); ///< the same without solutions and mistakes
    void openAsStudent();
    void editProperties(); ///< of the lab: title, version, id
    void insertFigure();   ///< the scene as it is shown
    void openValues();     ///< of the lab and the open step
    void openSearch();     ///< over the whole lab
    void showTab(int tab);

signals:
    /// To open that lab as a student, at the step with that id; empty if it cannot be read.
    void studentRequested(const QString &folder, const QString &task);

protected:
    void changeEvent(QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// Beside that of the platform: what other programs have.
    static inline const QKeySequence alsoRedo{Qt::CTRL | Qt::Key_Y};

    void makePanes();
    [[nodiscard]] QWidget *makeLanguageCorner();
    void wire();
    void wireProof();
    void fillMenus();
    void retranslate();
    void showState();
    void showWelcome();
    void showBroken();
    void reload();
    void tellRefused();
    [[nodiscard]] QStringList refused() const;
    bool mayDropRefused();
    bool mayExport();
    [[nodiscard]] QString askExportPath(const QString &title, const QString &name);
    void showVisit();
    void showDraft(const QDateTime &when);
    void offerUnsavedLab();
    void openPath(const QString &path);
    void report(const Error &error);
    void offerReload(const QString &names);
    void goTo(const Error &finding);
    bool saveInto(bool overwrite);
    bool mayDiscard(); ///< asks whether changes are to be saved

    QSettings &m_settings;
    AuthorDocument m_document;
    NoticeBar *m_notice = nullptr;
    Menu *m_stepMenu = nullptr; ///< above the list of steps, too
    QSplitter *m_splitter = nullptr;
    StepsPanel *m_steps = nullptr;
    QStackedWidget *m_centre = nullptr; ///< the tabs, or a file that must be mended first
    BrokenFile *m_broken = nullptr;
    QTabWidget *m_tabs = nullptr;
    SceneTab *m_sceneTab = nullptr;
    TextTab *m_textTab = nullptr;
    FindPanel *m_find = nullptr;
    ChecksTab *m_checksTab = nullptr;
    ProgramsTab *m_programsTab = nullptr;
    ProofTab *m_proofTab = nullptr;
    /// What the notice is about: the two in the middle have a button.
    std::optional<int> m_toldAt; ///< index of the undo stack when a replacement was told
    enum class Offer { None, Copy, Reload, Visit } m_offer = Offer::None;
    QString m_visited; ///< the finding whose run the scene shows
};

} // namespace cradle
