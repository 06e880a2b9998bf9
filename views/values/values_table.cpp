// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/values/values_table.h"

#include "views/fitted_tabs.h"
#include "views/frame_throttle.h"
#include "views/menu.h"
#include "views/theme.h"
#include "views/values/hits_model.h"
#include "views/values/number_table.h"
#include "views/values/table_text.h"
#include "views/values/values_model.h"
#include "views/values/values_tab.h"

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QLabel>
#include <QTabWidget>
#include <QTableView>
#include <QVBoxLayout>

namespace cradle {

namespace {

constexpr int titleInterval = 250; ///< ms from one count of hits to the next, while it runs
constexpr int unfitted = -1;       ///< not even the titles
constexpr int fittedRows = 64;     ///< the columns of the hits fit these many of them

} // namespace

ValuesPane::ValuesPane(const Simulation &simulation, QWidget *parent)
    : QWidget(parent)
    , m_simulation(simulation)
    , m_hitsModel(new HitsModel(simulation, this))
    , m_tabs(new QTabWidget)
    , m_values(new ValuesTab(simulation))
    , m_hits(makeNumberTable(m_hitsModel, HitsModel::unitRole))
    , m_noHits(new QLabel(m_hits->viewport()))
    , m_copyAction(new QAction(this))
    , m_copyAllAction(new QAction(this))
    , m_throttle(new FrameThrottle(simulation, this))
{
    m_noHits->setWordWrap(true);
    m_noHits->setAlignment(Qt::AlignCenter);
    setKind(m_noHits, "muted");
    (new QVBoxLayout(m_hits->viewport()))->addWidget(m_noHits);
    m_tabs->addTab(m_values, QString());
    m_tabs->addTab(m_hits, QString());
    m_tabs->setDocumentMode(true);
    new FittedTabs(*m_tabs->tabBar(), FittedTabs::Distance::Narrow);
    auto *whole = new QVBoxLayout(this);
    whole->setContentsMargins({});
    whole->addWidget(m_tabs);

    m_hits->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_copyAction->setShortcut(QKeySequence::Copy);
    m_copyAllAction->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_C);
    for (QAction *action : {m_copyAction, m_copyAllAction})
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    for (QTableView *table : {m_values->table(), m_hits}) {
        table->addActions({m_copyAction, m_copyAllAction});
        offerActions(*table);
    }
    connect(m_copyAction, &QAction::triggered, this, &ValuesPane::copySelection);
    connect(m_copyAllAction, &QAction::triggered, this, &ValuesPane::copyAll);
    connect(m_hits, &QTableView::clicked, this, &ValuesPane::seekHit);
    connect(m_hits, &QTableView::activated, this, &ValuesPane::seekHit);
    connect(m_tabs, &QTabWidget::currentChanged, this, &ValuesPane::showTab);
    connect(m_throttle, &FrameThrottle::due, this, &ValuesPane::refresh);
    connect(m_hitsModel, &QAbstractItemModel::modelReset, this,
            [this] { m_fittedHits = unfitted; });
    retranslate();
}

void ValuesPane::addTab(QWidget *widget, const QString &title)
{
    m_tabs->addTab(widget, title);
    m_added.push_back({widget, title});
    connect(widget, &QWidget::windowTitleChanged, this,
            [this, widget](const QString &changed) { setTabTitle(widget, changed); });
}

void ValuesPane::setTabTitle(QWidget *widget, const QString &title)
{
    for (Tab &tab : m_added) {
        if (tab.widget == widget) {
            tab.title = title;
            showTitle(tab);
        }
    }
}

void ValuesPane::markTab(QWidget *widget, bool marked)
{
    for (Tab &tab : m_added) {
        if (tab.widget == widget) {
            tab.marked = marked && m_tabs->currentWidget() != widget;
            showTitle(tab);
        }
    }
}

