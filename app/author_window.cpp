// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_window.h"

#include "app/lab_drop.h"
#include "app/notice_bar.h"
#include "tasks/authoring/lab_edits.h"
#include "views/author/broken_file.h"
#include "views/author/checks_tab.h"
#include "views/author/find_panel.h"
#include "views/author/language_box.h"
#include "views/author/programs_tab.h"
#include "views/author/proof_tab.h"
#include "views/author/scene_tab.h"
#include "views/author/steps_panel.h"
#include "views/author/text_tab.h"
#include "views/fitted_tabs.h"
#include "views/menu.h"

#include <QApplication>
#include <QFileInfo>
#include <QKeyEvent>
#include <QScreen>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QVBoxLayout>

namespace cradle {

namespace {

constexpr QSize firstSize{1440, 900}; ///< px
constexpr int stepsWidth = 270;       ///< px

} // namespace

AuthorWindow::AuthorWindow(QSettings &settings)
    : m_settings(settings)
{
    m_document.keepDraftsIn(QFileInfo(settings.fileName()).path() + QStringLiteral("/drafts"));
    makePanes();
    wire();
    wireProof();
    retranslate();
    resize(firstSize.boundedTo(screen()->availableGeometry().size() - QSize(0, 32)));
    restoreGeometry(settings.value(QStringLiteral("authorGeometry")).toByteArray());
    // Undo is the lab's wherever the keyboard is, not that of a field.
    qApp->installEventFilter(this);
}

AuthorWindow::~AuthorWindow()
{
    qApp->removeEventFilter(this);
    // The panes show the document: they go before it, and it tells this window nothing any more.
    m_document.disconnect(this);
    delete takeCentralWidget();
}

void AuthorWindow::makePanes()
{
    auto *centre = new QWidget(this);
    m_notice = new NoticeBar(centre);
    m_splitter = new QSplitter(Qt::Horizontal, centre);
    m_steps = new StepsPanel(m_document, m_splitter);
    m_centre = new QStackedWidget(m_splitter);
    m_tabs = new QTabWidget(m_centre);
    m_broken = new BrokenFile(m_document, m_centre);
    m_centre->addWidget(m_tabs);
    m_centre->addWidget(m_broken);
    m_tabs->setCornerWidget(makeLanguageCorner());
    m_sceneTab = new SceneTab(m_document, m_tabs);
    m_textTab = new TextTab(m_document, m_tabs);
    m_checksTab = new ChecksTab(m_document, m_tabs);
    m_programsTab = new ProgramsTab(m_document, m_tabs);
    m_proofTab = new ProofTab(m_document, m_tabs);
    for (QWidget *tab : {static_cast<QWidget *>(m_sceneTab), static_cast<QWidget *>(m_textTab),
                         static_cast<QWidget *>(m_checksTab), static_cast<QWidget *>(m_programsTab),
                         static_cast<QWidget *>(m_proofTab)})
        m_tabs->addTab(tab, QString());
    new FittedTabs(*m_tabs->tabBar());
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setStretchFactor(1, 1);
    m_splitter->setSizes({stepsWidth, firstSize.width() - stepsWidth});
    auto *column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_notice);
    column->addWidget(m_splitter, 1);
    m_find = new FindPanel(m_document, centre);
    column->addWidget(m_find);
    setCentralWidget(centre);
}

/// The language of all texts, beside the tabs.
QWidget *AuthorWindow::makeLanguageCorner()
{
    auto *corner = new QWidget(m_tabs);
    auto *row = new QHBoxLayout(corner);
    row->setContentsMargins(8, 2, 8, 2);
    row->addWidget(new LanguageBox(m_document, corner));
    return corner;
}

