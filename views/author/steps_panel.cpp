// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/steps_panel.h"

#include "tasks/authoring/lab_edits.h"
#include "tasks/values/lab_values.h"
#include "tasks/values/put_values.h"
#include "views/author/findings_list.h"
#include "views/author/form_rows.h"
#include "views/author/rows_list.h"
#include "views/boxes.h"
#include "views/icons.h"
#include "views/on_change.h"
#include "views/theme.h"

#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

namespace cradle {

namespace {

/// What the rows are made of: an edit of a text or a program leaves it as it is.
QByteArrayList rowsOf(const LabFiles &files, const QString &language)
{
    QByteArrayList rows{language.toUtf8(), files.contents.value(QStringLiteral("lab.json"))};
    for (auto it = files.contents.cbegin(); it != files.contents.cend(); ++it) {
        if (it.key().contains(QLatin1String("/task.")))
            rows.append(it.value());
    }
    return rows;
}

} // namespace

StepsPanel::StepsPanel(AuthorDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
{
    makeLayout();
    keepTranslated(this, &StepsPanel::retranslate);
    onChange(this, {QEvent::PaletteChange}, [this] { markFindings(); });
    connect(&document, &AuthorDocument::changed, this, &StepsPanel::reloadIfNew);
    connect(&document, &AuthorDocument::stepChanged, this, &StepsPanel::showCurrent);
    connect(&document, &AuthorDocument::languageChanged, this, &StepsPanel::reload);
    connect(&document, &AuthorDocument::labRead, this, &StepsPanel::retranslate);
    connect(m_findings, &FindingsList::shown, this, &StepsPanel::markFindings);
    connect(m_findings, &FindingsList::chosen, this, &StepsPanel::findingChosen);
    connect(m_properties, &QToolButton::clicked, this, &StepsPanel::propertiesRequested);
    connect(m_list, &QListWidget::currentRowChanged, this, [this](int row) {
        if (!m_loading && row >= 0)
            m_document.setStep(m_list->item(row)->data(FolderRole).toString());
    });
    connect(m_list, &QListWidget::itemChanged, this, &StepsPanel::takeTitle);
    // Queued: the view is still at work with its editor.
    connect(m_list->itemDelegate(), &QAbstractItemDelegate::closeEditor, this, &StepsPanel::reload,
            Qt::QueuedConnection);
    // Queued for the same reason: a drag moves rows one by one.
    connect(m_list->model(), &QAbstractItemModel::rowsMoved, this, &StepsPanel::takeOrder,
            Qt::QueuedConnection);
    connect(m_list->model(), &QAbstractItemModel::rowsInserted, this, &StepsPanel::takeOrder,
            Qt::QueuedConnection);
    connect(m_list, &RowsList::addRequested, this, &StepsPanel::addStep);
    connect(m_list, &RowsList::duplicateRequested, this, &StepsPanel::duplicateStep);
    connect(m_list, &RowsList::renameRequested, this, &StepsPanel::renameStep);
    connect(m_list, &RowsList::removeRequested, this, &StepsPanel::removeStep);
    connect(m_list, &RowsList::moveRequested, this, &StepsPanel::move);
    reload();
    markFindings();
}

void StepsPanel::makeLayout()
{
    m_title = new QLabel(this);
    m_title->setWordWrap(true);
    setKind(m_title, "cardTitle");
    m_properties = makeIconButton(QStringLiteral("settings"), this);
    m_list = new RowsList(
        QStringLiteral("authorSteps"), this,
        {RowsList::Add, RowsList::Duplicate, RowsList::Remove, RowsList::Up, RowsList::Down});
    m_list->setDragDropMode(QAbstractItemView::InternalMove);
    m_list->setDefaultDropAction(Qt::MoveAction);
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_list->setTextElideMode(Qt::ElideRight);
    m_list->setIconSize(iconSquare(14));
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_list, &QWidget::customContextMenuRequested, this, [this](const QPoint &at) {
        if (m_list->itemAt(at))
            emit menuRequested(m_list->viewport()->mapToGlobal(at));
    });
    m_findings = new FindingsList(m_document, this);
    auto *lab = makeRow({12, 6, 6, 0}, -1, {{m_title, 1}, {m_properties, 0, Qt::AlignTop}});
    layOutColumn(this, {}, 0, {lab, {m_list->underHeading(), 1}, m_findings});
}

void StepsPanel::reloadIfNew()
{
    if (rowsOf(m_document.files(), m_document.language()) != m_shown)
        reload();
    else
        enableButtons();
}

void StepsPanel::reload()
{
    m_shown = rowsOf(m_document.files(), m_document.language());
    m_loading = true;
    m_list->clear();
    int number = 0;
    for (const QString &folder : m_document.steps()) {
        const Result<TaskForm> form = taskForm(m_document.files(), folder, m_document.language());
        const QString title = form ? form->title : folder;
        const auto shown = withNumbers(title, valuesOf(m_document.files(), folder, {}));
        auto *item = new QListWidgetItem(
            QStringLiteral("%1 · %2").arg(++number).arg(shown ? *shown : title));
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        item->setFlags(item->flags() & ~Qt::ItemIsDropEnabled);
        item->setData(FolderRole, folder);
        item->setData(TitleRole, title);
        item->setToolTip(QStringLiteral("%1: %2").arg(folder, title));
        m_list->addItem(item);
    }
    m_loading = false;
    markFindings();
    showCurrent();
    retranslate();
}

void StepsPanel::showCurrent()
{
    m_loading = true;
    m_list->setCurrentRow(static_cast<int>(m_document.steps().indexOf(m_document.step())));
    m_loading = false;
    enableButtons();
}

void StepsPanel::markFindings()
{
    // A row that changes takes its text back from who is typing there; reload() follows the end.
    if (m_list->viewport()->findChild<QLineEdit *>())
        return;
    m_loading = true;
    for (int i = 0; i < m_list->count(); ++i) {
        const bool found = m_findings->concernsStep(m_list->item(i)->data(FolderRole).toString());
        m_list->item(i)->setIcon(found ? icon(u"warning", IconTint::Warning) : QIcon());
    }
    m_loading = false;
}

void StepsPanel::enableButtons()
{
    const bool writable = !m_document.isReadOnly();
    m_list->enableButtons(writable, 1);
    m_list->setDragEnabled(writable);
    m_list->setEditTriggers(writable ? QAbstractItemView::DoubleClicked
                                           | QAbstractItemView::EditKeyPressed
                                     : QAbstractItemView::NoEditTriggers);
}

void StepsPanel::addStep()
{
    const QStringList steps = m_document.steps();
    const QString name = freeStepName(m_document.files(), QStringLiteral("step"));
    const auto at = static_cast<int>(steps.indexOf(m_document.step())) + 1;
    if (m_document.editStep(tr("Add a step"),
                            withStepAdded(m_document.files(), name, tr("New step"), at), name))
        renameStep();
}

void StepsPanel::duplicateStep()
{
    const QString name = freeStepName(m_document.files(), m_document.step());
    m_document.editStep(tr("Duplicate the step"),
                        withStepDuplicated(m_document.files(), m_document.step(), name), name);
}

void StepsPanel::removeStep()
{
    const QStringList steps = m_document.steps();
    const auto at = steps.indexOf(m_document.step());
    if (at < 0)
        return;
    const QString next = at + 1 < steps.size() ? steps[at + 1] : steps.value(at - 1);
    const QStringList foreign = foreignFiles(m_document.files(), m_document.step());
    const bool done = m_document.editStep(
        tr("Remove the step"), withStepRemoved(m_document.files(), m_document.step()), next);
    if (done && !foreign.isEmpty())
        emit said(
            tr("Files that the step did not use stay: %1").arg(foreign.join(QStringLiteral(", "))));
}

void StepsPanel::renameStep()
{
    if (QListWidgetItem *item = m_list->currentItem(); item && !m_document.isReadOnly()) {
        m_loading = true;
        item->setText(item->data(TitleRole).toString()); // without its number
        m_loading = false;
        m_list->setFocus();
        m_list->editItem(item);
    }
}

void StepsPanel::takeTitle(QListWidgetItem *item)
{
    if (m_loading)
        return;
    const QString step = item->data(FolderRole).toString();
    const QString number = QStringLiteral("%1 · ").arg(m_list->row(item) + 1);
    QString title = item->text().trimmed();
    if (title.startsWith(number))
        title.remove(0, number.size());
    if (title.isEmpty())
        return;
    // Queued: the list is filled anew by the edit, and its editor is still at work.
    QMetaObject::invokeMethod(
        this, [this, step, title] { setTitle(step, title); }, Qt::QueuedConnection);
}

void StepsPanel::setTitle(const QString &step, const QString &title)
{
    Result<TaskForm> form = taskForm(m_document.files(), step, m_document.language());
    if (!form)
        return;
    form->title = title;
    m_document.edit(tr("Rename the step"),
                    withTask(m_document.files(), step, *form, m_document.language()));
}

void StepsPanel::moveUp()
{
    move(m_list->currentRow(), m_list->currentRow() - 1);
}

void StepsPanel::moveDown()
{
    move(m_list->currentRow(), m_list->currentRow() + 1);
}

void StepsPanel::move(int from, int to)
{
    const QStringList steps = m_document.steps();
    if (from >= 0 && from < steps.size() && to >= 0 && to < steps.size())
        m_document.edit(tr("Move the step"), withStepMoved(m_document.files(), steps[from], to));
}

void StepsPanel::takeOrder()
{
    if (m_loading || m_list->count() != m_document.steps().size())
        return;
    const QStringList steps = m_document.steps();
    QStringList order;
    for (int i = 0; i < m_list->count(); ++i)
        order.append(m_list->item(i)->data(FolderRole).toString());
    if (order == steps)
        return;
    // One step was dragged: without it both orders are the same.
    for (const QString &step : steps) {
        QStringList rest = steps;
        QStringList dragged = order;
        rest.removeAll(step);
        dragged.removeAll(step);
        if (rest == dragged) {
            m_document.editStep(
                tr("Move the step"),
                withStepMoved(m_document.files(), step, static_cast<int>(order.indexOf(step))),
                step);
            return;
        }
    }
    reload();
}

void StepsPanel::retranslate()
{
    m_list->setTexts(tr("Steps of the lab"),
                     {{RowsList::Add, tr("Add a step")},
                      {RowsList::Duplicate, tr("Duplicate the step")},
                      {RowsList::Remove, tr("Remove the step")},
                      {RowsList::Up, tr("Move the step up")},
                      {RowsList::Down, tr("Move the step down")}},
                     tr("Steps · %1"));
    m_title->setText(m_document.title());
    nameButton(m_properties, tr("Title, version and id of the lab"));
}

} // namespace cradle
