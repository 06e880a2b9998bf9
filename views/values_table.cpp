// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/values_table.h"

#include "views/charts/deviation_text.h"
#include "views/charts/frame_throttle.h"
#include "views/charts/hit_columns.h"
#include "views/charts/hits_model.h"
#include "views/charts/number_table.h"
#include "views/charts/number_text.h"
#include "views/charts/sentence_label.h"
#include "views/charts/table_text.h"
#include "views/charts/values_model.h"
#include "views/theme.h"

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QTabWidget>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr int titleInterval = 250; ///< ms from one count of hits to the next, while it runs
constexpr int cellPad = 8;         ///< px left and right of a number together
constexpr int headerSpare = 6;     ///< px that a title may lack of its usual room
constexpr int mostSpare = 16;      ///< px between two columns where there is room
constexpr int massPlaces = 7;      ///< characters of a mass
constexpr int unfitted = -1;       ///< not even the titles
constexpr int fittedRows = 64;     ///< the columns of the hits fit these many of them

} // namespace

ValuesPane::ValuesPane(const Simulation &simulation, QWidget *parent)
    : QWidget(parent)
    , m_simulation(simulation)
    , m_valuesModel(new ValuesModel(simulation, this))
    , m_hitsModel(new HitsModel(simulation, this))
    , m_tabs(new QTabWidget)
    , m_values(makeNumberTable(m_valuesModel, ValuesModel::unitRole))
    , m_hits(makeNumberTable(m_hitsModel, HitsModel::unitRole))
    , m_sentence(new SentenceLabel)
    , m_exact(new SentenceLabel)
    , m_noHits(new QLabel(m_hits->viewport()))
    , m_copyAction(new QAction(this))
    , m_copyAllAction(new QAction(this))
    , m_throttle(new FrameThrottle(simulation, this))
{
    setKind(m_sentence, "muted");
    setKind(m_exact, "muted");
    m_noHits->setWordWrap(true);
    m_noHits->setAlignment(Qt::AlignCenter);
    setKind(m_noHits, "muted");
    (new QVBoxLayout(m_hits->viewport()))->addWidget(m_noHits);
    auto *valuesTab = new QWidget;
    valuesTab->installEventFilter(this);
    auto *column = new QVBoxLayout(valuesTab);
    column->setContentsMargins({});
    column->setSpacing(0);
    column->addWidget(m_values, 1);
    column->addWidget(m_sentence);
    column->addWidget(m_exact);
    column->addStretch();
    m_tabs->addTab(valuesTab, QString());
    m_tabs->addTab(m_hits, QString());
    m_tabs->setDocumentMode(true);
    setKind(m_tabs->tabBar(), "narrow");
    auto *whole = new QVBoxLayout(this);
    whole->setContentsMargins({});
    whole->addWidget(m_tabs);

    m_hits->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_copyAction->setShortcut(QKeySequence::Copy);
    m_copyAllAction->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_C);
    for (QAction *action : {m_copyAction, m_copyAllAction})
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    for (QTableView *table : {m_values, m_hits}) {
        table->addActions({m_copyAction, m_copyAllAction});
        table->setContextMenuPolicy(Qt::ActionsContextMenu);
    }
    connect(m_copyAction, &QAction::triggered, this, &ValuesPane::copySelection);
    connect(m_copyAllAction, &QAction::triggered, this, &ValuesPane::copyAll);
    connect(m_hits, &QTableView::clicked, this, &ValuesPane::seekHit);
    connect(m_hits, &QTableView::activated, this, &ValuesPane::seekHit);
    connect(m_tabs, &QTabWidget::currentChanged, this, &ValuesPane::showTab);
    connect(m_throttle, &FrameThrottle::due, this, &ValuesPane::refresh);
    connect(m_valuesModel, &QAbstractItemModel::modelReset, this, &ValuesPane::fitValues);
    connect(m_hitsModel, &QAbstractItemModel::modelReset, this,
            [this] { m_fittedHits = unfitted; });
    fitValues();
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

QTableView *ValuesPane::shownTable() const
{
    return m_tabs->currentIndex() == 0 ? m_values : m_hits;
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
        refreshValues();
    else if (m_tabs->currentIndex() == 1)
        refreshHits();
}

void ValuesPane::refreshValues()
{
    const int first = std::max(0, m_values->rowAt(0));
    const int below = m_values->rowAt(m_values->viewport()->height() - 1);
    m_valuesModel->refresh(first, below >= 0 ? below : m_valuesModel->rowCount() - 1);
    const QString exact = describeDeviation(m_simulation);
    m_exact->setSentence(exact);
    m_exact->setVisible(!exact.isEmpty());
    m_sentence->setSentence(hitSentence());
    fitSentences();
}