void ValuesPane::showTitle(const Tab &tab)
{
    const int index = m_tabs->indexOf(tab.widget);
    m_tabs->setTabText(index,
                       tab.marked ? tr("%1 •", "a tab with news").arg(tab.title) : tab.title);
}

void ValuesPane::showTab(int index)
{
    markTab(m_tabs->widget(index), false);
    m_throttle->request();
}

QString ValuesPane::hitSentence() const
{
    return m_values->hitSentence();
}

QTableView *ValuesPane::shownTable() const
{
    return m_tabs->currentIndex() == 0 ? m_values->table() : m_hits;
}

void ValuesPane::refresh()
{
    m_hitsModel->update();
    const qint64 count = m_hitsModel->hitCount();
    const QString title = count > 0 ? tr("Hits %1").arg(count) : tr("Hits");
    // A new text lays all the tabs out again, and the window with them.
    const bool rests = m_simulation.isRunning() && m_sinceTitle.isValid()
                       && m_sinceTitle.elapsed() < titleInterval;
    if (m_tabs->tabText(1) != title && !rests) {
        m_tabs->setTabText(1, title);
        m_sinceTitle.start();
    }
    if (m_tabs->currentIndex() == 0)
        m_values->refresh();
    else if (m_tabs->currentIndex() == 1)
        refreshHits();
}

void ValuesPane::refreshHits()
{
    const int rows = m_hitsModel->rowCount();
    m_noHits->setVisible(rows == 0);
    if (rows > m_fittedHits && m_fittedHits < fittedRows) {
        m_fittedHits = rows;
        m_hits->resizeColumnsToContents();
    }
    const qint64 step = m_simulation.recording().step(m_simulation.current());
    const auto row = m_hitsModel->rowAt(step);
    if (row && *row != m_hits->currentIndex().row())
        m_hits->setCurrentIndex(m_hitsModel->index(*row, 0));
    else if (!row)
        m_hits->clearSelection();
}

void ValuesPane::fitColumns()
{
    m_values->fit();
    m_fittedHits = unfitted;
    m_throttle->request();
}

void ValuesPane::copySelection()
{
    const QTableView *table = shownTable();
    const QString text = textOfCells(*table->model(), table->selectionModel()->selectedIndexes());
    if (!text.isEmpty())
        QGuiApplication::clipboard()->setText(text);
}

void ValuesPane::copyAll()
{
    QGuiApplication::clipboard()->setText(
        textOfTable(*shownTable()->model(), ValuesModel::unitRole, tr("number")));
}

void ValuesPane::seekHit(const QModelIndex &index)
{
    const Recording &recording = m_simulation.recording();
    const qint64 step = m_hitsModel->hit(index.row()).step;
    emit seekRequested(recording.first() + step - recording.step(recording.first()));
}

void ValuesPane::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    switch (event->type()) {
    case QEvent::LanguageChange:
        m_fittedHits = unfitted;
        retranslate();
        break;
    case QEvent::FontChange:
        setNumberRows(m_values->table());
        setNumberRows(m_hits);
        // The headers have the new font a little later.
        QMetaObject::invokeMethod(this, &ValuesPane::fitColumns, Qt::QueuedConnection);
        [[fallthrough]];
    case QEvent::PaletteChange:
        m_values->reload();
        m_hitsModel->reload();
        break;
    default:
        return;
    }
    m_throttle->request();
}

void ValuesPane::retranslate()
{
    m_tabs->setTabText(0, tr("Values"));
    m_tabs->setTabText(1, tr("Hits"));
    m_values->retranslate();
    m_tabs->setAccessibleName(tr("Values and hits"));
    m_hits->setAccessibleName(tr("Hits; Enter shows the moment"));
    m_noHits->setText(tr("No hits yet: press Run or Next hit"));
    m_copyAction->setText(tr("Copy"));
    m_copyAllAction->setText(tr("Copy all"));
    m_throttle->request();
}

} // namespace cradle
