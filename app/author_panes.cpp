// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_panes.h"

#include "app/notice_bar.h"
#include "views/author/author_document.h"
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

#include <QMainWindow>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QVBoxLayout>

namespace cradle {

namespace {

constexpr int stepsWidth = 270;   ///< px
constexpr int middleWidth = 1170; ///< px

/// The language of all texts, beside the tabs.
QWidget *languageCorner(AuthorDocument &document, QTabWidget *tabs)
{
    auto *corner = new QWidget(tabs);
    auto *row = new QHBoxLayout(corner);
    row->setContentsMargins(8, 2, 8, 2);
    row->addWidget(new LanguageBox(document, corner));
    return corner;
}

} // namespace

AuthorPanes::AuthorPanes(QMainWindow &mainWindow, AuthorDocument &document)
    : window(mainWindow)
    , m_document(document)
{
    auto *centre = new QWidget(&window);
    notice = new NoticeBar(centre);
    QWidget *middle = makeLeftAndMiddle(centre, document);
    find = new FindPanel(document, centre);
    auto *column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(notice);
    column->addWidget(middle, 1);
    column->addWidget(find);
    window.setCentralWidget(centre);
}

AuthorPanes::~AuthorPanes()
{
    delete window.takeCentralWidget();
}

QWidget *AuthorPanes::makeLeftAndMiddle(QWidget *centre, AuthorDocument &document)
{
    auto *splitter = new QSplitter(Qt::Horizontal, centre);
    steps = new StepsPanel(document, splitter);
    auto *middle = new QStackedWidget(splitter);
    tabs = new QTabWidget(middle);
    auto *broken = new BrokenFile(document, middle);
    middle->addWidget(tabs);
    middle->addWidget(broken);
    tabs->setCornerWidget(languageCorner(document, tabs));
    makeTabs(document);
    // The tabs, or in their place the file that keeps them from being filled.
    for (const auto signal : {&AuthorDocument::opened, &AuthorDocument::changed,
                              &AuthorDocument::stepChanged, &AuthorDocument::languageChanged})
        QObject::connect(&document, signal, broken,
                         [middle, broken] { middle->setCurrentIndex(broken->follow() ? 1 : 0); });
    splitter->setChildrenCollapsible(false);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({stepsWidth, middleWidth});
    return splitter;
}

void AuthorPanes::makeTabs(AuthorDocument &document)
{
    scene = new SceneTab(document, tabs);
    text = new TextTab(document, tabs);
    checks = new ChecksTab(document, tabs);
    programs = new ProgramsTab(document, tabs);
    proof = new ProofTab(document, tabs);
    for (QWidget *tab : {static_cast<QWidget *>(scene), static_cast<QWidget *>(text),
                         static_cast<QWidget *>(checks), static_cast<QWidget *>(programs),
                         static_cast<QWidget *>(proof)})
        tabs->addTab(tab, QString());
    new FittedTabs(*tabs->tabBar());
}

void AuthorPanes::retranslate()
{
    const QString titles[] = {tr("Scene"), tr("Text"), tr("Checks"), tr("Programs"), tr("Proof")};
    for (int i = 0; i < tabs->count(); ++i)
        tabs->setTabText(i, titles[i]);
    tabs->setAccessibleName(tr("Parts of the step"));
}

void AuthorPanes::showTab(int tab)
{
    tabs->setCurrentIndex(tab);
    if (QWidget *page = tabs->currentWidget())
        page->setFocus();
}

QStringList AuthorPanes::refused() const
{
    QStringList all = checks->refusedChecks() + text->refused() + programs->refusedRemarks();
    // What belongs to a step that is gone comes back with that alone.
    all.removeIf([steps = m_document.steps()](const QString &subject) {
        return subject.contains(QLatin1Char('/'))
               && !steps.contains(subject.section(QLatin1Char('/'), 0, 0));
    });
    return all + scene->refusedScenes();
}

} // namespace cradle