QString ValuesPane::hitSentence() const
{
    const Recording &recording = m_simulation.recording();
    const qint64 shown = m_simulation.current();
    const auto hit = lastHit(recording.encounters(), recording.step(shown));
    if (!hit)
        return tr("No hit so far.");
    const qint64 number = recording.droppedEncounters() + static_cast<qint64>(*hit) + 1;
    const Encounter &contact = recording.encounters()[*hit];
    // What has not happened yet at the moment shown is not told.
    const double until = std::min(contact.endTime, recording.time(shown));
    return contact.lasts() && recording.step(shown) > contact.step
               ? describeEncounter(number, recording.hitOf(contact), until)
               : describeHit(number, recording.hitOf(contact), recording.circles(shown));
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

void ValuesPane::fitValues()
{
    // Room for the usual numbers, so that widths rest while numbers change.
    const double figure = QFontMetricsF(columnFont()).horizontalAdvance(u'0');
    const auto widthOf = [&](int column) {
        const int places = column <= ValuesModel::Speed  ? ValuesModel::narrowPlaces
                           : column == ValuesModel::Mass ? massPlaces
                                                         : ValuesModel::widePlaces;
        const int title = m_values->horizontalHeader()->sectionSizeHint(column) - headerSpare;
        return std::max(title, static_cast<int>(std::ceil(places * figure)) + cellPad);
    };
    const int columns = m_valuesModel->columnCount();
    int needed = m_values->verticalHeader()->sizeHint().width() + cellPad;
    for (int column = 0; column < columns; ++column)
        needed += widthOf(column);
    // What is left over keeps them apart.
    const int spare = std::clamp((width() - needed) / columns, 0, mostSpare);
    for (int column = 0; column < columns; ++column)
        m_values->setColumnWidth(column, widthOf(column) + spare);
    fitHeights();
}

void ValuesPane::fitColumns()
{
    fitValues();
    m_fittedHits = unfitted;
    m_throttle->request();
}

void ValuesPane::fitHeights()
{
    const int bar = m_values->horizontalScrollBar()->sizeHint().height();
    // The viewport has not its width yet when the pane is resized.
    const int needed =
        m_values->verticalHeader()->sizeHint().width() + m_values->horizontalHeader()->length();
    const bool scrolls = needed > width();
    const int rows = m_values->verticalHeader()->length();
    const int header = m_values->horizontalHeader()->sizeHint().height();
    m_values->setMaximumHeight(header + rows + (scrolls ? bar : 0));
    m_values->setMinimumHeight(
        std::min(m_values->maximumHeight(), header + scaledByText(numberRowHeight)));
    fitSentences();
}

void ValuesPane::fitSentences()
{
    const QSize tab = m_sentence->parentWidget()->size();
    const int room = tab.height() - m_values->maximumHeight();
    m_exact->fitInto({tab.width(), room});
    m_sentence->fitInto({tab.width(), room - (m_exact->isHidden() ? 0 : m_exact->height())});
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
        setNumberRows(m_values);
        setNumberRows(m_hits);
        // The headers have the new font a little later.
        QMetaObject::invokeMethod(this, &ValuesPane::fitColumns, Qt::QueuedConnection);
        [[fallthrough]];
    case QEvent::PaletteChange:
        m_valuesModel->reload();
        m_hitsModel->reload();
        break;
    default:
        return;
    }
    m_throttle->request();
}

bool ValuesPane::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize && watched == m_sentence->parentWidget())
        fitValues();
    return QWidget::eventFilter(watched, event);
}

void ValuesPane::retranslate()
{
    m_tabs->setTabText(0, tr("Values"));
    m_tabs->setTabText(1, tr("Hits"));
    m_tabs->setAccessibleName(tr("Values and hits"));
    m_values->setAccessibleName(tr("Values of the circles at the moment shown"));
    m_hits->setAccessibleName(tr("Hits; Enter shows the moment"));
    m_sentence->setAccessibleName(tr("Last hit"));
    m_exact->setAccessibleName(tr("Distance from the exact motion"));
    m_noHits->setText(tr("No hits yet: press Run or Next hit"));
    m_copyAction->setText(tr("Copy"));
    m_copyAllAction->setText(tr("Copy all"));
    m_throttle->request();
}

} // namespace cradle
