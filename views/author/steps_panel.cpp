// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/steps_panel.h"

#include "tasks/authoring/lab_edits.h"
#include "views/author/tool_buttons.h"
#include "views/icons.h"
#include "views/theme.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QToolButton>

namespace cradle {

namespace {

constexpr int folderRole = Qt::UserRole;
constexpr int titleRole = Qt::UserRole + 1;
constexpr int findingsHeight = 150; ///< px

/// The path of \p finding below the lab's folder.
QString pathIn(const QString &folder, const Error &finding)
{
    if (folder.isEmpty())
        return finding.file.startsWith(QLatin1Char('/')) ? finding.file.mid(1) : finding.file;
    if (!finding.file.startsWith(folder + QLatin1Char('/')))
        return finding.file;
    return finding.file.mid(folder.size() + 1);
}

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
    retranslate();
    connect(&document, &AuthorDocument::changed, this, &StepsPanel::reloadIfNew);
    connect(&document, &AuthorDocument::stepChanged, this, &StepsPanel::showCurrent);
    connect(&document, &AuthorDocument::languageChanged, this, &StepsPanel::reload);
    connect(&document, &AuthorDocument::labRead, this, &StepsPanel::showFindings);
    connect(m_list, &QListWidget::currentRowChanged, this, [this](int row) {
        if (!m_loading && row >= 0)
            m_document.setStep(m_list->item(row)->data(folderRole).toString());
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
    const auto chosen = [this](QListWidgetItem *item) {
        emit findingChosen(m_errors[static_cast<std::size_t>(m_findings->row(item))]);
    };
    connect(m_findings, &QListWidget::itemClicked, this, chosen);
    connect(m_findings, &QListWidget::itemActivated, this, chosen);
    const std::pair<QToolButton *, void (StepsPanel::*)()> buttons[] = {
        {m_add, &StepsPanel::addStep},
        {m_duplicate, &StepsPanel::duplicateStep},
        {m_remove, &StepsPanel::removeStep},
        {m_up, &StepsPanel::moveUp},
        {m_down, &StepsPanel::moveDown}};
    for (const auto &[button, slot] : buttons)
        connect(button, &QToolButton::clicked, this, slot);
    reload();
    showFindings();
}

void StepsPanel::makeLayout()
{
    const auto heading = [this] {
        auto *label = new QLabel(this);
        label->setFont(headingFont());
        setKind(label, "heading");
        return label;
    };
    m_heading = heading();
    m_findingsHeading = heading();
    m_findingsHeading->setContentsMargins(12, 8, 12, 4);
    m_list = new QListWidget(this);
    m_list->setObjectName(QStringLiteral("authorSteps"));
    m_list->setFrameShape(QFrame::NoFrame);
    setKind(m_list, "rows");
    m_list->setDragDropMode(QAbstractItemView::InternalMove);
    m_list->setDefaultDropAction(Qt::MoveAction);
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_list->setTextElideMode(Qt::ElideRight);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->installEventFilter(this);
    m_findings = new QListWidget(this);
    m_findings->setObjectName(QStringLiteral("authorFindings"));
    m_findings->setFrameShape(QFrame::NoFrame);
    setKind(m_findings, "rows");
    m_findings->setWordWrap(true);
    m_findings->setMaximumHeight(findingsHeight);
    m_findings->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *row = new QHBoxLayout;
    row->setContentsMargins(12, 6, 6, 4);
    row->setSpacing(0);
    row->addWidget(m_heading, 1);
    m_add = makeIconButton(QStringLiteral("add"), this);
    m_duplicate = makeIconButton(QStringLiteral("duplicate"), this);
    m_remove = makeIconButton(QStringLiteral("remove"), this);
    m_up = makeIconButton(QStringLiteral("up"), this);
    m_down = makeIconButton(QStringLiteral("down"), this);
    for (QToolButton *button : {m_up, m_down, m_add, m_duplicate, m_remove})
        row->addWidget(button);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(row);
    column->addWidget(m_list, 1);
    column->addWidget(m_findingsHeading);
    column->addWidget(m_findings);
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
        auto *item = new QListWidgetItem(QStringLiteral("%1 · %2").arg(++number).arg(title));
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        item->setFlags(item->flags() & ~Qt::ItemIsDropEnabled);
        item->setData(folderRole, folder);
        item->setData(titleRole, title);
        item->setToolTip(QStringLiteral("%1: %2").arg(folder, title));
        m_list->addItem(item);
    }
    m_loading = false;
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

void StepsPanel::showFindings()
{
    m_errors = m_document.unread();
    m_errors.insert(m_errors.end(), m_document.lab().findings.begin(),
                    m_document.lab().findings.end());
    m_findings->clear();
    for (Error finding : m_errors) {
        finding.file = pathIn(m_document.folder(), finding);
        auto *item = new QListWidgetItem(finding.toString());
        item->setForeground(theme().warning);
        item->setToolTip(finding.toString());
        m_findings->addItem(item);
    }
    m_findings->setVisible(!m_errors.empty());
    for (int i = 0; i < m_list->count(); ++i) {
        const QString start = m_list->item(i)->data(folderRole).toString() + QLatin1Char('/');
        const bool hasFinding = std::any_of(m_errors.begin(), m_errors.end(), [&](const Error &e) {
            return pathIn(m_document.folder(), e).startsWith(start);
        });
        m_loading = true;
        m_list->item(i)->setIcon(hasFinding ? icon(u"warning", IconTint::Warning) : QIcon());
        m_loading = false;
    }
    retranslate();
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
    m_document.editStep(tr("Remove the step"),
                        withStepRemoved(m_document.files(), m_document.step()), next);
}

void StepsPanel::renameStep()
{
    if (QListWidgetItem *item = m_list->currentItem(); item && !m_document.isReadOnly()) {
        m_loading = true;
        item->setText(item->data(titleRole).toString()); // without its number
        m_loading = false;
        m_list->setFocus();
        m_list->editItem(item);
    }
}

void StepsPanel::takeTitle(QListWidgetItem *item)
{
    if (m_loading)
        return;
    const QString step = item->data(folderRole).toString();
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
    move(-1);
}

void StepsPanel::moveDown()
{
    move(1);
}

void StepsPanel::move(int by)
{
    const QStringList steps = m_document.steps();
    const auto from = static_cast<int>(steps.indexOf(m_document.step()));
    if (from < 0 || from + by < 0 || from + by >= steps.size())
        return;
    m_document.edit(tr("Move the step"),
                    withStepMoved(m_document.files(), m_document.step(), from + by));
}

void StepsPanel::takeOrder()
{
    if (m_loading || m_list->count() != m_document.steps().size())
        return;
    const QStringList steps = m_document.steps();
    QStringList order;
    for (int i = 0; i < m_list->count(); ++i)
        order.append(m_list->item(i)->data(folderRole).toString());
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

void StepsPanel::enableButtons()
{
    const auto at = m_document.steps().indexOf(m_document.step());
    const bool writable = !m_document.isReadOnly();
    m_add->setEnabled(writable);
    m_duplicate->setEnabled(writable && at >= 0);
    m_remove->setEnabled(writable && at >= 0 && m_document.steps().size() > 1);
    m_up->setEnabled(writable && at > 0);
    m_down->setEnabled(writable && at >= 0 && at + 1 < m_document.steps().size());
    m_list->setDragEnabled(writable);
    m_list->setEditTriggers(writable ? QAbstractItemView::DoubleClicked
                                           | QAbstractItemView::EditKeyPressed
                                     : QAbstractItemView::NoEditTriggers);
}

bool StepsPanel::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::KeyPress) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool alt = key->modifiers() == Qt::AltModifier;
        if (alt && (key->key() == Qt::Key_Up || key->key() == Qt::Key_Down)) {
            move(key->key() == Qt::Key_Up ? -1 : 1);
            return true;
        }
        if (key->key() == Qt::Key_Delete && m_remove->isEnabled()) {
            removeStep();
            return true;
        }
        if (key->key() == Qt::Key_F2) {
            renameStep();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void StepsPanel::retranslate()
{
    m_heading->setText(tr("Steps · %1").arg(m_list->count()));
    m_list->setAccessibleName(tr("Steps of the lab"));
    const auto count = static_cast<int>(m_errors.size());
    m_findingsHeading->setText(count == 0 ? tr("All files can be read")
                                          : tr("Findings · %1").arg(count));
    m_findings->setAccessibleName(tr("Findings in the lab's files"));
    nameButton(m_add, tr("Add a step"));
    nameButton(m_duplicate, tr("Duplicate the step"));
    nameButton(m_remove, tr("Remove the step"), tr("Delete"));
    nameButton(m_up, tr("Move the step up"), tr("Alt+Up"));
    nameButton(m_down, tr("Move the step down"), tr("Alt+Down"));
}

void StepsPanel::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange)
        showFindings();
}

} // namespace cradle
