// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_window.h"

#include "app/author_menu.h"
#include "app/notice_bar.h"
#include "tasks/authoring/lab_edits.h"
#include "views/author/figure.h"
#include "views/author/find_panel.h"
#include "views/author/lab_dialog.h"
#include "views/author/scene_tab.h"
#include "views/author/steps_panel.h"
#include "views/author/text_tab.h"
#include "views/menu.h"
#include "views/scene/scene_view.h"

#include <QApplication>
#include <QFileInfo>
#include <QKeyEvent>
#include <QScreen>
#include <QSettings>

namespace cradle {

namespace {

constexpr QSize firstSize{1440, 900}; ///< px

} // namespace

AuthorWindow::AuthorWindow(QSettings &settings)
    : m_settings(settings)
    , m_panes(*this, m_document)
    , m_notices(m_document, *m_panes.notice)
    , m_ways(m_document, m_panes, m_notices)
    , m_files(m_document, m_panes, m_notices, *this)
    , m_exports(m_document, m_notices, *this)
{
    m_document.keepDraftsIn(QFileInfo(settings.fileName()).path() + QStringLiteral("/drafts"));
    wire();
    retranslate();
    resize(firstSize.boundedTo(screen()->availableGeometry().size() - QSize(0, 32)));
    restoreGeometry(settings.value(QStringLiteral("authorGeometry")).toByteArray());
    // Undo is the lab's wherever the keyboard is, not that of a field.
    qApp->installEventFilter(this);
}

AuthorWindow::~AuthorWindow()
{
    qApp->removeEventFilter(this);
    m_document.disconnect(this); // there is no title to show any more
}

void AuthorWindow::wire()
{
    connect(&m_document, &AuthorDocument::stateChanged, this, &AuthorWindow::showState);
    connect(&m_document, &AuthorDocument::labRead, this, &AuthorWindow::showState);
    connect(m_panes.steps, &StepsPanel::said, &m_notices, &AuthorNotices::say);
    connect(m_panes.find, &FindPanel::said, &m_notices, &AuthorNotices::sayUndoable);
    connect(m_panes.steps, &StepsPanel::propertiesRequested, this, &AuthorWindow::editProperties);
    connect(&m_ways, &AuthorWays::propertiesRequested, this, &AuthorWindow::editProperties);
    connect(m_panes.steps, &StepsPanel::menuRequested, this,
            [this](const QPoint &place) { m_stepMenu->popup(place); });
    connect(m_panes.text, &TextTab::figureRequested, this, &AuthorWindow::insertFigure);
}

void AuthorWindow::openAsStudent()
{
    if (m_document.isModified() && !m_files.save())
        return;
    m_document.readNow();
    const Task *task = m_document.task();
    emit studentRequested(m_document.folder(), task ? task->id : QString());
}

void AuthorWindow::editProperties()
{
    // A lab.json that cannot be read has no fields; the finding about it says why.
    if (const Result<LabForm> lab = labForm(m_document.files()); !lab)
        m_notices.report(lab.error());
    else
        LabDialog(m_document, LabDialog::Purpose::Edit, this).exec();
}

void AuthorWindow::insertFigure()
{
    const QString step = m_document.step();
    if (step.isEmpty())
        return;
    const LabFiles &files = m_document.files();
    QString name;
    for (int number = 1; name.isEmpty() || files.contents.contains(step + QLatin1Char('/') + name);
         ++number)
        name = QStringLiteral("figure-%1.svg").arg(number);
    const QByteArray svg = figureOf(m_panes.scene->scene());
    if (!m_document.edit(tr("Insert a figure"),
                         withFile(files, step + QLatin1Char('/') + name, svg)))
        return;
    m_panes.showTab(Text);
    m_panes.text->insertFigure(
        name, tr("The scene at %1 s").arg(m_panes.scene->simulation().time(), 0, 'f', 2));
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

void AuthorWindow::retranslate()
{
    m_panes.retranslate();
    m_stepMenu = fillMenuBar(*this);
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
    if (!m_files.mayDiscard()) {
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