void AuthorWindow::wire()
{
    connect(&m_document, &AuthorDocument::stateChanged, this, &AuthorWindow::showState);
    connect(&m_document, &AuthorDocument::labRead, this, &AuthorWindow::showState);
    connect(&m_document, &AuthorDocument::opened, this, &AuthorWindow::showWelcome);
    connect(&m_document, &AuthorDocument::refused, this, &AuthorWindow::report);
    connect(&m_document, &AuthorDocument::draftTaken, this, &AuthorWindow::showDraft);
    connect(&m_document, &AuthorDocument::changedOutside, this, &AuthorWindow::offerReload);
    // Queued: what is not saved is asked about when the drag is over.
    connect(new LabDrop(this), &LabDrop::dropped, this, &AuthorWindow::openDropped,
            Qt::QueuedConnection);
    for (const auto signal : {&AuthorDocument::opened, &AuthorDocument::changed,
                              &AuthorDocument::stepChanged, &AuthorDocument::languageChanged})
        connect(&m_document, signal, this, &AuthorWindow::showBroken);
    connect(m_steps, &StepsPanel::said, this,
            [this](const QString &text) { m_notice->showNotice(text); });
    // It says that Undo brings back what was replaced, which holds until something is undone.
    connect(m_find, &FindPanel::said, this, [this](const QString &text) {
        m_notice->showNotice(text);
        m_toldAt = m_document.undoStack().index();
    });
    connect(&m_document.undoStack(), &QUndoStack::indexChanged, this, [this](int index) {
        if (m_toldAt && index < *m_toldAt) {
            m_toldAt.reset();
            m_notice->clearNotice();
        }
    });
    connect(m_find, &FindPanel::chosen, this, &AuthorWindow::goTo);
    connect(m_steps, &StepsPanel::findingChosen, this, &AuthorWindow::goTo);
    connect(m_steps, &StepsPanel::propertiesRequested, this, &AuthorWindow::editProperties);
    connect(m_steps, &StepsPanel::menuRequested, this,
            [this](const QPoint &place) { m_stepMenu->popup(place); });
    connect(m_textTab, &TextTab::figureRequested, this, &AuthorWindow::insertFigure);
    connect(m_notice, &NoticeBar::actionTriggered, this, [this] {
        if (m_offer == Offer::Copy) {
            saveAs();
        } else if (m_offer == Offer::Reload) {
            reload();
        }
    });
}

std::optional<Error> AuthorWindow::open(const QString &folder)
{
    auto error = m_document.open(folder);
    if (!error && m_document.hasUnsavedDraft())
        offerUnsavedLab();
    return error;
}

void AuthorWindow::showState()
{
    const QString name = m_document.title();
    const QString place = m_document.folder().isEmpty() ? tr("not saved yet")
                          : m_document.isReadOnly()     ? tr("read only")
                                                        : m_document.folder();
    setWindowTitle(QStringLiteral("%1[*] – %2").arg(name, place));
    setWindowModified(m_document.isModified());
}

/// The tabs, or in their place the file that keeps them from being filled.
void AuthorWindow::showBroken()
{
    m_centre->setCurrentIndex(m_broken->follow() ? 1 : 0);
}

void AuthorWindow::showWelcome()
{
    m_notice->clearNotice();
    m_offer = Offer::None;
    if (!m_document.isReadOnly())
        return;
    m_offer = Offer::Copy;
    m_notice->showNotice(tr("This lab ships with Cradle and stays as it is. Look around, or make a "
                            "copy of it and change that."),
                         tr("Copy to a folder…"));
}

void AuthorWindow::report(const Error &error)
{
    m_offer = m_document.isReadOnly() ? Offer::Copy : Offer::None;
    m_notice->showNotice(error.toString(),
                         m_document.isReadOnly() ? tr("Copy to a folder…") : QString());
}

void AuthorWindow::offerReload(const QString &names)
{
    m_offer = Offer::Reload;
    m_notice->showNotice(tr("Changed by another program: %1").arg(names), tr("Reload"));
}

void AuthorWindow::showTab(int tab)
{
    m_tabs->setCurrentIndex(tab);
    if (QWidget *page = m_tabs->currentWidget())
        page->setFocus();
}

void AuthorWindow::retranslate()
{
    const QString titles[] = {tr("Scene"), tr("Text"), tr("Checks"), tr("Programs"), tr("Proof")};
    for (int i = 0; i < m_tabs->count(); ++i)
        m_tabs->setTabText(i, titles[i]);
    m_tabs->setAccessibleName(tr("Parts of the step"));
    fillMenus();
    showState();
}

void AuthorWindow::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QMainWindow::changeEvent(event);
}

void AuthorWindow::closeEvent(QCloseEvent *event)
{
    if (!mayDiscard()) {
        event->ignore();
        return;
    }
    m_settings.setValue(QStringLiteral("authorGeometry"), saveGeometry());
    event->accept();
}

/// A field does not keep Undo and Redo for itself, so that they reach the menu.
bool AuthorWindow::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *widget = qobject_cast<const QWidget *>(watched);
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool isUndo = key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)
                            || alsoRedo.matches(key->keyCombination()) == QKeySequence::ExactMatch;
        if (isUndo && widget && widget->window() == this) {
            event->ignore();
            return true;
        }
    }
    return QMainWindow::eventFilter(watched, event);
}

} // namespace cradle
