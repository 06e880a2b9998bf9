// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/console_view.h"

#include "views/console_delegate.h"
#include "views/console_model.h"
#include "views/error_line.h"
#include "views/frame_throttle.h"
#include "views/menu.h"
#include "views/theme.h"

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QLabel>
#include <QListView>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>
#include <numeric>

namespace cradle {

namespace {

QListView *makeList(QAbstractItemModel *model, QAbstractItemDelegate *delegate)
{
    auto *list = new QListView;
    list->setModel(model);
    list->setItemDelegate(delegate);
    list->setUniformItemSizes(true);
    list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    list->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    list->setVerticalScrollMode(QAbstractItemView::ScrollPerItem);
    list->setTabKeyNavigation(false);
    offerActions(*list);
    return list;
}

} // namespace

ConsoleView::ConsoleView(const Simulation &simulation, QWidget *parent)
    : QWidget(parent)
    , m_simulation(simulation)
    , m_model(new ConsoleModel(simulation, this))
    , m_delegate(new ConsoleDelegate(this))
    , m_list(makeList(m_model, m_delegate))
    , m_empty(new QLabel(m_list->viewport()))
    , m_error(new ErrorLine)
    , m_seekAction(new QAction(this))
    , m_copyAction(new QAction(this))
    , m_copyAllAction(new QAction(this))
    , m_clearAction(new QAction(this))
    , m_throttle(new FrameThrottle(simulation, this))
{
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignCenter);
    setKind(m_empty, "muted");
    (new QVBoxLayout(m_list->viewport()))->addWidget(m_empty);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 4, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_list, 1);
    column->addWidget(m_error);

    m_copyAction->setShortcut(QKeySequence::Copy);
    m_copyAllAction->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_C);
    m_seekAction->setShortcut(Qt::Key_Return);
    for (QAction *action : {m_seekAction, m_copyAction, m_copyAllAction, m_clearAction}) {
        action->setShortcutContext(Qt::WidgetShortcut);
        m_list->addAction(action);
    }
    connect(m_copyAction, &QAction::triggered, this, &ConsoleView::copySelection);
    connect(m_copyAllAction, &QAction::triggered, this, &ConsoleView::copyAll);
    connect(m_clearAction, &QAction::triggered, this, &ConsoleView::clear);
    // Not activated(): in some desktops that is a single click, which selects.
    connect(m_list, &QListView::doubleClicked, this, &ConsoleView::seekLine);
    connect(m_seekAction, &QAction::triggered, this, [this] { seekLine(m_list->currentIndex()); });
    connect(m_error, &ErrorLine::clicked, this, &ConsoleView::activateError);
    m_list->viewport()->installEventFilter(this);
    const QScrollBar *bar = m_list->verticalScrollBar();
    connect(bar, &QScrollBar::valueChanged, this, [this, bar](int value) {
        if (!m_isUpdating)
            m_follows = value == bar->maximum();
    });
    // Rows are moved on the screen as a picture, and the gutter must not move aside with them.
    connect(m_list->horizontalScrollBar(), &QScrollBar::valueChanged, m_list->viewport(),
            qOverload<>(&QWidget::update));

    connect(m_throttle, &FrameThrottle::due, this, &ConsoleView::refresh);
    connect(&simulation, &Simulation::restarted, this, &ConsoleView::begin);
    connect(&simulation, &Simulation::programFailed, this, [this] {
        showError();
        emit errorShown(true);
    });
    retranslate();
    showError();
    refresh();
}

void ConsoleView::begin()
{
    const QScopedValueRollback updating(m_isUpdating, true);
    const bool hadError = !m_error->isHidden();
    m_follows = true;
    m_model->reload();
    showError();
    if (hadError && m_error->isHidden())
        emit errorShown(false);
}

void ConsoleView::refresh()
{
    const QScopedValueRollback updating(m_isUpdating, true);
    QScrollBar *bar = m_list->verticalScrollBar();
    const int gone = m_model->update();
    if (m_delegate->fit(m_model->lastStep(), m_model->width()))
        m_list->doItemsLayout();
    const qint64 step = m_simulation.recording().step(m_simulation.current());
    const qint64 marked = m_simulation.isRunning() || step == 0 ? -1 : step;
    if (marked != m_delegate->marked()) {
        m_delegate->setMarked(marked);
        m_list->viewport()->update();
    }
    if (m_follows)
        followMoment();
    else if (gone > 0) // what the student reads stays where it is
        bar->setValue(bar->value() - gone);
    m_empty->setVisible(m_model->rowCount() == 0 && m_error->isHidden());
}

void ConsoleView::followMoment()
{
    const qint64 shown = m_simulation.current();
    const Recording &recording = m_simulation.recording();
    if (shown == recording.last())
        m_list->scrollToBottom();
    else if (const int row = m_model->lastRowAt(recording.step(shown)); row >= 0)
        m_list->scrollTo(m_model->index(row), QAbstractItemView::PositionAtBottom);
    else
        m_list->scrollToTop();
}

void ConsoleView::showError()
{
    const auto &error = m_simulation.programError();
    if (error)
        m_error->setError(*error);
    m_error->setVisible(error.has_value());
    m_throttle->request();
}

QString ConsoleView::errorText() const
{
    const auto &error = m_simulation.programError();
    return error ? ErrorLine::describe(*error) : QString();
}

void ConsoleView::activateError()
{
    if (const auto &error = m_simulation.programError(); error && error->line > 0)
        emit lineActivated(error->line);
}

void ConsoleView::seekLine(const QModelIndex &index)
{
    if (!index.isValid())
        return;
    const Recording &recording = m_simulation.recording();
    const qint64 step = index.data(ConsoleModel::stepRole).toLongLong();
    emit seekRequested(recording.first() + step - recording.step(recording.first()));
}

void ConsoleView::clear()
{
    const QScopedValueRollback updating(m_isUpdating, true);
    m_follows = true;
    m_model->clear();
    m_throttle->request();
}

void ConsoleView::copySelection()
{
    QList<int> rows;
    for (const QModelIndex &index : m_list->selectionModel()->selectedIndexes())
        rows.append(index.row());
    std::sort(rows.begin(), rows.end());
    if (!rows.isEmpty())
        QGuiApplication::clipboard()->setText(m_model->text(rows));
}

void ConsoleView::copyAll()
{
    QList<int> rows(m_model->rowCount());
    std::iota(rows.begin(), rows.end(), 0);
    QString text = m_model->text(rows);
    if (const QString error = errorText(); !error.isEmpty())
        text += error + QLatin1Char('\n');
    QGuiApplication::clipboard()->setText(text);
}

bool ConsoleView::eventFilter(QObject *watched, QEvent *event)
{
    // The list has not its new range yet.
    if (event->type() == QEvent::Resize)
        QMetaObject::invokeMethod(m_throttle, &FrameThrottle::request, Qt::QueuedConnection);
    return QWidget::eventFilter(watched, event);
}

void ConsoleView::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        showError();
    } else if (event->type() == QEvent::FontChange || event->type() == QEvent::PaletteChange) {
        m_list->doItemsLayout();
        m_throttle->request();
    }
}

void ConsoleView::retranslate()
{
    setWindowTitle(tr("Console"));
    m_empty->setText(tr("print(…) in your program writes here"));
    m_list->setAccessibleName(tr("Lines that the program has printed"));
    m_seekAction->setText(tr("Show the moment"));
    m_copyAction->setText(tr("Copy"));
    m_copyAllAction->setText(tr("Copy all"));
    m_clearAction->setText(tr("Clear"));
}

} // namespace cradle
